// The wheel with Alt or Shift over a place that has a height: turns it up and down, with the value beside the place.
// Turns in a row are one gesture.
import type { Desk } from "./desk";
import { itemMembers, type Feature } from "./features";
import type { Gesture } from "./gesture";
import { roundNumber } from "./active";
import { token } from "./place";
import type { Slot } from "./slots";

const kMembers = ["height_m", "peak_m"];
const kPause_ms = 700;

/** The member of a slot's things that is their height. */
export function heightMember(slot: Slot) {
  return slot.members.find((member) => kMembers.includes(member.name));
}

/** A height after the wheel was turned by so many notches: in even steps that suit it. */
export function turnedHeight(height: number, notches: number, min = -Infinity, max = Infinity): number {
  const step = Math.max(1, roundNumber(Math.max(1, Math.abs(height)) / 40));
  return Math.min(max, Math.max(min, Math.round((height + notches * step) / step) * step));
}

export class HeightWheel {
  private gesture: Gesture | null = null;
  private key = "";
  private height = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly desk: Desk) {}

  /** `start`: its height where the recipe says none. */
  turn(feature: Feature, notches: number, start: number): boolean {
    const member = heightMember(feature.slot);
    if (!member) return false;
    if (this.key !== feature.key) this.finish();
    if (!this.gesture) {
      const stated = itemMembers(feature)[member.name];
      this.height = typeof stated === "number" ? stated : start;
      this.key = feature.key;
      this.gesture = this.desk.begin("height turned");
    }
    const value = (this.height = turnedHeight(this.height, notches, member.min, member.max));
    const pointer = `${feature.item.pointer}/${token(member.name)}`;
    this.gesture.live(() => [{ do: "set", pointer, value }]);
    const label = `${value} m`;
    this.desk.draw([{ shape: "dot", at: feature.points[0]!, role: "selected", label }]);
    this.desk.say(label);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.finish(), kPause_ms);
    return true;
  }

  finish(): void {
    const { gesture } = this;
    clearTimeout(this.timer);
    this.gesture = null;
    this.key = "";
    if (!gesture) return;
    void gesture.finish();
    this.desk.draw([]);
    this.desk.say("");
    this.desk.end();
  }
}
