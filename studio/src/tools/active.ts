// What the pen is set to: the tool, the brush, what the next drawn thing is like, and what is selected of the drawing.
import { signal } from "@preact/signals";
import type { Json, ParamInfo } from "../api/types";
import type { OverlayShape } from "../viewport/types";
import type { Domain } from "./place";
import type { Slot } from "./slots";

export const activeTool = signal("edit:select");

/** Keys of the selected features, and of single points of them ("KEY 3"). */
export const selection = signal<ReadonlySet<string>>(new Set());
export const selectedPoints = signal<ReadonlySet<string>>(new Set());

/** What the pen itself shows: its brush, the line that is being drawn. */
export const draft = signal<readonly OverlayShape[]>([]);

/** A remark of the pen beside its options: a length, a height that is being typed. */
export const readout = signal("");

/** Reach of the eraser and of the brush that drags outlines; null: as wide as suits the domain. */
export const reach = signal<number | null>(null);

/** Values that were chosen for the next thing, by slot; brushes of one step share their radius and hardness. */
export const chosen = signal<{ readonly [place: string]: Json }>({});

const kShared = new Set(["radius_m", "hardness", "region"]);

function placeOf(slot: Slot, member: string): string {
  return slot.brush || (slot.op === "classify.paint" && member === "region")
    ? kShared.has(member) ? `${slot.op} * ${member}` : `${slot.op} ${slot.id} ${member}`
    : `${slot.op} ${slot.id} ${member}`;
}

export function choose(slot: Slot, member: string, value: Json): void {
  chosen.value = { ...chosen.value, [placeOf(slot, member)]: value };
}

/** The number of 1, 2, 5, 10 ... that is nearest. */
export function roundNumber(value: number): number {
  const base = 10 ** Math.floor(Math.log10(value));
  const lead = value / base;
  return Number(((lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * base).toPrecision(6));
}

/** A reach that suits a domain: the operator's own default, if it is neither a dot nor all of it. */
export function suitableReach(start: number, domain: Domain): number {
  const side = Math.min(domain.width_m, domain.height_m);
  return start >= side / 100 && start <= side / 12 ? start : roundNumber(side / 25);
}

/** Reach of a tool that has none of its own: the brush on outlines is wider than the eraser. */
export function ownReach(geometry: string | undefined, domain: Domain): number {
  const side = Math.min(domain.width_m, domain.height_m);
  return reach.value ?? roundNumber(side / (geometry === "polar" ? 10 : 40));
}

export function isReach(member: ParamInfo): boolean {
  return member.name === "radius_m" || member.name === "width_m";
}

/** What a new thing begins with where the operator's own default does nothing. */
const kStarts: { [place: string]: Json } = {
  "ecosystem.grow timeline:ground change_m": 50,
  "ecosystem.grow timeline:ground end": 10,
  "ecosystem.grow timeline:storm end": 10,
};

/** The iteration after which an edit of a scene is done. */
function isIteration(member: ParamInfo): boolean {
  return member.name === "after" && member.kind === "integer";
}

/** What a member of a new thing is before anybody has chosen. */
export function startValue(slot: Slot, member: ParamInfo, domain: Domain): Json {
  const start = kStarts[`${slot.op} ${slot.id} ${member.name}`];
  if (start !== undefined) return start;
  if (isIteration(member)) return null;  // of what was chosen: else as late as it may be, or at once
  const reaches = isReach(member) && slot.geometry !== "ring" && typeof member.default === "number";
  return reaches ? suitableReach(member.default as number, domain) : member.default;
}

/** What the next thing gets for a member. */
export function chosenValue(slot: Slot, member: ParamInfo, domain: Domain): Json {
  return chosen.value[placeOf(slot, member.name)] ?? startValue(slot, member, domain);
}

/** A reach between half a cell and half the domain, however far the operator would go. */
export function practical(member: ParamInfo, domain: Domain): ParamInfo {
  if (!isReach(member)) return member;
  const least = Math.max(member.min ?? 0, domain.cell_m / 2);
  const most = Math.min(domain.width_m, domain.height_m) / 2;
  return { ...member, min: least, max: Math.max(2 * least, Math.min(member.max ?? Infinity, most)) };
}

/** Members of a new item: what differs from the operator's default, and always what the hand can see. */
export function chosenMembers(slot: Slot, domain: Domain): { [name: string]: Json } {
  const result: { [name: string]: Json } = {};
  for (const member of slot.members) {
    const value = chosenValue(slot, member, domain);
    const seen = isReach(member) || isIteration(member) || /^(strength(_m)?|height_m|depth_m|region|value|change_m)$/.test(member.name);
    if (value === null || value === "" || (!seen && value === member.default)) continue;
    result[member.name] = value;
  }
  return result;
}
