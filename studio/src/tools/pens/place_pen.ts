// Sets places: a click makes one, dragging an old one moves it; where it has a height, typing digits gives it.
import type { Edit, Json } from "../../api/types";
import type { SceneObject } from "../../viewport/objects_content";
import type { GroundPointer } from "../../viewport/types";
import { moveFeature } from "../changes";
import { Drawing, pointOf, withIteration, type Desk, type Pen, type PenKey } from "../desk";
import { itemMembers, type Feature } from "../features";
import { tolerance } from "../fit";
import type { Gesture } from "../gesture";
import { distance, roundedPoint, roundingStep, type Point } from "../geometry";
import { HeightWheel, heightMember, turnedHeight } from "../height_wheel";
import { kReach_px } from "../hit";
import { lookOf } from "../names";
import { objectInk, objectMembers, objectUnder } from "../objects";
import { token } from "../place";
import type { Slot } from "../slots";
import { TypedNumber } from "../typed_number";

export class PlacePen implements Pen {
  readonly cursor = "crosshair" as const;
  private drawing: Drawing | null = null;
  private held: { feature: Feature; from: Point; gesture: Gesture } | null = null;
  private readonly typed: TypedNumber;
  /** What was under the pen where it went down. */
  private object: SceneObject | null = null;
  private readonly slot: Slot;
  private readonly turned: HeightWheel;
  /** Where the pen is, without being down. */
  private over: GroundPointer | null = null;
  /** Height to which the wheel has turned what the pen holds. */
  private lifted: number | null = null;

  constructor(private readonly desk: Desk) {
    this.slot = desk.offer.slot!;
    this.turned = new HeightWheel(desk);
    this.typed = new TypedNumber(desk, () => this.features().find((f) => this.desk.selected().has(f.key)));
  }

  private features(): Feature[] {
    return this.desk.features().filter((f) => f.slot.id === this.slot.id && f.part === this.slot.parts[0]);
  }

  private at(pointer: GroundPointer): Point {
    return roundedPoint(pointOf(pointer), roundingStep(tolerance(this.desk.fitting(pointer))));
  }

  /** A height that nobody chose is the ground's. */
  private members(at: GroundPointer): { [name: string]: Json } {
    const members = { ...withIteration(this.desk, this.slot, this.desk.members(this.slot)), ...objectMembers(this.object) };
    const height = heightMember(this.slot);
    if (height && this.lifted !== null) return { ...members, [height.name]: this.lifted };
    if (height?.name !== "height_m" || at.height === null || members["height_m"]) return members;
    const rounded = Math.round(at.height);
    return rounded < (height.min ?? -Infinity) || rounded > (height.max ?? Infinity) ? members : { ...members, height_m: rounded };
  }

  down(at: GroundPointer): void {
    this.typed.finish();
    this.turned.finish();
    this.over = at;
    this.lifted = null;
    const reach = kReach_px * at.pixel_m;
    const near = this.features().filter((f) => distance(f.points[0]!, pointOf(at)) <= reach);
    const only = this.slot.list === null && this.slot.parts[0]!.as !== "places" ? this.features()[0] : undefined;
    const feature = near[0] ?? only;
    if (feature) {
      const from = near[0] ? pointOf(at) : feature.points[0]!;
      this.held = { feature, from, gesture: this.desk.begin(lookOf(this.slot).done.replace("placed", "moved")) };
      this.desk.select([feature.key]);
      if (!near[0]) this.drag(at);
      return;
    }
    this.object = objectUnder(this.slot, pointOf(at), at.pixel_m);
    this.drawing = new Drawing(this.desk, this.slot, this.slot.parts[0]!, lookOf(this.slot).done);
    this.drawing.live([this.at(at)], this.members(at));
  }

  private drag(at: GroundPointer): void {
    const { feature, from, gesture } = this.held!;
    const step = roundingStep(tolerance(this.desk.fitting(at)));
    gesture.live(() => [...moveFeature(feature, at.x - from[0], at.y - from[1], step), ...this.liftEdits(feature)]);
  }

  private liftEdits(feature: Feature): Edit[] {
    const member = heightMember(feature.slot);
    if (!member || this.lifted === null) return [];
    return [{ do: "set", pointer: memberPointer(feature, member.name), value: this.lifted }];
  }

  wheel(notches: number): boolean {
    const { over } = this, member = heightMember(this.slot);
    if (!over || !member) return false;
    if (!this.held && !this.drawing) {
      const near = this.features().find((f) => distance(f.points[0]!, pointOf(over)) <= kReach_px * over.pixel_m)
        ?? this.features().find((f) => this.desk.selected().has(f.key));
      return near !== undefined && this.turned.turn(near, notches, Math.round(over.height ?? 0));
    }
    const stated = this.held ? numberOf(this.held.feature, member.name) : this.members(over)[member.name];
    const now = this.lifted ?? (typeof stated === "number" ? stated : Math.round(over.height ?? 0));
    this.lifted = turnedHeight(now, notches, member.min, member.max);
    this.desk.draw([{ shape: "dot", at: pointOf(over), role: "selected", label: `${this.lifted} m` }]);
    this.desk.say(`${this.lifted} m`);
    if (this.held) this.drag(over);
    else this.drawing!.live([this.at(over)], this.members(over));
    return true;
  }

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    if (!at) return;
    this.over = at;
    if (this.held) this.drag(at);
    else this.drawing?.live([this.at(at)], this.members(at));
  }

  up(at: GroundPointer): void {
    const { held, drawing } = this;
    this.held = this.drawing = null;  // before the end, which may take this pen away
    if (this.lifted !== null) this.desk.draw([]);
    if (held) {
      void held.gesture.finish();
      return this.desk.end();
    }
    void drawing?.finish([this.at(at)], this.members(at));
    if (this.slot.members.some((member) => member.name === "height_m")) this.desk.say("type a height");
  }

  cancel(): void {
    const { held, drawing } = this;
    this.held = this.drawing = null;
    this.typed.cancel();
    drawing?.cancel();
    if (!held) return;
    void held.gesture.cancel();
    this.desk.end();
  }

  leave(): void {
    this.typed.finish();
    this.turned.finish();
    this.cancel();
  }

  key(pressed: PenKey): boolean {
    if (pressed.key === "Escape" && (this.held || this.drawing)) {
      this.cancel();
      return true;
    }
    return this.typed.key(pressed);
  }

  hover(at: GroundPointer | null): void {
    const radius = this.desk.members(this.slot)["radius_m"];
    const { role } = lookOf(this.slot);
    this.over = at;
    if (!at) return this.desk.draw([]);
    const meant = objectInk(objectUnder(this.slot, pointOf(at), at.pixel_m));
    const circle = { shape: "circle" as const, at: pointOf(at), role };
    this.desk.draw(typeof radius === "number" ? [...meant, { ...circle, radius_m: radius }] : meant);
  }
}

/** Pointer of a member of a feature's item. */
export function memberPointer(feature: Feature, name: string): string {
  return `${feature.item.pointer}/${token(name)}`;
}

export function numberOf(feature: Feature, name: string): number | null {
  const value = itemMembers(feature)[name];
  return typeof value === "number" ? value : null;
}
