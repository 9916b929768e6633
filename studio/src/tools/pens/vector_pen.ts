// Moves and bends objects of a scene: pressed where the object is, dragged to where it goes.
import type { SceneObject } from "../../viewport/objects_content";
import type { GroundPointer } from "../../viewport/types";
import { moveFeature, setPoints } from "../changes";
import { Drawing, pointOf, withIteration, type Desk, type Pen, type PenKey } from "../desk";
import type { Feature } from "../features";
import { tolerance } from "../fit";
import type { Gesture } from "../gesture";
import { distance, roundedPoint, roundingStep, type Point } from "../geometry";
import { kReach_px } from "../hit";
import { lookOf } from "../names";
import { objectInk, objectMembers, objectUnder } from "../objects";
import { formatLength, kClick_px } from "./line_pen";

export class VectorPen implements Pen {
  readonly cursor = "move" as const;
  private from: Point | null = null;
  private drawing: Drawing | null = null;
  /** What was under the pen where it went down. */
  private object: SceneObject | null = null;
  private held: { feature: Feature; end: boolean; from: Point; gesture: Gesture } | null = null;

  constructor(private readonly desk: Desk) {}

  private rounded(at: GroundPointer): Point {
    return roundedPoint(pointOf(at), roundingStep(tolerance(this.desk.fitting(at))));
  }

  down(at: GroundPointer): void {
    const reach = kReach_px * at.pixel_m;
    for (const feature of this.desk.features()) {
      if (feature.slot.id !== this.desk.offer.slot!.id) continue;
      const end = distance(feature.points[1] ?? feature.points[0]!, pointOf(at)) <= reach;
      if (!end && distance(feature.points[0]!, pointOf(at)) > reach) continue;
      this.held = { feature, end, from: pointOf(at), gesture: this.desk.begin(lookOf(feature.slot).done) };
      return this.desk.select([feature.key]);
    }
    this.from = this.rounded(at);
    this.object = objectUnder(this.desk.offer.slot!, pointOf(at), at.pixel_m);
  }

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    if (!at) return;
    if (this.held) {
      const { feature, end, from, gesture } = this.held;
      const step = roundingStep(tolerance(this.desk.fitting(at)));
      const to = this.rounded(at);
      gesture.live(() => (end ? setPoints(feature, [feature.points[0]!, to]) : moveFeature(feature, at.x - from[0], at.y - from[1], step)));
      return;
    }
    if (!this.from || (!this.drawing && distance(this.from, pointOf(at)) <= kClick_px * at.pixel_m)) return;
    const slot = this.desk.offer.slot!;
    this.drawing ??= new Drawing(this.desk, slot, slot.parts[0]!, lookOf(slot).done);
    const to = this.rounded(at);
    this.drawing.live([this.from, to], this.members());
    const moved = objectInk(this.object);
    this.desk.draw([...moved, { shape: "line", points: [this.from, to], role: "selected", width_px: 2 }, { shape: "dot", at: to, role: "handle" }]);
    this.desk.say(formatLength(distance(this.from, to)));
  }

  private members() {
    const { slot } = this.desk.offer;
    return { ...withIteration(this.desk, slot!, this.desk.members(slot!)), ...objectMembers(this.object) };
  }

  up(at: GroundPointer): void {
    const { held, drawing, from } = this;
    this.clear();  // before the end, which may take this pen away
    if (held) {
      void held.gesture.finish();
      this.desk.end();
    } else void drawing?.finish([from!, this.rounded(at)], this.members());
  }

  private clear(): void {
    this.held = null;
    this.drawing = null;
    this.from = null;
    this.desk.draw([]);
    this.desk.say("");
  }

  cancel(): void {
    const { held, drawing } = this;
    this.clear();
    drawing?.cancel();
    if (!held) return;
    void held.gesture.cancel();
    this.desk.end();
  }

  leave(): void {
    this.cancel();
  }

  key({ key }: PenKey): boolean {
    if (key !== "Escape" || (!this.held && !this.drawing)) return false;
    this.cancel();
    return true;
  }

  hover(at: GroundPointer | null): void {
    if (!at) return this.desk.draw([]);
    const slot = this.desk.offer.slot!, radius = this.desk.members(slot)["radius_m"];
    const meant = objectInk(objectUnder(slot, pointOf(at), at.pixel_m));
    const circle = { shape: "circle" as const, at: pointOf(at), role: "handle" as const };
    this.desk.draw(typeof radius === "number" ? [...meant, { ...circle, radius_m: radius }] : meant);
  }
}
