// A server in the page, for development pages and tests: it keeps a document, answers edits and pretends to compute.
// `await openStudio(new FakeServer())` is a studio like the real one.
import { ApiError, Disconnected } from "../api/api";
import type { Api, ExampleInfo, OpenRequest } from "../api/api";
import type {
  Change, DocumentAnswer, DocumentEvent, EditRequest, Frame, Json, Recipe, Schema, StudioEvent, ValueEvent, WantRequest,
} from "../api/types";
import { applyEdits, takeBackChanges, applyChanges } from "./apply";
import fakeRecipe from "./fake_recipe.json";
import fakeSchema from "./fake_schema.json";
import { fakeHeights, fakeLabels, fakeMask } from "./fake_terrain";
import { openStudio } from "./open_studio";
import type { OpenedStudio } from "./open_studio";
import { equalJson, NoSuchPlace } from "./pointer";

interface Done {
  gesture: string;
  label: string;
  window: string;
  changes: Change[];
}

const kCells = 256;

export class FakeServer implements Api {
  recipe: Recipe = structuredClone(fakeRecipe) as unknown as Recipe;
  revision = 1;
  file = "island.json";
  isSaved = true;
  history: Done[] = [];
  done = 0;
  log: DocumentEvent[] = [];
  requests: { what: string; body: unknown }[] = [];
  /** For tests: the server is gone; the next answer is lost on its way. */
  gone = false;
  loseAnswer = false;
  private listeners = new Map<string, { receive: (event: StudioEvent) => void; end: () => void }>();
  private values = new Map<string, { frame: Frame; values: Float32Array | Uint8Array }>();
  private wanted = new Set<string>();

  constructor(readonly delay_ms = 2) {}

  // ------------------------------------------------------------------------------------------------------ documents
  schema(): Promise<Schema> {
    return this.answer("schema", null, () => fakeSchema as unknown as Schema);
  }

  document(): Promise<DocumentAnswer> {
    return this.answer("document", null, () => this.documentAnswer());
  }

  edits(request: EditRequest): Promise<DocumentEvent> {
    return this.answer("edits", request, () => {
      this.checkBase(request.base);
      let next: Recipe;
      try {
        next = applyEdits(this.recipe, request.edits);
      } catch (error) {
        if (error instanceof NoSuchPlace) throw new ApiError(422, { error: error.message });
        throw error;
      }
      this.refuseUnknown(next);
      const change: Change = { pointer: "", index: 0, before: this.recipe as never, after: next as never };
      return this.take(next, [change], request.window, request.label, request.gesture);
    });
  }

  undo(window: string, base: number): Promise<DocumentEvent> {
    return this.answer("undo", { base }, () => {
      this.checkBase(base);
      const gesture = this.history[this.done - 1];
      if (!gesture) throw new ApiError(404, { error: "There is nothing to undo" });
      this.recipe = takeBackChanges(this.recipe, gesture.changes);
      this.done -= 1;
      const back = [...gesture.changes].reverse().map(({ before, after, ...place }) => (
        {
          ...place, ...(after === undefined ? {} : { before: after }),
          ...(before === undefined ? {} : { after: before }),
        }
      ));
      return this.tell(back, window, gesture.label);
    });
  }

  redo(window: string, base: number): Promise<DocumentEvent> {
    return this.answer("redo", { base }, () => {
      this.checkBase(base);
      const gesture = this.history[this.done];
      if (!gesture) throw new ApiError(404, { error: "There is nothing to do again" });
      this.recipe = applyChanges(this.recipe, gesture.changes);
      this.done += 1;
      return this.tell(gesture.changes, window, gesture.label);
    });
  }

  text(window: string, base: number, text: string): Promise<DocumentEvent> {
    return this.answer("text", { base, text }, () => {
      this.checkBase(base);
      const next = this.parse(text);
      const change: Change = { pointer: "", index: 0, before: this.recipe as never, after: next as never };
      return this.take(next, [change], window, "recipe text", "");
    });
  }

  check(text: string): ReturnType<Api["check"]> {
    return this.answer("check", { text }, () => {
      try {
        this.parse(text);
        return { diagnostics: [] };
      } catch (error) {
        return { diagnostics: (error as ApiError).answer.diagnostics ?? [] };
      }
    });
  }

  // -------------------------------------------------------------------------------------------------------- results
  want(request: WantRequest): Promise<void> {
    return this.answer("want", request, () => {
      this.wanted = new Set(request.sources);
      this.compute();
    });
  }

  events(window: string, receive: (event: StudioEvent) => void, signal: AbortSignal): Promise<void> {
    if (this.gone) return Promise.reject(new Disconnected());
    return new Promise((resolve) => {
      this.listeners.set(window, { receive, end: resolve });
      signal.addEventListener("abort", () => {
        this.listeners.delete(window);
        resolve();
      });
      receive({ event: "hello", version: "fake", revision: this.revision });
      receive({ event: "state", ...this.engineState() });
    });
  }

  raster(key: string, part: { level?: number } = {}): ReturnType<Api["raster"]> {
    return this.answer("raster", { key, part }, () => {
      const found = this.values.get(key);
      if (!found) throw new ApiError(404, { error: "The key is gone" });
      const step = 2 ** (part.level ?? 0);
      const columns = Math.ceil(found.frame.columns / step), rows = Math.ceil(found.frame.rows / step);
      const values = new (found.values.constructor as Float32ArrayConstructor)(columns * rows);
      for (let row = 0; row < rows; ++row) {
        for (let column = 0; column < columns; ++column) {
          values[row * columns + column] = found.values[row * step * found.frame.columns + column * step]!;
        }
      }
      return { columns, rows, values };
    });
  }

  value(): Promise<Json> {
    return this.answer("value", null, () => ({ type: "FeatureCollection", features: [] }));
  }

  picture(): Promise<Blob> {
    return this.answer("picture", null, () => new Blob([]));
  }

  // ---------------------------------------------------------------------------------------------------------- files
  examples(): Promise<ExampleInfo[]> {
    const example = (name: string, title: string, group: string): ExampleInfo => (
      { name, title, group, about: "What it shows, in a line or two of plain words." }
    );
    return this.answer("examples", null, () => [
      example("kauai", "Kauai with a reef", "Islands"), example("archipelago", "An archipelago", "Islands"),
      example("canyon", "A canyon from contours", "Contours"), example("alps", "Alps, worn", "Erosion"),
      example("strokes", "A range from strokes", "Sketches"), example("reef", "A barrier reef", "Reefs"),
    ]);
  }

  examplePicture(): Promise<Blob | null> {
    return this.answer("examplePicture", null, () => null);
  }

  files(): ReturnType<Api["files"]> {
    const modified = "2026-11-30T12:00:00Z";
    return this.answer("files", null, () => (
      {
        folder: "~/terrains",
        files: [{ path: "island.json", bytes: 2100, modified }, { path: "dem.tif", bytes: 9e6, modified }],
      }
    ));
  }

  open(request: OpenRequest): Promise<DocumentAnswer> {
    return this.answer("open", request, () => {
      this.file = "path" in request ? request.path : "";
      this.recipe = structuredClone(fakeRecipe) as unknown as Recipe;
      if ("blank" in request) this.recipe = {
        seamount: 1, domain: { width_m: request.width_m, height_m: request.height_m, cell_m: request.cell_m },
        steps: [],
      };
      this.revision += 1;
      this.history = [];
      this.done = 0;
      this.log = [];
      this.emit({ event: "opened", file: this.file });
      return this.documentAnswer();
    });
  }

  save(window: string, base: number, path?: string): Promise<DocumentEvent> {
    return this.answer("save", { path }, () => {
      this.checkBase(base);
      this.file = path ?? this.file;
      this.isSaved = true;
      const event: DocumentEvent = {
        event: "document", revision: this.revision, window, changes: [], label: "saved", done: this.done,
        undone: this.history.length - this.done, saved: true, missing: [],
      };
      this.emit(event);
      return event;
    });
  }

  upload(name: string, content: Blob): ReturnType<Api["upload"]> {
    const kind = /\.(tif|asc|hgt|exr)$/.test(name) ? "terrain" : /\.json$/.test(name) ? "recipe" : "drawing";
    return this.answer("upload", { name, size: content.size }, () => ({ file: `files/${name}`, kind, info: {} }));
  }

  download(): Promise<Blob> {
    return this.answer("download", null, () => new Blob(["fake"]));
  }

  exportOutputs(_window: string, outputs: { path: string }[]): Promise<{ job: string }> {
    return this.answer("export", outputs, () => {
      const base = { event: "job" as const, job: "job1", what: "export", message: "", files: [], notes: [] };
      for (let i = 0; i <= 10; ++i) {
        const files = i < 10 ? [] : outputs.map((output) => ({ path: `out/${output.path}`, bytes: 123456 }));
        const notes = i < 10 ? [] : ["Scale 100, 100, 215.4; Z location 12 000"];
        const state = i < 10 ? "running" as const : "done" as const;
        setTimeout(() => this.emit({ ...base, fraction: i / 10, state, files, notes }), i * 300);
      }
      return { job: "job1" };
    });
  }

  refresh(): Promise<void> {
    return this.answer("refresh", null, () => undefined);
  }

  cancel(): Promise<void> {
    return this.answer("cancel", null, () => undefined);
  }

  // ------------------------------------------------------------------------------------------------------ for tests
  /** The server dies; whoever listens is cut off. */
  die(): void {
    this.gone = true;
    for (const listener of [...this.listeners.values()]) listener.end();
    this.listeners.clear();
  }

  /** Another window's edit. */
  editFromElsewhere(edits: EditRequest["edits"], label = "elsewhere"): Promise<DocumentEvent> {
    return this.edits({ window: "other", base: this.revision, gesture: "", label, edits });
  }

  private documentAnswer(): DocumentAnswer {
    return {
      revision: this.revision, file: this.file, folder: "~/terrains", saved: this.isSaved,
      recipe: structuredClone(this.recipe), text: `${JSON.stringify(this.recipe, null, 2)}\n`,
      history: this.history.map(({ label, window }) => ({ label, window })), done: this.done, missing: [],
    };
  }

  private async answer<T>(what: string, body: unknown, make: () => T): Promise<T> {
    if (this.gone) throw new Disconnected();
    await new Promise((resolve) => setTimeout(resolve, this.delay_ms));
    if (this.gone) throw new Disconnected();
    this.requests.push({ what, body: structuredClone(body) });
    const answer = make();
    if (this.loseAnswer && what !== "want") {
      this.loseAnswer = false;
      throw new Disconnected();
    }
    return answer;
  }

  private emit(event: StudioEvent): void {
    for (const { receive } of this.listeners.values()) receive(structuredClone(event));
  }

  private checkBase(base: number): void {
    if (base === this.revision) return;
    const missed = this.log.filter((event) => event.revision > base);
    throw new ApiError(409, { error: "The document has changed", missed: structuredClone(missed) });
  }

  private parse(text: string): Recipe {
    const defect = (message: string, line: number, column: number): never => {
      throw new ApiError(422, { error: message, diagnostics: [{ pointer: "", message, line, column }] });
    };
    let value: unknown;
    try {
      value = JSON.parse(text);
    } catch (error) {
      return defect((error as Error).message, 1, 1);
    }
    this.refuseUnknown(value as Recipe);
    return value as Recipe;
  }

  private refuseUnknown(recipe: Recipe): void {
    recipe.steps.forEach((step, i) => {
      if (fakeSchema.operators.some((operator) => operator.name === step.op)) return;
      const message = `unknown operator '${step.op}'`;
      throw new ApiError(
        422, { error: message, diagnostics: [{ pointer: `/steps/${i}/op`, message, line: 1, column: 1 }] },
      );
    });
  }

  private take(next: Recipe, changes: Change[], window: string, label: string, gesture: string): DocumentEvent {
    if (sameRecipe(next, this.recipe)) {  // nothing changes, and the others need not know
      return {
        event: "document", revision: this.revision, window, changes: [], label, done: this.done,
        undone: this.history.length - this.done, saved: this.isSaved, missing: [],
      };
    }
    const last = this.history[this.done - 1];
    this.history = this.history.slice(0, this.done);
    if (gesture !== "" && last?.gesture === gesture && last.window === window) {
      this.history[this.done - 1] = { ...last, label, changes: [...last.changes, ...changes] };
    } else {
      this.history.push({ gesture, label, window, changes });
    }
    this.recipe = next;
    this.done = this.history.length;
    return this.tell(changes, window, label);
  }

  private tell(changes: Change[], window: string, label: string): DocumentEvent {
    this.revision += 1;
    this.isSaved = false;
    const undone = this.history.length - this.done;
    const event: DocumentEvent = {
      event: "document", revision: this.revision, window, changes: structuredClone(changes), label, done: this.done,
      undone, saved: false, missing: [],
    };
    this.log.push(event);
    this.emit(event);
    this.compute();
    return structuredClone(event);
  }

  private engineState(): Omit<Extract<StudioEvent, { event: "state" }>, "event"> {
    const steps = this.recipe.steps.map((step, i) => ({
      id: step.id, op: step.op, standing: step.bypass ? "bypassed" as const : "fresh" as const, fraction: 1,
      seconds: 0.01 * (i + 1) ** 2, cached: i === 0, message: "", notes: [],
    }));
    return { revision: this.revision, settled: true, coarse: false, fraction: 1, steps };
  }

  /** Results depend on the numbers of the document before and in their step, so that something changes with each. */
  private compute(): void {
    this.emit({ event: "state", ...this.engineState() });
    for (const source of this.wanted) {
      const value = this.make(source);
      if (value) this.emit(value);
    }
  }

  private make(source: string): ValueEvent | null {
    const [id, port] = source.split(".");
    const at = this.recipe.steps.findIndex((step) => step.id === id);
    const outputs = fakeSchema.operators.find((operator) => operator.name === this.recipe.steps[at]?.op)?.out ?? [];
    const kind = (outputs.find((output) => output.name === port) ?? (port ? undefined : outputs[0]))?.kind;
    if (!kind) return null;
    const content = JSON.stringify(
      [this.recipe.domain ?? {}, this.recipe.seed ?? 0, this.recipe.steps.slice(0, at + 1)],
    );
    const number = [...content].reduce((sum, letter) => (Math.imul(sum, 31) + letter.charCodeAt(0)) >>> 0, 7);
    const key = `${number.toString(16)}-${source}`;
    const event: ValueEvent = { event: "value", source, key, kind, revision: this.revision, coarse: false };
    if (!["terrain", "labels", "field"].includes(kind)) return event;
    const width = Number(this.recipe.domain?.["width_m"] ?? 24000);
    const frame = {
      columns: kCells, rows: kCells, cell_m: width / kCells, west: -width / 2, north: width / 2, crs: "",
    };
    const peak = Number(
      this.recipe.steps.find((step) => step.params?.["peak_m"])?.params?.["peak_m"] ?? 900,
    ) * (1 - 0.04 * at);
    const heights = fakeHeights(frame, (this.recipe.seed ?? 0) % 1000, peak);
    const values = kind === "terrain" ? heights : kind === "labels" ? fakeLabels(heights) : fakeMask(heights, peak);
    this.values.set(key, { frame, values });
    return {
      ...event, frame, min: kind === "terrain" ? Math.min(...heights) : 0,
      max: kind === "terrain" ? Math.max(...heights) : 1,
    };
  }
}

/** A studio without a server. */
export async function fakeStudio(): Promise<OpenedStudio> {
  return openStudio(new FakeServer());
}

export function sameRecipe(a: Recipe, b: Recipe): boolean {
  return equalJson(a as never, b as never);
}
