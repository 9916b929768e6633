// Fetches the newest result of a source whenever there is one: one request at a time, what is overtaken is dropped.
import { effect } from "@preact/signals";
import type { ValueEvent } from "../api/types";
import type { Shown, Studio } from "../document/studio";
import { isRaster } from "../document/results";
import type { Raster } from "./types";

/** Rasters are fetched so coarsely that they have at most so many cells a side. */
export function mostCells(software: boolean): number {
  return software ? 2048 : 4096;
}

export function levelFor(columns: number, rows: number, most: number): number {
  let level = 0;
  while (Math.ceil(Math.max(columns, rows) / 2 ** level) > most) ++level;
  return level;
}

export class Follower {
  private readonly stop: () => void;
  private wanted: ValueEvent | null = null;
  private gotKey = "";
  private gotSource = "";
  private busy = false;
  private gone = false;

  constructor(
    private readonly studio: Studio,
    private readonly which: (shown: Shown) => string | null,
    private readonly got: (raster: Raster | null, value: ValueEvent | null) => void,
    private readonly most: number = mostCells(true),
  ) {
    this.stop = effect(() => {
      const source = this.which(studio.shown.value);
      const value = source === null ? undefined : studio.values.value.get(source);
      if (source === null) {
        this.wanted = null;
        if (this.gotKey !== "") {
          this.gotKey = "";
          this.got(null, null);
        }
        return;
      }
      if (value === undefined || value.key === this.gotKey) return;
      if (this.overtaken(value)) return;
      this.wanted = value;
      void this.fetch();
    });
  }

  /** A newer one of what is seen already will come: to draw it would only delay that. */
  private overtaken(value: ValueEvent): boolean {
    return value.source === this.gotSource && this.studio.overtaken(value.revision);
  }

  /** Something that is no raster is laid there: what was there before is not any more. */
  private none(value: ValueEvent): void {
    if (this.gotKey === "" || this.which(this.studio.shown.peek()) !== value.source) return;
    this.gotKey = "";
    this.got(null, null);
  }

  dispose(): void {
    this.gone = true;
    this.stop();
  }

  private async fetch(): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    while (this.wanted !== null && !this.gone) {
      const value = this.wanted;
      this.wanted = null;
      if (value.frame === undefined || !isRaster(value.kind)) {
        this.none(value);
        continue;
      }
      try {
        const raster = await this.studio.raster(
          value.source, levelFor(value.frame.columns, value.frame.rows, this.most),
        );
        if (raster === null || this.gone || this.which(this.studio.shown.peek()) !== value.source) continue;
        if (this.overtaken(value)) continue;
        this.gotKey = value.key;
        this.gotSource = value.source;
        this.got(raster, value);
      } catch {
        // The result is gone: a newer one is announced.
      }
    }
    this.busy = false;
  }
}
