// The server as it is reached from the page: requests with the token, and the stream of events.
import { ApiError, Disconnected } from "./api";
import type { Api, RasterData, RasterPart, Uploaded, UploadHow } from "./api";
import { splitLines } from "./lines";
import type { ErrorAnswer, Json, StudioEvent } from "./types";

const kTokenKey = "seamount.token";

/** The token comes in the fragment of the address, which is never sent; it is kept for this window alone, and taken out
 * of the address so that it is in no history and no picture of the screen. Null: opened without one. */
export function takeToken(location: Location, history: History, storage: Storage): string | null {
  const found = /(?:^#|[#&])(?:token=)?([0-9A-Za-z_-]{16,})$/.exec(location.hash);
  if (found?.[1]) {
    storage.setItem(kTokenKey, found[1]);
    history.replaceState(null, "", location.pathname + location.search);
  }
  return storage.getItem(kTokenKey);
}

async function refusal(response: Response): Promise<ApiError> {
  let answer: ErrorAnswer = { error: `The server answered ${response.status}` };
  try {
    const body: unknown = await response.json();
    if (
      body && typeof body === "object" && typeof (body as ErrorAnswer).error === "string"
    ) answer = body as ErrorAnswer;
  } catch {
    // Not the server's own words: what stands there already will do.
  }
  return new ApiError(response.status, answer);
}

function partQuery(part: RasterPart): string {
  const query = new URLSearchParams();
  for (const [name, value] of Object.entries(part)) if (value !== undefined) query.set(name, String(value));
  const text = query.toString();
  return text ? `?${text}` : "";
}

/** Reads "COLUMNS ROWS f32|u8|f32x2 [dry]" and the bytes that it describes. */
export function readRaster(header: string | null, bytes: ArrayBuffer): RasterData {
  const [columns, rows, type, dry] = (header ?? "").split(" ");
  const size = { columns: Number(columns), rows: Number(rows) };
  if (!(size.columns > 0) || !(size.rows > 0)) throw new Error("A raster came without its size");
  if (type === "u8") return { ...size, values: new Uint8Array(bytes) };
  if (dry !== "dry") return { ...size, values: new Float32Array(bytes) };
  const cells = size.columns * size.rows;
  return { ...size, values: new Float32Array(bytes, 0, cells), dry: new Uint8Array(bytes, 4 * cells, cells) };
}

/** Sends bytes by the one way that tells how many are sent. */
function send(path: string, token: string, content: Blob, how: UploadHow): Promise<{ status: number; text: string }> {
  return new Promise((done, fail) => {
    const request = new XMLHttpRequest();
    request.open("POST", path);
    request.setRequestHeader("Authorization", `Bearer ${token}`);
    request.setRequestHeader("Content-Type", "application/octet-stream");
    request.upload.onprogress = (event) => {
      if (event.lengthComputable && event.total > 0) how.progress?.(event.loaded / event.total);
    };
    request.onload = () => done({ status: request.status, text: request.responseText });
    request.onerror = request.onabort = () => fail(new Disconnected());
    how.signal?.addEventListener("abort", () => request.abort());
    request.send(content);
  });
}

export function createClient(token: string, origin = ""): Api {
  async function request(path: string, init: RequestInit = {}): Promise<Response> {
    let response: Response;
    try {
      const headers = { ...(init.headers as Record<string, string> | undefined), Authorization: `Bearer ${token}` };
      response = await fetch(origin + path, { ...init, headers, cache: init.cache ?? "no-store" });
    } catch {
      throw new Disconnected();
    }
    if (!response.ok) throw await refusal(response);
    return response;
  }
  const get = async <T>(path: string): Promise<T> => (await (await request(path)).json()) as T;
  const post = async <T>(path: string, body: unknown): Promise<T> => {
    const headers = { "Content-Type": "application/json" };
    const response = await request(path, { method: "POST", headers, body: JSON.stringify(body) });
    const text = await response.text();
    return (text ? JSON.parse(text) : undefined) as T;
  };
  const value = (key: string, form: string): string => `/api/values/${encodeURIComponent(key)}/${form}`;

  return {
    schema: () => get("/api/schema"),
    document: () => get("/api/document"),
    edits: (body) => post("/api/edits", body),
    undo: (window, base) => post("/api/undo", { window, base }),
    redo: (window, base) => post("/api/redo", { window, base }),
    text: (window, base, text) => post("/api/text", { window, base, text }),
    check: (text) => post("/api/check", { text }),
    want: (body) => post("/api/want", body),
    events: async (window, receive, signal) => {
      const response = await request(`/api/events?window=${encodeURIComponent(window)}`, { signal });
      if (response.body) await readEvents(response.body, receive);
    },
    raster: async (key, part = {}) => {
      // The page keeps whole rasters itself; to store them once more would only take time.
      const cache = part.x === undefined ? "no-store" : "force-cache";
      const response = await request(value(key, "raster") + partQuery(part), { cache });
      return readRaster(response.headers.get("X-Raster"), await response.arrayBuffer());
    },
    value: (key, form) => get<Json>(value(key, form)),
    picture: async (key) => (await request(value(key, "picture"), { cache: "force-cache" })).blob(),
    examples: async () => (await get<{ examples: [] }>("/api/examples")).examples,
    examplePicture: async (name) => {
      try {
        return await (await request(`/api/examples/${encodeURIComponent(name)}/picture`, { cache: "default" })).blob();
      } catch (error) {
        if (error instanceof ApiError && error.status === 404) return null;
        throw error;
      }
    },
    files: () => get("/api/files"),
    open: (body) => post("/api/open", body),
    save: (window, base, path) => post("/api/save", { window, base, ...(path === undefined ? {} : { path }) }),
    upload: async (name, content, how) => {
      const path = `${origin}/api/upload?name=${encodeURIComponent(name)}`;
      const { status, text } = await send(path, token, content, how ?? {});
      const answer = new Response(text, { status });
      if (!answer.ok) throw await refusal(answer);
      return answer.json() as Promise<Uploaded>;
    },
    download: async (path) => (await request(`/api/download?path=${encodeURIComponent(path)}`)).blob(),
    exportOutputs: (window, outputs, folder) => post("/api/export", { window, outputs, folder }),
    refresh: () => post("/api/refresh", {}),
    cancel: (job) => post("/api/cancel", job === undefined ? {} : { job }),
  };
}

async function readEvents(body: ReadableStream<Uint8Array>, receive: (event: StudioEvent) => void): Promise<void> {
  const reader = body.getReader();
  const lines = splitLines((line) => receive(JSON.parse(line) as StudioEvent));
  try {
    for (;;) {
      const { value, done } = await reader.read();
      if (done) return;
      lines(value);
    }
  } catch {
    throw new Disconnected();
  } finally {
    reader.cancel().catch(() => undefined);
  }
}
