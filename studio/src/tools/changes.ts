// The edits of a recipe that draw, move, bend and delete things. Numbers that belong to points (pressure, the beds of a
// river) go along with them.
import type { Edit, Json, Recipe } from "../api/types";
import type { Feature } from "./features";
import { itemMembers } from "./features";
import { roundedPoint, type Point } from "./geometry";
import { paramPlace, token, type Path } from "./place";
import type { Part, Slot } from "./slots";

const pairs = (points: readonly Point[]): Json => points.map(([x, y]) => [x, y]);

/** Numbers of an item that run along its points. */
function alongPoints(feature: Feature): [string, number[]][] {
  if (feature.part.as !== "line") return [];
  return Object.entries(itemMembers(feature)).filter((entry): entry is [string, number[]] => {
    const value = entry[1];
    return Array.isArray(value) && value.length === feature.points.length && value.every((v) => typeof v === "number");
  });
}

function between(values: readonly number[], at: number): number {
  const low = Math.max(0, Math.min(values.length - 1, Math.floor(at)));
  const high = Math.min(values.length - 1, low + 1);
  return Number((values[low]! + (values[high]! - values[low]!) * (at - low)).toFixed(4));
}

const set = (pointer: string, value?: Json): Edit => (
  value === undefined ? { do: "set", pointer } : { do: "set", pointer, value }
);

/** New points of a feature. `from`: which old point (or place between two) each new one was, where their number
 * changes. */
export function setPoints(feature: Feature, points: readonly Point[], from?: readonly number[]): Edit[] {
  const { slot, part, item } = feature;
  if (part.as === "pair") {
    const below = [item.pointer, ...part.path.map(token)].join("/");
    return part.names!.map((name, axis) => set(`${below}/${name}`, points[0]![axis]!));
  }
  if (part.as === "point" || part.as === "places") {
    const [at, end] = points;
    const edits = [set(feature.key, [...at!])];
    if (part !== slot.parts[0]) return edits;
    for (const path of slot.also) edits.push(set(`${item.pointer}/${path.map(token).join("/")}`, [...at!]));
    if (slot.by && end) edits.push(
      set(`${item.pointer}/${slot.by.map(token).join("/")}`, [end[0] - at![0], end[1] - at![1]]),
    );
    return edits;
  }
  const edits = [set(feature.key, pairs(points))];
  if (!from) return edits;
  for (const [name, values] of alongPoints(feature)) {
    edits.push(set(`${item.pointer}/${token(name)}`, from.map((at) => between(values, at))));
  }
  return edits;
}

export function moveFeature(feature: Feature, dx: number, dy: number, step: number): Edit[] {
  const [at, end] = feature.points;
  if (feature.geometry === "vector" && at && end) {
    const to = roundedPoint([at[0] + dx, at[1] + dy], step);
    return setPoints(feature, [to, [to[0] + end[0] - at[0], to[1] + end[1] - at[1]]]);
  }
  return setPoints(feature, feature.points.map(([x, y]) => roundedPoint([x + dx, y + dy], step)));
}

/** How few points a feature may have before it is nothing any more. */
export function fewest(feature: Feature): number {
  if (feature.geometry === "ring") return 3;
  return feature.geometry === "line" && !feature.slot.brush && feature.slot.tool !== "slope"
    && feature.slot.tool !== "add" ? 2 : 1;
}

/** Compares places as they follow each other in the recipe: "areas/2" before "areas/10". */
function inOrder(a: string, b: string): number {
  const [left, right] = [a.split("/"), b.split("/")];
  for (let i = 0; i < Math.min(left.length, right.length); ++i) {
    const [p, q] = [left[i]!, right[i]!];
    if (p === q) continue;
    const numbers = /^\d+$/.test(p) && /^\d+$/.test(q);
    return numbers ? Number(p) - Number(q) : p < q ? -1 : 1;
  }
  return left.length - right.length;
}

/** Takes features out, the last of a list first, so that places stay right. */
export function removeFeatures(features: readonly Feature[]): Edit[] {
  const wholes = new Map<string, Feature>();
  for (const feature of features) {
    if (feature.part.as === "pair" && !feature.slot.list) wholes.set(feature.key, feature);
    else wholes.set(feature.whole.pointer, feature);
  }
  const gone = [...wholes.keys()];
  const inner = (pointer: string) => gone.some((other) => other !== pointer && pointer.startsWith(`${other}/`));
  return [...wholes]
    .filter(([pointer]) => !inner(pointer))
    .sort((a, b) => inOrder(b[0], a[0]))
    .flatMap(([pointer, feature]): Edit[] => {
      if (feature.part.as === "pair" && !feature.slot.list) {
        const below = [feature.item.pointer, ...feature.part.path.map(token)].join("/");
        return feature.part.names!.map((name) => set(`${below}/${name}`));
      }
      return [/\/\d+$/.test(pointer) ? { do: "remove", item: pointer } : set(pointer)];
    });
}

/** Without some of their points; features of which too few are left go as a whole. */
export function removePoints(features: readonly Feature[], gone: (feature: Feature, index: number) => boolean): Edit[] {
  const edits: Edit[] = [];
  const none: Feature[] = [];
  for (const feature of features) {
    const kept = feature.points.map((_, i) => i).filter((i) => !gone(feature, i));
    if (kept.length < fewest(feature) || feature.geometry === "vector") none.push(feature);
    else edits.push(...setPoints(feature, kept.map((i) => feature.points[i]!), kept));
  }
  return [...edits, ...removeFeatures(none)];
}

/** With a point between `segment` and the next one. */
export function insertPoint(feature: Feature, segment: number, share: number, at: Point): Edit[] {
  const points = [...feature.points.slice(0, segment + 1), at, ...feature.points.slice(segment + 1)];
  const from = [...feature.points.keys()].flatMap((i) => (i === segment ? [i, i + share] : [i]));
  return setPoints(feature, points, from);
}

function put(object: { [name: string]: Json }, path: Path, value: Json): void {
  let at = object;
  for (const name of path.slice(0, -1)) at = (at[name] ??= {}) as { [name: string]: Json };
  at[path[path.length - 1]!] = value;
}

function geometryValue(part: Part, points: readonly Point[]): Json {
  if (part.as === "point") return [...points[0]!];
  return part.as === "polygons" ? [pairs(points)] : pairs(points);
}

/** A new item of a slot's list: what was drawn, and the members that are chosen. */
export function newItem(slot: Slot, part: Part, points: readonly Point[], members: { [name: string]: Json }): Json {
  const item: { [name: string]: Json } = slot.tool ? { tool: slot.tool } : {};
  if (part.as === "pair") part.names!.forEach((name, axis) => (item[name] = points[0]![axis]!));
  else put(item, part.path, geometryValue(part, points));
  if (part === slot.parts[0] && points[0]) {
    for (const path of slot.also) put(item, path, [...points[0]]);
    if (slot.by && points[1]) put(item, slot.by, [points[1][0] - points[0][0], points[1][1] - points[0][1]]);
  }
  for (const [name, value] of Object.entries(members)) put(item, name.split("/"), value);
  return item;
}

/** What a new thing is in the recipe: put in once, then set again and again while it is drawn. */
export interface Creation {
  first: Edit[];
  /** Where it then stands. */
  key: string;
  /** The edits that make it another. */
  again(points: readonly Point[], members: { [name: string]: Json }): Edit[];
}

export function create(
  recipe: Recipe, step: string, slot: Slot, part: Part, points: readonly Point[], chosen: { [name: string]: Json },
): Creation {
  if (slot.list) {
    const list = paramPlace(recipe, step, slot.list);
    const item = (p: readonly Point[], m: { [name: string]: Json }) => newItem(slot, part, p, m);
    return append(list.pointer, list.value, item(points, chosen), item);
  }
  const at = paramPlace(recipe, step, part.path);
  if (part.as === "pair") {
    const both = (p: readonly Point[]) => part.names!.map((name, axis) => set(`${at.pointer}/${name}`, p[0]![axis]!));
    return { first: both(points), key: `${at.pointer}#${part.names![0]}`, again: both };
  }
  if (part.as === "polygons" || part.as === "places") {
    const item = (p: readonly Point[]): Json => (part.as === "polygons" ? pairs(p) : [...p[0]!]);
    return append(at.pointer, at.value, item(points), item);
  }
  const value = (p: readonly Point[]): Edit[] => [set(at.pointer, geometryValue(part, p))];
  return { first: value(points), key: at.pointer, again: value };
}

function append(
  pointer: string, list: Json | undefined, value: Json,
  item: (p: readonly Point[], m: { [name: string]: Json }) => Json,
): Creation {
  const index = Array.isArray(list) ? list.length : 0;
  const key = `${pointer}/${index}`;
  const first: Edit[] = Array.isArray(list) ? [{ do: "insert", list: pointer, value }] : [set(pointer, [value])];
  return { first, key, again: (points, members) => [set(key, item(points, members))] };
}
