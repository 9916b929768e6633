// What the engine has computed of the sources that this window wants, and the rasters that were fetched of them.
import { signal } from "@preact/signals";
import { ApiError, Disconnected } from "../api/api";
import type { Api, RasterPart, ValueForm } from "../api/api";
import type { EngineState, Frame, Json, ValueEvent } from "../api/types";
import type { Raster } from "../viewport/types";

const kCacheBytes = 192 * 1024 * 1024;

/** Every 2^level-th cell, the first one included: its middle stays where it is. */
export function frameOfLevel(frame: Frame, level: number, columns: number, rows: number): Frame {
  const cell_m = frame.cell_m * 2 ** level;
  const shift = (cell_m - frame.cell_m) / 2;
  return { ...frame, columns, rows, cell_m, west: frame.west - shift, north: frame.north + shift };
}

/** About as much memory as a value takes: scenes of many objects are large. */
export function jsonBytes(value: Json): number {
  if (typeof value === "string") return 24 + 2 * value.length;
  if (value === null || typeof value !== "object") return 8;
  let sum = 32;
  for (const item of Object.values(value)) sum += 8 + jsonBytes(item);
  return sum;
}

/** The newest promises by key, up to so many bytes. */
class PromiseCache<T> {
  private entries = new Map<string, { value: Promise<T>; bytes: number }>();
  private bytes = 0;

  constructor(private size: (value: T) => number) {}

  get(key: string, make: () => Promise<T>): Promise<T> {
    const found = this.entries.get(key);
    if (found) {
      this.entries.delete(key);
      this.entries.set(key, found);
      return found.value;
    }
    const entry = { value: make(), bytes: 0 };
    this.entries.set(key, entry);
    entry.value.then(
      (value) => {
        entry.bytes = this.size(value);
        if (this.entries.get(key) === entry) this.bytes += entry.bytes;
        this.trim(key);
      },
      () => this.drop(key),
    );
    return entry.value;
  }

  private drop(key: string): void {
    this.bytes -= this.entries.get(key)?.bytes ?? 0;
    this.entries.delete(key);
  }

  private trim(newest: string): void {
    for (const key of this.entries.keys()) {
      if (this.bytes <= kCacheBytes) return;
      if (key !== newest) this.drop(key);
    }
  }
}

const kRasters: readonly string[] = ["terrain", "labels", "field", "current"];

/** Whether results of a kind are rasters; contours and networks have a frame and are none. */
export function isRaster(kind: string): boolean {
  return kRasters.includes(kind);
}

/** The engine's progress is shown so often; what settles is shown at once. */
const kStateEvery_ms = 120;

export class Results {
  readonly engine = signal<EngineState>({ revision: 0, settled: true, coarse: false, fraction: 1, steps: [] });
  readonly values = signal<ReadonlyMap<string, ValueEvent>>(new Map());
  private rasters = new PromiseCache<Raster>((raster) => raster.values.byteLength + (raster.dry?.byteLength ?? 0));
  private contents = new PromiseCache<Json>(jsonBytes);
  private wants = new Map<string, readonly string[]>();
  private asked = "";
  private asking = false;
  private nextState: EngineState | null = null;
  private stateShown = 0;
  private stateTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(private api: Api, private window: string) {}

  state(next: EngineState): void {
    this.nextState = next;
    const wait = this.stateShown + kStateEvery_ms - performance.now();
    if (wait <= 0 || next.settled !== this.engine.value.settled) this.showState();
    else this.stateTimer ??= setTimeout(() => this.showState(), wait);
  }

  receive(event: ValueEvent): void {
    this.values.value = new Map(this.values.value).set(event.source, event);
  }

  gone(source: string): void {
    const left = new Map(this.values.value);
    if (left.delete(source)) this.values.value = left;
  }

  clear(): void {
    this.values.value = new Map();
    this.asked = "";
  }

  /** Sources that somebody wants; the first who asked come first. */
  want(who: string, sources: readonly string[]): void {
    if (sources.length === 0) this.wants.delete(who);
    else this.wants.set(who, [...sources]);
    void this.ask();
  }

  /** The server forgets what a window wants when its stream ends. */
  askAgain(): void {
    this.asked = "";
    void this.ask();
  }

  async raster(source: string, level = 0): Promise<Raster | null> {
    const value = this.values.value.get(source);
    const frame = value?.frame;
    if (!value || !frame || !isRaster(value.kind)) return null;
    try {
      return await this.rasters.get(`${value.key}/${level}`, async () => {
        const part: RasterPart = { ...(level === 0 ? {} : { level }), ...(value.kind === "terrain" ? { dry: 1 } : {}) };
        const { columns, rows, values, dry } = await this.api.raster(value.key, part);
        const range = { min: value.min ?? 0, max: value.max ?? 0 };
        return {
          key: value.key, frame: frameOfLevel(frame, level, columns, rows), values, coarse: value.coarse, ...range,
          ...(dry === undefined ? {} : { dry }),
        };
      });
    } catch (error) {
      return nothing(error);
    }
  }

  async content(source: string, form: ValueForm): Promise<Json | null> {
    const value = this.values.value.get(source);
    if (!value) return null;
    try {
      return await this.contents.get(`${value.key}/${form}`, () => this.api.value(value.key, form));
    } catch (error) {
      return nothing(error);
    }
  }

  private showState(): void {
    clearTimeout(this.stateTimer);
    this.stateTimer = undefined;
    this.stateShown = performance.now();
    if (this.nextState) this.engine.value = this.nextState;
  }

  /** One request at a time, with what is wanted by then. */
  private async ask(): Promise<void> {
    if (this.asking) return;
    this.asking = true;
    await Promise.resolve();  // what is asked for in one go is one request
    for (;;) {
      const sources = [...new Set([...this.wants.values()].flat())];
      const asked = JSON.stringify(sources);
      if (asked === this.asked) break;
      this.asked = asked;
      try {
        await this.api.want({ window: this.window, sources, quality: "coarse_then_full" });
      } catch {
        this.asked = "";
        break;  // asked again when the stream is there again
      }
    }
    this.asking = false;
  }
}

/** The key was overtaken, or the server is gone: a newer value will come. */
function nothing(error: unknown): null {
  if (error instanceof ApiError || error instanceof Disconnected) return null;
  throw error;
}
