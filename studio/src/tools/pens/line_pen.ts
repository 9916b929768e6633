// Draws lines: in one go, or point by point with clicks; and with a brush, by the pen's pressure.
import type { Json } from "../../api/types";
import type { GroundPointer, OverlayShape } from "../../viewport/types";
import { Drawing, pointOf, siblingSlot, withIteration, type Desk, type Pen, type PenKey } from "../desk";
import { fitLine, fitStroke, tolerance, type Sample } from "../fit";
import { distance, lengthOf, roundedPoint, roundingStep, type Point } from "../geometry";
import { lookOf } from "../names";
import { classesFor, skeletonOf } from "../objects";
import type { Slot } from "../slots";

/** Further than this, in pixels, a press is a stroke and no click. */
export const kClick_px = 4;

const kInverse: { [tool: string]: string } = { raise: "lower", lower: "raise", brush: "erase", region: "erase", sink: "erase" };

/** A click alone is a thing already: a dab, an object at a place. */
function aloneIsEnough(desk: Desk, slot: Slot): boolean {
  if (slot.tool !== "add") return slot.brush || slot.tool === "slope";
  return skeletonOf(classesFor(desk.studio, desk.step(), slot), desk.members(slot)["class"]) === "point";
}

export class LinePen implements Pen {
  readonly cursor = "crosshair" as const;
  private samples: Sample[] = [];
  private clicked: Point[] = [];
  private drawing: Drawing | null = null;
  private start: GroundPointer | null = null;
  private free = false;
  private slot: Slot;
  private invert = false;

  constructor(private readonly desk: Desk) {
    this.slot = desk.offer.slot!;
  }

  /** The slot and the sign that the modifiers ask for. */
  private take(at: GroundPointer): void {
    const own = this.desk.offer.slot!;
    const wanted = at.shift ? "smooth" : at.ctrl && own.tool ? kInverse[own.tool] : undefined;
    this.slot = (own.brush && wanted && siblingSlot(this.desk, own, wanted)) || own;
    this.invert = at.ctrl && this.slot === own;
  }

  private members(): { [name: string]: Json } {
    const members = { ...withIteration(this.desk, this.slot, this.desk.members(this.slot)) };
    for (const name of ["strength_m", "strength", "speed_m_s"]) {
      const least = this.slot.members.find((member) => member.name === name)?.min ?? -Infinity;
      if (this.invert && typeof members[name] === "number" && least < 0) members[name] = -members[name];
    }
    if (!this.slot.brush || !this.slot.parts[0]) return members;
    const fitted = this.fitted;
    const pressure = fitted.map((s) => s.pressure);
    return pressure.some((p) => p < 0.995) && this.takesPressure() ? { ...members, pressure } : members;
  }

  private takesPressure(): boolean {
    const params = this.desk.studio.operator(this.slot.op)?.params ?? [];
    const list = params.find((param) => param.name === this.slot.list?.[0]);
    return list?.tools?.find((tool) => tool.name === this.slot.tool)?.params.some((p) => p.name === "pressure") ?? false;
  }

  private fitted: Sample[] = [];

  private points(at: GroundPointer): Point[] {
    const options = this.desk.fitting(at);
    if (this.slot.brush) {
      this.fitted = fitStroke(this.samples, options);
      return this.fitted.map((s): Point => [s.x, s.y]);
    }
    const step = roundingStep(tolerance(options));
    const fresh = this.free ? fitLine(this.samples, options) : [];
    return [...this.clicked.map((p) => roundedPoint(p, step)), ...fresh];
  }

  down(at: GroundPointer): void {
    if (!this.drawing) this.take(at);
    this.start = at;
    this.free = false;
    this.samples = [{ x: at.x, y: at.y, pressure: at.pressure }];
    if (this.slot.brush) this.preview(at);
  }

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    if (!at || !this.start) return;
    for (const { x, y, pressure } of path) this.samples.push({ x, y, pressure });
    this.free ||= distance(pointOf(at), pointOf(this.start)) > kClick_px * at.pixel_m;
    if (this.free || this.slot.brush) this.preview(at);
  }

  private preview(at: GroundPointer): void {
    const points = this.points(at);
    this.show(at, points);
    const enough = this.slot.brush || (points.length > 1 && lengthOf(points) > 16 * at.pixel_m);
    if (enough) this.begin().live(points, this.members());
  }

  private begin(): Drawing {
    this.drawing ??= new Drawing(this.desk, this.slot, this.slot.parts[0]!, lookOf(this.slot).done);
    return this.drawing;
  }

  up(at: GroundPointer): void {
    if (!this.start) return;
    this.start = null;
    if (this.slot.brush) return this.complete(at);
    if (!this.free) return this.click(at);
    const points = this.points(at);
    if (this.clicked.length > 0) {
      this.clicked = points;
      this.samples = [];
      this.free = false;
      return this.preview(at);
    }
    this.complete(at);
  }

  private click(at: GroundPointer): void {
    const place = pointOf(at);
    const end = this.clicked[this.clicked.length - 1];
    if (end && distance(end, place) < kClick_px * at.pixel_m) return this.complete(at);
    this.clicked.push(place);
    if (aloneIsEnough(this.desk, this.slot) && this.clicked.length === 1) return this.complete(at);
    this.preview(at);
    this.desk.say("click on, Enter ends, Backspace takes a point back");
  }

  private complete(at: GroundPointer | null): void {
    const points = at ? this.points(at) : this.lastPoints;
    const members = this.members();
    const enough = points.length > (aloneIsEnough(this.desk, this.slot) ? 0 : 1);
    const drawing = enough ? this.begin() : this.drawing;
    this.reset();  // before the end, which may take this pen away
    if (enough) void drawing!.finish(points, members);
    else drawing?.cancel();
  }

  private lastPoints: Point[] = [];

  private reset(): void {
    this.samples = [];
    this.clicked = [];
    this.drawing = null;
    this.start = null;
    this.free = false;
    this.desk.draw([]);
    this.desk.say("");
  }

  double(): void {
    if (this.clicked.length > 0) this.complete(null);
  }

  cancel(): void {
    const { drawing } = this;
    this.reset();
    drawing?.cancel();
  }

  leave(): void {
    if (this.clicked.length > 1) this.complete(null);
    else this.cancel();
  }

  key({ key }: PenKey): boolean {
    const busy = this.clicked.length > 0 || this.start !== null;
    if (!busy) return false;
    if (key === "Escape") this.cancel();
    else if (key === "Enter") this.complete(null);
    else if ((key === "Backspace" || key === "Delete") && this.clicked.length > 1) {
      this.clicked.pop();
      this.lastPoints = this.clicked;
      this.desk.draw(this.ink(this.clicked));
      if (this.clicked.length > 1) this.drawing?.live(this.clicked, this.members());
    } else return key === "Backspace" || key === "Delete";
    return true;
  }

  hover(at: GroundPointer | null): void {
    if (this.start) return;
    if (!at) return this.desk.draw(this.ink(this.clicked));
    this.desk.draw([...this.ink(this.clicked.length > 0 ? [...this.clicked, pointOf(at)] : []), ...this.brush(at)]);
  }

  private reach(): number | null {
    const members = this.desk.members(this.slot);
    const radius = members["radius_m"] ?? members["width_m"];
    return typeof radius === "number" ? radius : null;
  }

  private brush(at: GroundPointer): OverlayShape[] {
    const radius_m = this.reach();
    if (radius_m === null) return [];
    const hardness = this.desk.members(this.slot)["hardness"];
    const inner = typeof hardness === "number" && hardness > 0 ? { inner_m: hardness * radius_m } : {};
    return [{ shape: "circle", at: pointOf(at), radius_m, role: lookOf(this.slot).role, ...inner }];
  }

  private ink(points: readonly Point[]): OverlayShape[] {
    if (points.length === 0) return [];
    const { role } = lookOf(this.slot);
    const radius = this.slot.brush ? this.reach() : null;
    if (points.length === 1) return [{ shape: "dot", at: points[0]!, role }];
    return [{ shape: "line", points, role, ...(radius === null ? { width_px: 2.5 } : { width_m: 2 * radius }) }];
  }

  private show(at: GroundPointer, points: readonly Point[]): void {
    this.lastPoints = [...points];
    this.desk.draw([...this.ink(points), ...this.brush(at)]);
    if (!this.slot.brush) this.desk.say(`${formatLength(lengthOf(points))}`);
  }
}

export function formatLength(metres: number): string {
  return metres >= 10000 ? `${(metres / 1000).toFixed(1)} km` : metres >= 1000 ? `${(metres / 1000).toFixed(2)} km` : `${Math.round(metres)} m`;
}
