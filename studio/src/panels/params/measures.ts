// What a drawn parameter amounts to: how many shapes, how long, how large.
import type { Json, ParamKind } from "../../api/types";
import { areaText, counted, distanceText, numberText } from "./words";

type Point = readonly [number, number];

function isPoint(value: Json | undefined): value is [number, number] {
  return Array.isArray(value) && value.length >= 2 && typeof value[0] === "number" && typeof value[1] === "number";
}

function pointsOf(value: Json | undefined): Point[] {
  return Array.isArray(value) ? value.filter(isPoint) : [];
}

function member(value: Json, name: string): Json | undefined {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value[name] : undefined;
}

export function lengthOf(points: readonly Point[]): number {
  let sum = 0;
  for (let i = 1; i < points.length; ++i)
    sum += Math.hypot(points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1]);
  return sum;
}

export function areaOf(ring: readonly Point[]): number {
  let twice = 0;
  ring.forEach(([x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length]!;
    twice += x * nextY - nextX * y;
  });
  return Math.abs(twice) / 2;
}

/** Points of a stroke, line or river, which may stand in a group: {points: [...]}. */
function lineOf(item: Json): Point[] {
  return pointsOf(member(item, "points") ?? item);
}

function ringArea(item: Json): number {
  const outer = areaOf(pointsOf(member(item, "outer") ?? member(item, "ring") ?? item));
  const holes = member(item, "holes");
  return outer - (Array.isArray(holes) ? holes.reduce((sum: number, hole) => sum + areaOf(pointsOf(hole)), 0) : 0);
}

/** "2 strokes, 14.2 km"; "none". */
export function drawnText(kind: ParamKind, value: Json | undefined): string {
  const items = Array.isArray(value) ? value : [];
  if (items.length === 0) return "none";
  const length = () => distanceText(items.reduce((sum: number, item) => sum + lengthOf(lineOf(item)), 0));
  const area = () => areaText(items.reduce((sum: number, item) => sum + ringArea(item), 0));
  switch (kind) {
    case "points": {
      const points = pointsOf(value);
      return points.length > 1 ? `${counted(points.length, "point")}, ${distanceText(lengthOf(points))}`
        : counted(points.length, "point");
    }
    case "strokes": return `${counted(items.length, "stroke")}, ${length()}`;
    case "rivers": return `${counted(items.length, "river")}, ${length()}`;
    case "polygons": return `${counted(items.length, "area")}, ${area()}`;
    case "regions": return `${counted(items.length, "region")}, ${area()}`;
    case "outlines": return outlinesText(items);
    default: return counted(items.length, "item");
  }
}

/** Polar outlines: radii, of the coast alone or of each region. */
function outlinesText(items: Json[]): string {
  const rings = items.every((item) => typeof item === "number") ? [items] : items;
  const radii = rings.flat().filter((radius): radius is number => typeof radius === "number");
  const widest = radii.length > 0 ? `, up to ${numberText(Math.max(...radii))} m` : "";
  return `${counted(rings.length, "outline")}${widest}`;
}
