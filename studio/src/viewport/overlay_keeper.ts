// Fetches of what is laid over the ground (labels, fields) the same window that a view has of the ground: one request
// at a time, after the ground's, and only where the whole of it is there more coarsely than the window.
// A cell takes 13 bytes at most, of windows as large as the ground's: 36 MB in software and 126 MB else for both views.
import type { Api } from "../api/api";
import type { Frame } from "../api/types";
import type { DetailGround } from "./detail_ground";
import { frameOfWindow, sameWindow, sourceOf, type Source, type Window } from "./detail_window";
import type { Raster } from "./types";

/** A window of an overlay; its colours are those of the whole. */
export interface OverlayWindow {
  raster: Raster;
  window: Window;
}

export interface OverlaidView {
  readonly detail: DetailGround | null;
  overlayDetail: OverlayWindow | null;
}

export class OverlayKeeper {
  private whole: { raster: Raster; source: Source } | null = null;
  private fetching = false;

  constructor(
    private readonly api: Pick<Api, "raster">, private readonly view: OverlaidView, private readonly came: () => void,
  ) {}

  /** A request is on its way. */
  get busy(): boolean {
    return this.fetching;
  }

  /** Something else is laid over the ground. `frame`: that it is computed in. */
  follow(raster: Raster | null, frame: Frame | null): void {
    this.whole = raster === null || frame === null ? null : { raster, source: sourceOf(raster, frame) };
    this.view.overlayDetail = null;
    void this.seek();
  }

  /** Fetches what belongs to the window of ground that the view has now, if that is not there. */
  async seek(): Promise<void> {
    if (this.fetching) return;
    this.fetching = true;
    for (let window = this.wanted(); window !== null; window = this.wanted()) {
      const whole = this.whole!, { level, x, y, columns, rows } = window;
      try {
        const { values } = await this.api.raster(whole.source.key, { level, x, y, columns, rows });
        if (this.whole !== whole) continue;
        const frame = frameOfWindow(whole.source, window), { key, coarse, min, max } = whole.raster;
        this.view.overlayDetail = { window, raster: { key, frame, values, coarse, min, max } };
        this.came();
      } catch {
        break;  // that result is gone: a newer one is announced
      }
    }
    this.fetching = false;
  }

  dispose(): void {
    this.follow(null, null);
  }

  /** Null: it is there, or the whole is as fine, or lies on other cells than the ground. */
  private wanted(): Window | null {
    const { whole, view: { detail, overlayDetail } } = this;
    if (whole === null || detail === null || detail.window.level >= whole.source.level) return null;
    if (overlayDetail !== null && sameWindow(detail.window, overlayDetail.window)) return null;
    const here = frameOfWindow(whole.source, detail.window), there = detail.field.frame;
    const same = (a: number, b: number): boolean => Math.abs(a - b) < 1e-3 * there.cell_m;
    return same(here.west, there.west) && same(here.north, there.north) && same(here.cell_m, there.cell_m)
      ? detail.window
      : null;
  }
}
