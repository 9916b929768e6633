// What tools are called, their pictures and keys. A slot that is not named here is called after its parameter.
import type { Slot } from "./slots";
import type { Role } from "../viewport/types";

export interface Look {
  title: string;
  /** Name of a picture of icons.tsx. */
  icon: string;
  keys: string;
  role: Role;
  /** What the history says was done. */
  done: string;
}

const kLooks: { [place: string]: Look } = {
  "island.build outlines": {
    title: "Shape the coast", icon: "polar", keys: "Shift+O", role: "coast", done: "coast shaped",
  },
  "island.build areas": { title: "Draw a coast", icon: "coast", keys: "O", role: "coast", done: "coast drawn" },
  "island.build summits": { title: "Summit", icon: "summit", keys: "H", role: "height", done: "summit placed" },
  "island.wind strokes": { title: "Wind", icon: "wind", keys: "W", role: "wind", done: "wind drawn" },
  "contour.grow outlines": { title: "Region", icon: "region", keys: "O", role: "contour", done: "region drawn" },
  "contour.edit edits:warp": { title: "Warp contours", icon: "warp", keys: "W", role: "ink", done: "contours warped" },
  "contour.edit edits:slope": {
    title: "Steeper, gentler", icon: "slope", keys: "S", role: "ink", done: "slope changed",
  },
  "contour.edit edits:smooth": {
    title: "Smooth contours", icon: "smooth", keys: "Shift+S", role: "guide", done: "contours smoothed",
  },
  "contour.edit edits:fractalize": {
    title: "Roughen contours", icon: "roughen", keys: "Shift+W", role: "guide", done: "contours roughened",
  },
  "contour.edit edits:delete": {
    title: "Delete contours", icon: "trash", keys: "E", role: "erase", done: "contours deleted",
  },
  "contour.edit edits:copy": {
    title: "Copy contours", icon: "copy", keys: "C", role: "guide", done: "contours copied",
  },
  "contour.edit edits:cut": { title: "Cut contours", icon: "cut", keys: "X", role: "erase", done: "contours cut" },
  "contour.edit edits:paste": {
    title: "Paste contours", icon: "paste", keys: "Shift+C", role: "height", done: "contours pasted",
  },
  "contour.edit edits:fill": {
    title: "Fill with contours", icon: "fill", keys: "Shift+F", role: "guide", done: "contours filled",
  },
  "contour.pattern within": {
    title: "Outline of the pattern", icon: "region", keys: "O", role: "guide", done: "outline drawn",
  },
  "contour.pattern select/within": {
    title: "Contours within", icon: "lasso", keys: "L", role: "guide", done: "contours chosen",
  },
  "contour.pattern select/at": { title: "Contour at", icon: "place", keys: "N", role: "guide", done: "contour chosen" },
  "reef.grow starts/line": { title: "Reef line", icon: "line", keys: "O", role: "reef", done: "reef line drawn" },
  "reef.grow starts/points": {
    title: "Reef start", icon: "kernel", keys: "N", role: "reef", done: "reef start placed",
  },
  "learned.sketch ridges": { title: "Ridge", icon: "ridge", keys: "R", role: "ridge", done: "ridge drawn" },
  "learned.sketch heights": { title: "Height", icon: "height", keys: "H", role: "height", done: "height placed" },
  "terrain.mask criteria:area": { title: "Area", icon: "lasso", keys: "L", role: "guide", done: "area drawn" },
  "terrain.mask criteria:line": { title: "Line", icon: "line", keys: "O", role: "guide", done: "line drawn" },
  "terrain.compose places": {
    title: "Place a terrain", icon: "place", keys: "N", role: "height", done: "terrain placed",
  },
  "island.archipelago places": {
    title: "Place an island", icon: "place", keys: "N", role: "height", done: "island placed",
  },
  "terrain.crop x_m": { title: "Middle", icon: "centre", keys: "N", role: "handle", done: "middle moved" },
  "erosion.run lithology/faults": { title: "Fault", icon: "fault", keys: "O", role: "ink", done: "fault drawn" },
  "erosion.run lithology/top_x_m": {
    title: "Top of the beds", icon: "centre", keys: "N", role: "handle", done: "beds moved",
  },
  "ecosystem.grow edits:add": {
    title: "Add an object", icon: "add", keys: "Shift+A", role: "ink", done: "object added",
  },
  "ecosystem.grow edits:move": { title: "Move an object", icon: "move", keys: "M", role: "ink", done: "object moved" },
  "ecosystem.grow edits:bend": { title: "Bend an object", icon: "bend", keys: "W", role: "ink", done: "object bent" },
  "ecosystem.grow edits:hold": {
    title: "Lock an object", icon: "lock", keys: "K", role: "handle", done: "object locked",
  },
  "ecosystem.grow edits:delete": {
    title: "Delete an object", icon: "trash", keys: "E", role: "erase", done: "object deleted",
  },
  "ecosystem.grow timeline:ground": {
    title: "Rise or sink", icon: "rise", keys: "U", role: "height", done: "ground event placed",
  },
  "ecosystem.grow timeline:storm": {
    title: "Storm", icon: "storm", keys: "Shift+W", role: "wind", done: "storm placed",
  },
  "ecosystem.grow timeline:current": {
    title: "Current", icon: "current", keys: "C", role: "river", done: "current drawn",
  },
  "ecosystem.grow window/centre": {
    title: "Middle of the window", icon: "centre", keys: "N", role: "handle", done: "window moved",
  },
  "terrain.sculpt strokes:raise": { title: "Raise", icon: "raise", keys: "B", role: "ink", done: "raised" },
  "terrain.sculpt strokes:lower": { title: "Lower", icon: "lower", keys: "Shift+B", role: "ink", done: "lowered" },
  "terrain.sculpt strokes:smooth": { title: "Smooth", icon: "smooth", keys: "Shift+S", role: "ink", done: "smoothed" },
  "terrain.sculpt strokes:flatten": { title: "Flatten", icon: "flatten", keys: "T", role: "ink", done: "flattened" },
  "terrain.sculpt strokes:ramp": { title: "Ramp", icon: "ramp", keys: "R", role: "ink", done: "ramp drawn" },
  "terrain.sculpt strokes:roughen": { title: "Roughen", icon: "roughen", keys: "N", role: "ink", done: "roughened" },
  "terrain.sculpt strokes:erase": {
    title: "Back to the ground before", icon: "eraser", keys: "E", role: "erase", done: "taken back",
  },
  "classify.paint strokes:region": {
    title: "Region brush", icon: "brush", keys: "B", role: "ink", done: "region painted",
  },
  "classify.paint strokes:area": {
    title: "Region by its outline", icon: "lasso", keys: "L", role: "guide", done: "region filled",
  },
  "classify.paint strokes:sink": { title: "Sink", icon: "lower", keys: "Shift+B", role: "ink", done: "sunk" },
  "classify.paint strokes:erase": {
    title: "Back to the regions before", icon: "eraser", keys: "E", role: "erase", done: "taken back",
  },
  "terrain.paint strokes:brush": { title: "Paint", icon: "brush", keys: "B", role: "ink", done: "painted" },
  "terrain.paint strokes:area": {
    title: "Paint an area", icon: "lasso", keys: "L", role: "guide", done: "area painted",
  },
  "terrain.paint strokes:erase": { title: "Erase", icon: "eraser", keys: "E", role: "erase", done: "erased" },
};

const kByName: { [name: string]: Look } = {
  centre: { title: "Centre", icon: "centre", keys: "N", role: "handle", done: "centre moved" },
  rivers: { title: "River", icon: "river", keys: "Shift+R", role: "river", done: "river drawn" },
};

const kByGeometry = {
  line: { icon: "line", role: "ink", done: "line drawn" },
  ring: { icon: "lasso", role: "guide", done: "area drawn" },
  place: { icon: "place", role: "handle", done: "place set" },
  polar: { icon: "polar", role: "coast", done: "outline shaped" },
  vector: { icon: "move", role: "ink", done: "moved" },
} as const;

export function lookOf(slot: Slot): Look {
  const word = slot.tool ?? slot.id.split("/").pop()!;
  const known = kLooks[`${slot.op} ${slot.id}`] ?? kByName[word];
  if (known) return known;
  const text = word.replace(/_/g, " ");
  return { title: text[0]!.toUpperCase() + text.slice(1), keys: "", ...kByGeometry[slot.geometry] };
}

/** What a drawn thing is called: "Ridge", "Wind", "Raise stroke". */
export function nounOf(slot: Slot): string {
  const { title, done } = lookOf(slot);
  const words = done.split(" ").slice(0, -1).join(" ");
  return slot.brush || words === "" ? `${title}: stroke` : words[0]!.toUpperCase() + words.slice(1);
}

/** Regions of labels in their order, and how they are called. */
export const kRegions = ["mountain", "beach", "lagoon", "reef", "abyss"] as const;
export type Region = (typeof kRegions)[number];
