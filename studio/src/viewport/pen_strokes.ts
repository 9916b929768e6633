// From gestures over a view to the active tool of the pen: where it is on the ground.
import type { Signal } from "@preact/signals";
import type { Strokes } from "./gestures";
import { groundPointer, type Under } from "./ground_pointer";
import type { GroundPointer, PenTarget } from "./types";

export class PenStrokes {
  private target: PenTarget | null = null;
  private stroke = false;

  /** `ended`: a stroke is drawn, or taken back. `aimed`: the pen is elsewhere, where it may look otherwise. */
  constructor(
    private readonly pointer: Signal<GroundPointer | null>, private readonly ended: () => void,
    private readonly aimed: () => void,
  ) {}

  get pen(): PenTarget | null {
    return this.target;
  }
  set pen(target: PenTarget | null) {
    this.target?.hover?.(null);
    this.target = target;
  }

  /** A stroke is being drawn. */
  get drawing(): boolean {
    return this.stroke;
  }

  /** Of a view that says what is under a pixel. */
  over(under: (event: MouseEvent) => Under | null): Strokes {
    const at = (event: MouseEvent): GroundPointer | null => {
      const place = under(event);
      return place === null ? null : groundPointer(event, place);
    };
    let last: GroundPointer | null = null;
    return {
      active: () => this.target !== null,
      down: (event) => {
        last = at(event);
        if (last === null || this.target === null) return false;
        this.pointer.value = last;
        this.stroke = true;
        this.target.down(last);
        this.aimed();
        return true;
      },
      move: (events) => {
        const path = events.map(at).filter((p): p is GroundPointer => p !== null);
        if (path.length === 0) return;
        this.pointer.value = last = path[path.length - 1]!;
        this.target?.move(path);
      },
      up: (event) => {
        // A lifted pen presses no more: the stroke ends as it was drawn.
        const place = at(event), pressure = last?.pressure ?? 1;
        if (place !== null) last = { ...place, pressure };
        if (last !== null) this.target?.up(last);
        this.end();
      },
      cancel: () => {
        this.target?.cancel();
        this.end();
      },
      hover: (event) => {
        this.pointer.value = event === null ? null : at(event);
        this.target?.hover?.(this.pointer.value);
        this.aimed();
      },
      double: (event) => {
        const place = at(event);
        if (place !== null) this.target?.double?.(place);
      },
    };
  }

  private end(): void {
    this.stroke = false;
    this.ended();
  }
}
