// Fetches the window of finer ground that a view needs: one request at a time, the newest wish wins, and what belongs
// to another result is dropped.
import type { Api } from "../api/api";
import { DetailGround } from "./detail_ground";
import { sameWindow, type Source, type Window } from "./detail_window";
import type { HeightField } from "./heights";

/** Windows have at most so many cells a side; the map's may be longer and narrower. Of a window there are the heights
 * twice and, per cell, 11 bytes of gradients and, in 3D, 9 of colours: 62 MB in
 * software and 225 MB else for both views; two bytes a cell more where ground below the sea is dry. */
export function mostDetailCells(view: "map" | "world", software: boolean): number {
  return view === "map" ? (software ? 1280 : 2304) : software ? 1024 : 2048;
}

/** A view that shows a part of the ground finely. */
export interface DetailView {
  detail: DetailGround | null;
  readonly surface: { readonly shown: boolean };
  window(source: Source, most: number): Window | null;
}

export class DetailKeeper {
  private coarse: HeightField | null = null;
  private source: Source | null = null;
  private wanted: Window | null = null;
  private fetching = false;

  constructor(
    private readonly api: Api, private readonly view: DetailView, private readonly most: number,
    private readonly came: () => void,
  ) {}

  /** A request is on its way. */
  get busy(): boolean {
    return this.fetching;
  }

  /** Another result is shown. */
  follow(coarse: HeightField | null, source: Source | null): void {
    this.coarse = coarse;
    this.source = source;
    this.wanted = null;
    this.view.detail = null;
  }

  /** Fetches what the view needs now, if that is not there. */
  seek(): void {
    if (this.source === null || !this.view.surface.shown) return;
    this.wanted = this.view.window(this.source, this.most);
    if (this.wanted === null && this.view.detail !== null) {
      this.view.detail = null;
      this.came();
    }
    void this.fetch();
  }

  dispose(): void {
    this.follow(null, null);
  }

  private get has(): Window | null {
    return this.view.detail?.window ?? null;
  }

  private async fetch(): Promise<void> {
    if (this.fetching) return;
    this.fetching = true;
    while (this.wanted !== null && this.source !== null && this.coarse !== null && !sameWindow(this.wanted, this.has)) {
      const { wanted: window, source, coarse } = this, { level, x, y, columns, rows } = window;
      try {
        const { values, dry } = await this.api.raster(source.key, { level, x, y, columns, rows, dry: 1 });
        // Where the view moves on it is better than nothing, where it came back it is not.
        if (this.source !== source || this.wanted === null || sameWindow(this.wanted, this.has)) continue;
        this.view.detail = new DetailGround(coarse, source, window, values, dry);
        this.came();
      } catch {
        // The result is gone: a newer one is announced. Or the server is: the page says so elsewhere.
        if (this.wanted === window) this.wanted = null;
      }
    }
    this.fetching = false;
  }
}
