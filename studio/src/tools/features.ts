// The drawn things of a step, read from the recipe through its operator's slots.
import type { Json, Recipe } from "../api/types";
import type { Point } from "./geometry";
import { below, paramPlace, type Found, type Path } from "./place";
import { geometryOf, type Geometry, type Part, type Slot } from "./slots";

export interface Feature {
  /** Where the geometry stands; unique, and the same as long as no item before it comes or goes. */
  key: string;
  slot: Slot;
  part: Part;
  geometry: Geometry;
  points: Point[];
  /** Place of the item that it belongs to; the parameters' own where there are no items. */
  item: Found;
  /** Number in the slot's list; or in the part's list of places or rings. */
  index: number;
  /** Taken out of the recipe as a whole: the item, or the point of a list, or the value. */
  whole: Found;
  hole: boolean;
}

export function isPoint(value: Json | undefined): value is [number, number] {
  return Array.isArray(value) && value.length === 2 && typeof value[0] === "number" && typeof value[1] === "number";
}

/** Points of a list; null where something else stands there. */
export function pointsOf(value: Json | undefined): Point[] | null {
  return Array.isArray(value) && value.length > 0 && value.every(isPoint) ? (value as [number, number][]) : null;
}

function members(value: Json | undefined): { [name: string]: Json } {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value : {};
}

class Reader {
  readonly features: Feature[] = [];
  constructor(private readonly recipe: Recipe, private readonly slot: Slot) {}

  private add(
    part: Part, at: Found, points: Point[] | null, item: Found, index: number, whole: Found, hole = false,
  ): void {
    if (!points) return;
    const geometry = part === this.slot.parts[0] ? this.slot.geometry : geometryOf(part);
    this.features.push({ key: at.pointer, slot: this.slot, part, geometry, points, item, index, whole, hole });
  }

  private ring(part: Part, at: Found, item: Found, index: number, whole: Found): void {
    if (Array.isArray(at.value)) return this.add(part, at, pointsOf(at.value), item, index, whole);
    const outer = below(this.recipe, at, ["outer"]);
    this.add(part, outer, pointsOf(outer.value), item, index, whole);
    const holes = below(this.recipe, at, ["holes"]);
    if (!Array.isArray(holes.value)) return;
    holes.value.forEach((_, i) => {
      const hole = below(this.recipe, holes, [i]);
      this.add(part, hole, pointsOf(hole.value), item, index, hole, true);
    });
  }

  private place(part: Part, item: Found, at: Found, index: number, whole: Found): void {
    if (part.as === "pair") {
      const [x, y] = part.names!.map((name) => below(this.recipe, at, [name]).value);
      const inList = this.slot.list !== null;
      if (typeof x !== "number" && typeof y !== "number" && !inList) return;
      return this.add(
        part, { ...at, pointer: `${at.pointer}#${part.names![0]}` }, [[Number(x ?? 0), Number(y ?? 0)]], item, index,
        whole,
      );
    }
    const inItem = this.slot.list !== null && at.value === undefined && part === this.slot.parts[0];
    const point: Point | null = isPoint(at.value) ? at.value : inItem && this.slot.tool !== "paste" ? [0, 0] : null;
    if (!point) return;
    if (!this.slot.by || part !== this.slot.parts[0]) return this.add(part, at, [point], item, index, whole);
    const by = below(this.recipe, item, this.slot.by).value;
    const end: Point = isPoint(by) ? [point[0] + by[0], point[1] + by[1]] : point;
    this.add(part, at, [point, end], item, index, whole);
  }

  /** All that one item, or the parameters, hold of a part. */
  part(part: Part, item: Found, index: number): void {
    const at = below(this.recipe, item, part.path);
    const whole = this.slot.list ? item : at;
    if (part.as === "line") return this.add(part, at, pointsOf(at.value), item, index, whole);
    if (part.as === "ring") return this.ring(part, at, item, index, whole);
    if (part.as === "point" || part.as === "pair") return this.place(part, item, at, index, whole);
    if (part.as === "polar" || !Array.isArray(at.value)) return;
    at.value.forEach((value, i) => {
      const one = below(this.recipe, at, [i]);
      const alone = this.slot.list !== null && part === this.slot.parts[0] && (at.value as Json[]).length === 1;
      if (part.as === "places" && isPoint(one.value)) this.add(part, one, [one.value], item, i, alone ? item : one);
      if (part.as === "polygons" && value !== null) this.ring(part, one, item, i, alone ? item : one);
    });
  }

  read(step: string): Feature[] {
    if (!this.slot.list) {
      const params = paramPlace(this.recipe, step, []);
      for (const part of this.slot.parts) this.part(part, params, 0);
      return this.features;
    }
    const list = paramPlace(this.recipe, step, this.slot.list);
    if (!Array.isArray(list.value)) return this.features;
    list.value.forEach((_, index) => {
      const item = below(this.recipe, list, [index]);
      if (this.slot.tool && members(item.value)["tool"] !== this.slot.tool) return;
      if (this.slot.bare && Array.isArray(item.value)) {
        this.add(this.slot.parts[0]!, item, pointsOf(item.value), item, index, item);
        return;
      }
      for (const part of this.slot.parts) this.part(part, item, index);
    });
    return this.features;
  }
}

/** In the order of the slots, and of what was drawn. Radii around a centre are not among them (polar.ts). */
export function featuresOf(recipe: Recipe, step: string, slots: readonly Slot[]): Feature[] {
  return slots.flatMap((slot) => new Reader(recipe, slot).read(step));
}

/** What an item says of a member; undefined: nothing, it has its default. */
export function memberOf(feature: Feature, path: Path): Json | undefined {
  let value: Json | undefined = feature.item.value;
  for (const name of path) value = members(value)[String(name)];
  return value;
}

export function itemMembers(feature: Feature): { [name: string]: Json } {
  return members(feature.item.value);
}
