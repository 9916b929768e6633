// What can be drawn into a step: every place of an operator's parameters that holds geometry, found by the parameters'
// kinds, so that a new operator brings its pens along.
import type { OperatorInfo, ParamInfo } from "../api/types";
import type { Path } from "./place";

/** How geometry is written: a list of points, one ring, a list of rings (or outer and holes), a list of places, one
 * place, two numbers x and y, radii around a centre. */
export type Writing = "line" | "ring" | "polygons" | "places" | "point" | "pair" | "polar";

/** What it is to the hand. A vector is a place and how far it is moved. */
export type Geometry = "line" | "ring" | "place" | "polar" | "vector";

export interface Part {
  /** Below the item, or below the step's parameters. */
  path: Path;
  as: Writing;
  /** "pair": the names of the two numbers. */
  names?: readonly [string, string];
}

export interface Slot {
  /** "strokes", "edits:warp", "starts/points". */
  id: string;
  op: string;
  /** Where the items stand, of which each is one thing; null: the parameters themselves are the thing. */
  list: Path | null;
  /** Of a list of tools: which one. */
  tool?: string;
  about: string;
  geometry: Geometry;
  /** Drawn things make the first part; others are shown and edited where they are stated. */
  parts: readonly Part[];
  /** What a click without a stroke makes in its place: the contour nearest to a place instead of those in a ring. */
  click?: Part;
  /** "vector": how far. */
  by?: Path;
  /** More places that go where the first one is: where an object is looked for. */
  also: readonly Path[];
  /** An item may be the geometry itself, without members. */
  bare: boolean;
  /** What else an item holds: width, strength, height ... */
  members: readonly ParamInfo[];
  /** Swept with a brush: points with pressure, of a list that replays in order. */
  brush: boolean;
}

const kMemberKinds = new Set(["number", "integer", "switch", "choice", "text", "file"]);

function number(name: string, unit: string, start: ParamInfo["default"], help: string, min?: number): ParamInfo {
  return { name, kind: "number", unit, default: start, help, ...(min === undefined ? {} : { min }) };
}

const kStrokeMembers = [
  number("width_m", "m", 500, "deviation of the falloff across the stroke", 0.01),
  number("strength_m", "m", 400, "displacement on the stroke; below 0 against its direction"),
];
const kRegionMembers: ParamInfo[] = [
  { name: "name", kind: "text", unit: "", default: "", help: "how messages call it" },
  number("height_m", "m", null, "height of the outline; none: as the distribution of heights gives"),
  { name: "basin", kind: "switch", unit: "", default: false, help: "its inside lies lower than its outline" },
  number("peak_m", "m", null, "height of its summit; of a basin its deepest place"),
];
const kRiverMembers = [
  number("source_width_m", "m", 0, "width of the valley floor at the source", 0),
  number("mouth_width_m", "m", 0, "and at the mouth", 0),
];

/** A list of points is a line, unless its name or its help speaks of places. */
function isPlaces(param: ParamInfo): boolean {
  return /^(at|places?)$/.test(param.name)
    || (/\bplaces?\b/.test(param.help) && !/\b(line|spline|curve|stroke)\b/.test(param.help));
}

function pairsOf(params: readonly ParamInfo[]): { names: [string, string]; prefix: string }[] {
  const names = new Set(params.map((p) => p.name));
  return params
    .filter((p) => p.kind === "number" && p.name.endsWith("x_m") && names.has(p.name.replace(/x_m$/, "y_m")))
    .map((p) => ({ names: [p.name, p.name.replace(/x_m$/, "y_m")], prefix: p.name.slice(0, -3) }));
}

/** All geometry among some parameters, groups included, the outermost first; lists of items are not entered. */
function partsAmong(params: readonly ParamInfo[], above: Path): Part[] {
  const here: Part[] = [];
  const inner: Part[] = [];
  for (const param of params) {
    const path = [...above, param.name];
    if (param.kind === "points") here.push({ path, as: isPlaces(param) ? "places" : "line" });
    if (param.kind === "polygons") here.push({ path, as: "polygons" });
    if (param.kind === "point") here.push({ path, as: "point" });
    if (param.kind === "outlines") here.push({ path, as: "polar" });
    if (param.kind === "group") inner.push(...partsAmong(param.tools?.[0]?.params ?? [], path));
  }
  for (const { names } of pairsOf(params)) here.push({ path: above, as: "pair", names });
  return [...here, ...inner];
}

export function geometryOf(part: Part): Geometry {
  if (part.as === "line") return "line";
  if (part.as === "ring" || part.as === "polygons") return "ring";
  return part.as === "polar" ? "polar" : "place";
}

const last = (part: Part) => part.path[part.path.length - 1];
const kOrder: Writing[] = ["line", "ring", "polygons", "point", "pair", "places"];

/** The slot of an item with these parameters; null where they hold no geometry. */
function itemSlot(op: string, list: Path, tool: string, about: string, params: readonly ParamInfo[]): Slot | null {
  const all = partsAmong(params, []);
  const by = all.find((part) => part.as === "point" && last(part) === "by");
  const near = all.filter((part) => part.as === "point" && last(part) === "near");
  let parts = all.filter((part) => part !== by && !near.includes(part));
  if (parts.length === 0) parts = near.slice(0, 1);
  if (parts.length === 0) return null;
  parts.sort((a, b) => kOrder.indexOf(a.as) - kOrder.indexOf(b.as));
  const first = parts[0]!;
  const click = first.as === "polygons" ? parts.find((part) => part.as === "places") : undefined;
  const used = new Set<string>(["pressure", ...(first.as === "pair" ? first.names! : [])]);
  const geometry = by && first.as === "point" ? "vector" : geometryOf(first);
  const radius = params.some((param) => param.name === "radius_m");
  return {
    id: tool ? `${list.join("/")}:${tool}` : list.join("/"),
    op,
    list,
    ...(tool ? { tool } : {}),
    about,
    geometry,
    parts,
    ...(click ? { click } : {}),
    ...(by ? { by: by.path } : {}),
    also: near.filter((part) => part !== first).map((part) => part.path),
    bare: false,
    members: params.filter((param) => kMemberKinds.has(param.kind) && !used.has(param.name)),
    brush: list[0] === "strokes" && first.as === "line" && radius,
  };
}

function listSlot(op: string, param: ParamInfo, path: Path): Slot {
  const base = { id: path.join("/"), op, list: path, about: param.help, also: [], brush: false };
  switch (param.kind) {
    case "strokes":
      return {
        ...base, geometry: "line", parts: [{ path: ["points"], as: "line" }], bare: false, members: kStrokeMembers,
      };
    case "rivers":
      return {
        ...base, geometry: "line", parts: [{ path: ["points"], as: "line" }], bare: true, members: kRiverMembers,
      };
    default:
      return {
        ...base, geometry: "ring", parts: [{ path: ["ring"], as: "ring" }], bare: true, members: kRegionMembers,
      };
  }
}

function singleSlot(op: string, part: Part, about: string): Slot {
  const id = part.as === "pair" ? [...part.path, part.names![0]].join("/") : part.path.join("/");
  return {
    id, op, list: null, about, geometry: geometryOf(part), parts: [part], also: [], bare: false, members: [],
    brush: false,
  };
}

function slotsAmong(op: string, params: readonly ParamInfo[], above: Path): Slot[] {
  const slots: Slot[] = [];
  for (const param of params) {
    const path = [...above, param.name];
    const inner = param.tools ?? [];
    if (
      param.kind === "strokes" || param.kind === "rivers" || param.kind === "regions"
    ) slots.push(listSlot(op, param, path));
    if (param.kind === "points") slots.push(
      singleSlot(op, { path, as: isPlaces(param) ? "places" : "line" }, param.help),
    );
    if (param.kind === "polygons") slots.push(singleSlot(op, { path, as: "polygons" }, param.help));
    if (param.kind === "point") slots.push(singleSlot(op, { path, as: "point" }, param.help));
    if (param.kind === "outlines") slots.push(singleSlot(op, { path, as: "polar" }, param.help));
    if (param.kind === "group") slots.push(...slotsAmong(op, inner[0]?.params ?? [], path));
    if (param.kind === "groups" || param.kind === "tools") {
      for (const tool of inner) {
        const slot = itemSlot(op, path, tool.name, tool.about || param.help, tool.params);
        if (slot) slots.push(slot);
      }
    }
  }
  for (const { names } of pairsOf(params)) {
    slots.push(singleSlot(op, { path: above, as: "pair", names }, params.find((p) => p.name === names[0])!.help));
  }
  return slots;
}

const cache = new WeakMap<OperatorInfo, Slot[]>();

/** Everything that can be drawn into a step of this operator. */
export function slotsOf(operator: OperatorInfo): Slot[] {
  let slots = cache.get(operator);
  if (!slots) cache.set(operator, (slots = slotsAmong(operator.name, operator.params, [])));
  return slots;
}
