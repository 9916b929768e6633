// Shapes the outlines of an island with a soft brush: press on one and drag it out or in; Shift smooths it. Where none
// is drawn yet, the coast that the island has is taken up, or a circle begins.
import type { Json } from "../../api/types";
import type { GroundPointer, OverlayShape } from "../../viewport/types";
import { pointOf, type Desk, type Pen, type PenKey } from "../desk";
import { tolerance } from "../fit";
import type { Gesture } from "../gesture";
import { distance, roundingStep, type Point } from "../geometry";
import { isPoint } from "../features";
import { lookOf } from "../names";
import { paramPlace } from "../place";
import {
  coastOf, dragOutline, nearestOutline, readOutlines, ringOf, roleOfOutline, writeOutlines, type Radii,
} from "../polar";
import { formatLength } from "./line_pen";

/** What an island's outlines and their centre are, as a step says. */
export function outlinesOf(desk: Pick<Desk, "recipe">, step: string, path: readonly (string | number)[]) {
  const found = paramPlace(desk.recipe(), step, path);
  const centre = paramPlace(desk.recipe(), step, [...path.slice(0, -1), "centre"]).value;
  return {
    pointer: found.pointer, outlines: readOutlines(found.value), centre: (isPoint(centre) ? centre : [0, 0]) as Point,
  };
}

export class PolarPen implements Pen {
  readonly cursor = "crosshair" as const;
  private gesture: Gesture | null = null;
  private before: Radii[] = [];
  private outlines: Radii[] = [];
  private pointer = "";
  private centre: Point = [0, 0];
  private from: GroundPointer | null = null;
  private outline = 0;
  /** The coast of the island as it is, to begin with. */
  private coast: number[] | null = null;

  constructor(private readonly desk: Desk) {
    void this.lookAtCoast();
  }

  private read() {
    return outlinesOf(this.desk, this.desk.step()!, this.desk.offer.slot!.parts[0]!.path);
  }

  private async lookAtCoast(): Promise<void> {
    const step = this.desk.step();
    if (step === null || this.read().outlines.length > 0) return;
    this.desk.studio.want("pen", [`${step}.labels`]);
    const labels = await this.desk.studio.raster(`${step}.labels`).catch(() => null);
    if (labels) this.coast = coastOf(labels, this.read().centre, roundingStep(labels.frame.cell_m));
    if (this.coast) this.desk.draw(this.shapes());
  }

  private shapes(): OverlayShape[] {
    if (!this.coast || this.read().outlines.length > 0) return [];
    return [
      { shape: "line", points: ringOf(this.coast, this.read().centre), closed: true, role: "guide", width_px: 1.5 },
    ];
  }

  down(at: GroundPointer): void {
    const { pointer, outlines, centre } = this.read();
    this.pointer = pointer;
    this.centre = centre;
    const start = outlines.length > 0 ? outlines : [this.coast ?? [distance(pointOf(at), centre)]];
    this.outlines = this.before = start;
    this.outline = nearestOutline(start, pointOf(at), centre);
    this.from = at;
    this.gesture = this.desk.begin(lookOf(this.desk.offer.slot!).done);
  }

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    if (!this.gesture || !this.from || !at) return;
    const step = roundingStep(tolerance(this.desk.fitting(at)));
    const drag = {
      outline: this.outline, to: pointOf(at), centre: this.centre, radius_m: this.desk.reach(), smooth: at.shift, step,
    };
    // Smoothing goes on from where it is, dragging from where the hand took hold.
    const base = at.shift ? this.outlines : this.before;
    const from = at.shift ? pointOf(at) : pointOf(this.from);
    this.outlines = dragOutline(base, { ...drag, from });
    if (at.shift) this.before = this.outlines;
    const value = writeOutlines(this.outlines) as Json;
    this.gesture.live(() => [{ do: "set", pointer: this.pointer, value }]);
    this.desk.say(formatLength(distance(pointOf(at), this.centre)));
    this.desk.draw(this.brush(at));
  }

  up(): void {
    const { gesture } = this;
    if (!gesture) return;
    this.gesture = this.from = null;
    void gesture.finish();
    this.desk.say("");
    this.desk.end();
  }

  cancel(): void {
    const { gesture } = this;
    if (!gesture) return;
    this.gesture = this.from = null;
    void gesture.cancel();
    this.desk.say("");
    this.desk.end();
  }

  leave(): void {
    this.cancel();
    this.desk.studio.want("pen", []);
    this.desk.draw([]);
  }

  key({ key }: PenKey): boolean {
    if (key !== "Escape" || !this.gesture) return false;
    this.cancel();
    return true;
  }

  hover(at: GroundPointer | null): void {
    this.desk.draw(at ? [...this.shapes(), ...this.brush(at)] : this.shapes());
  }

  /** The brush, and the line from the centre along which an outline moves. */
  private brush(at: GroundPointer): OverlayShape[] {
    const { outlines, centre } = this.read();
    const count = outlines.length || 1;
    const index = this.gesture ? this.outline
      : nearestOutline(outlines.length > 0 ? outlines : [this.coast ?? [0]], pointOf(at), centre);
    return [
      { shape: "circle", at: pointOf(at), radius_m: this.desk.reach(), role: roleOfOutline(index, count) },
      { shape: "line", points: [centre, pointOf(at)], role: "guide", width_px: 1 },
    ];
  }
}
