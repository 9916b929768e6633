// Draws areas: a lasso in one go, or corner by corner with clicks. Where a click alone selects by place, it does.
import type { Edit, Json } from "../../api/types";
import type { GroundPointer, OverlayShape } from "../../viewport/types";
import { Drawing, pointOf, withIteration, type Desk, type Pen, type PenKey } from "../desk";
import type { Feature } from "../features";
import { fitRing, tolerance, type Sample } from "../fit";
import { distance, insideRing, ringArea, roundedPoint, roundingStep, simpleRing, type Point } from "../geometry";
import { lookOf } from "../names";
import { kReach_px } from "../hit";
import { below } from "../place";
import { formatLength, kClick_px } from "./line_pen";
import type { Slot } from "../slots";

function formatArea(square_m: number): string {
  return square_m >= 1e6 ? `${(square_m / 1e6).toFixed(2)} km²` : `${Math.round(square_m)} m²`;
}

export class RingPen implements Pen {
  readonly cursor = "crosshair" as const;
  private samples: Sample[] = [];
  private corners: Point[] = [];
  private start: GroundPointer | null = null;
  private free = false;
  private readonly slot: Slot;

  constructor(private readonly desk: Desk) {
    this.slot = desk.offer.slot!;
  }

  down(at: GroundPointer): void {
    this.start = at;
    this.free = false;
    this.samples = [{ x: at.x, y: at.y, pressure: 1 }];
  }

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    if (!at || !this.start) return;
    for (const { x, y } of path) this.samples.push({ x, y, pressure: 1 });
    this.free ||= distance(pointOf(at), pointOf(this.start)) > kClick_px * at.pixel_m;
    if (this.free) this.show([...this.corners, ...this.samples.map((s): Point => [s.x, s.y])]);
  }

  up(at: GroundPointer): void {
    const start = this.start;
    this.start = null;
    if (!start) return;
    if (!this.free) return this.click(at);
    const corners = this.corners.map(([x, y]) => ({ x, y, pressure: 1 }));
    void this.complete(fitRing([...corners, ...this.samples], this.desk.fitting(at)), start);
  }

  private click(at: GroundPointer): void {
    const place = pointOf(at);
    if (this.slot.click && this.corners.length === 0 && !at.alt) return this.choosePlace(at);
    const near = (other: Point | undefined, pixels: number) => other && distance(other, place) < pixels * at.pixel_m;
    const closes = near(this.corners[0], kReach_px) || near(this.corners[this.corners.length - 1], kClick_px);
    if (this.corners.length > 2 && closes) return this.close(at);
    if (near(this.corners[this.corners.length - 1], kClick_px)) return;
    this.corners.push(roundedPoint(place, roundingStep(tolerance(this.desk.fitting(at)))));
    this.show(this.corners);
    this.desk.say("click on; Enter or the first point closes");
  }

  private choosePlace(at: GroundPointer): void {
    const place = roundedPoint(pointOf(at), roundingStep(tolerance(this.desk.fitting(at))));
    const drawing = new Drawing(this.desk, this.slot, this.slot.click!, lookOf(this.slot).done);
    const item = { [this.slot.click!.path.join("/")]: [[...place]] as Json };
    void drawing.finish([place], { ...this.members(), ...item });
    this.reset();
  }

  private members(): { [name: string]: Json } {
    return withIteration(this.desk, this.slot, this.desk.members(this.slot));
  }

  private close(at: GroundPointer | null): void {
    void this.complete(simpleRing(this.corners), at);
  }

  private async complete(ring: Point[], at: GroundPointer | null): Promise<void> {
    this.reset();
    if (ring.length < 3) return;
    const around = at?.ctrl ? this.areaAround(ring[0]!) : undefined;
    if (around) return this.makeHole(around, ring);
    await new Drawing(this.desk, this.slot, this.slot.parts[0]!, lookOf(this.slot).done).finish(ring, this.members());
  }

  private areaAround(at: Point): Feature | undefined {
    const areas = this.desk.features().filter((f) => f.part.as === "polygons" && !f.hole && f.slot.id === this.slot.id);
    return areas.find((area) => insideRing(at, area.points));
  }

  private async makeHole(area: Feature, ring: Point[]): Promise<void> {
    const pointer = area.key.replace(/\/outer$/, "");
    const recipe = this.desk.recipe();
    const held = below(recipe, { pointer, value: area.whole.value }, ["holes"]).value;
    const holes = [...(Array.isArray(held) ? held : []), ring.map(([x, y]) => [x, y])];
    const edits = (): Edit[] => [{ do: "set", pointer, value: { outer: area.points.map(([x, y]) => [x, y]), holes } }];
    await this.desk.begin("hole drawn").finish(edits);
    this.desk.end();
  }

  private reset(): void {
    this.samples = [];
    this.corners = [];
    this.start = null;
    this.free = false;
    this.desk.draw([]);
    this.desk.say("");
  }

  double(at: GroundPointer): void {
    if (this.corners.length > 2) this.close(at);
  }

  cancel(): void {
    this.reset();
  }

  leave(): void {
    if (this.corners.length > 2) this.close(null);
    else this.reset();
  }

  key({ key }: PenKey): boolean {
    if (this.corners.length === 0 && !this.start) return false;
    if (key === "Escape") this.reset();
    else if (key === "Enter") this.leave();
    else if (key === "Backspace" || key === "Delete") this.show((this.corners = this.corners.slice(0, -1)));
    else return false;
    return true;
  }

  hover(at: GroundPointer | null): void {
    if (this.start || this.corners.length === 0) return;
    this.show(at ? [...this.corners, pointOf(at)] : this.corners);
  }

  private show(points: readonly Point[]): void {
    const { role } = lookOf(this.slot);
    const shapes: OverlayShape[] = [];
    if (points.length > 2) shapes.push({ shape: "area", points, role });
    if (points.length > 1) shapes.push({ shape: "line", points, role, width_px: 2, closed: points.length > 2 });
    if (this.corners[0]) shapes.push({ shape: "dot", at: this.corners[0], role, handle: true });
    this.desk.draw(shapes);
    if (points.length > 2) this.desk.say(formatArea(Math.abs(ringArea(points))));
    else if (points.length === 2) this.desk.say(formatLength(distance(points[0]!, points[1]!)));
  }
}
