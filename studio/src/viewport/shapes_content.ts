// Drawings, contours, networks and objects that a step makes, as shapes over the ground. Pure.
import type { Json } from "../api/types";
import type { OverlayShape, Role } from "./types";

type Members = { [key: string]: Json };
type Point = readonly [number, number];

const members = (value: Json | undefined): Members => (value !== null && typeof value === "object" && !Array.isArray(value) ? value : {});
const list = (value: Json | undefined): Json[] => (Array.isArray(value) ? value : []);

function point(value: Json): Point | null {
  const [x, y] = list(value);
  return typeof x === "number" && typeof y === "number" ? [x, y] : null;
}

function line(value: Json): Point[] {
  return list(value).map(point).filter((at): at is Point => at !== null);
}

/** Kinds of values that have shapes, and how they are drawn. */
export const shapeRoles: { [kind: string]: Role } = { contours: "contour", drawing: "guide", tin: "guide", objects: "height" };

/** Kinds with so many lines, all alike, that they are drawn as one. */
const alike: readonly string[] = ["tin", "contours"];

type Lines = Extract<OverlayShape, { shape: "lines" }>["lines"];

/** Shapes of a FeatureCollection; lines that have nothing to say of their own are thin. */
export function shapesOf(answer: Json, kind: string): OverlayShape[] {
  const role = shapeRoles[kind] ?? "guide", width_px = kind === "tin" ? 0.75 : 1.25;
  const solid: Role = role === "guide" ? "ink" : role;
  const lines = (parts: Lines): OverlayShape => ({ shape: "lines", lines: parts, role: solid, width_px });
  const put = (type: Json | undefined, at: Json | undefined): OverlayShape[] => {
    switch (type) {
      case "Point": {
        const place = point(at ?? null);
        return place === null ? [] : [{ shape: "dot", at: place, role: solid }];
      }
      case "LineString":
        return [{ shape: "line", points: line(at ?? null), role: solid, width_px }];
      case "MultiLineString":
        return [lines(list(at).map(line))];
      case "Polygon":
        return list(at).map((ring) => ({ shape: "line", points: line(ring), role: solid, width_px, closed: true }));
      case "MultiPolygon":
        return list(at).flatMap((part) => put("Polygon", part));
      default:
        return [];
    }
  };
  const shapes = list(members(answer)["features"]).flatMap((feature) => {
    const { type, coordinates } = members(members(feature)["geometry"]);
    return put(type, coordinates);
  });
  if (!alike.includes(kind)) return shapes;
  return [lines(shapes.flatMap((shape) => (shape.shape === "line" ? [shape.points] : shape.shape === "lines" ? shape.lines : [])))];
}
