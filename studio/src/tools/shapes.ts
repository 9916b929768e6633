// How the drawing looks over the ground: every drawn thing in its role, what is selected with handles.
import type { OverlayShape, Role } from "../viewport/types";
import { itemMembers, type Feature } from "./features";
import { distance, mix, segments, type Point } from "./geometry";
import { isClosed } from "./hit";
import { kRegions, lookOf } from "./names";
import { ringOf, roleOfOutline, type Radii } from "./polar";

function roleOf(feature: Feature): Role {
  const region = itemMembers(feature)["region"];
  const named = kRegions.find((name) => name === region);
  if (named && feature.slot.op === "classify.paint") return named;
  return lookOf(feature.slot).role;
}

function labelOf(feature: Feature): string | undefined {
  const item = itemMembers(feature);
  if (typeof item["height_m"] === "number") return `${Math.round(item["height_m"])} m`;
  for (const name of ["name", "class"]) if (typeof item[name] === "string" && item[name] !== "") return item[name];
  return undefined;
}

function lineShapes(feature: Feature, role: Role, selected: boolean): OverlayShape[] {
  const { points, slot } = feature;
  if (points.length === 1) return [{ shape: "dot", at: points[0]!, role }];
  const width_px = selected ? 3 : slot.brush ? 1.25 : 2.25;
  const line: OverlayShape = { shape: "line", points, role, width_px };
  const arrow = slot.id.endsWith("strokes") || slot.tool === "current" || slot.tool === "warp" || slot.id === "rivers";
  return arrow ? [line, ...headOf(points, role, width_px)] : [line];
}

/** The head of an arrow at a line's end. */
function headOf(points: readonly Point[], role: Role, width_px: number, share = 0.03): OverlayShape[] {
  const [a, b] = [points[points.length - 2]!, points[points.length - 1]!];
  const way = distance(a, b);
  if (way === 0) return [];
  const size = totalLength(points) * share;
  const [ux, uy] = [(b[0] - a[0]) / way, (b[1] - a[1]) / way];
  const wing = (side: number): Point => [
    b[0] - size * ux - side * size * 0.55 * uy, b[1] - size * uy + side * size * 0.55 * ux,
  ];
  return [{ shape: "line", points: [wing(1), b, wing(-1)], role, width_px }];
}

function totalLength(points: readonly Point[]): number {
  return points.slice(1).reduce((sum, p, i) => sum + distance(p, points[i]!), 0);
}

function placeShapes(feature: Feature, role: Role, selected: boolean): OverlayShape[] {
  const [at, end] = feature.points;
  const label = labelOf(feature);
  const shapes: OverlayShape[] = [
    { shape: "dot", at: at!, role: selected ? "selected" : role, ...(label ? { label } : {}), handle: selected },
  ];
  const radius = itemMembers(feature)["radius_m"];
  if (typeof radius === "number" && radius < 1e5) shapes.push({ shape: "circle", at: at!, radius_m: radius, role });
  if (end && distance(at!, end) > 0) {
    shapes.unshift({ shape: "line", points: [at!, end], role, width_px: 2 }, ...headOf([at!, end], role, 2, 0.2));
    shapes.push({ shape: "dot", at: end, role: "handle", handle: true });
  }
  return shapes;
}

/** Of more points the handles between them would be a string of pearls; they are found by the pointer all the same. */
const kMostWithMiddles = 16;

function handles(feature: Feature, points: ReadonlySet<string>): OverlayShape[] {
  const shapes: OverlayShape[] = [];
  const room = feature.points.length <= kMostWithMiddles;
  for (let i = 0; room && i < segments(feature.points.length, isClosed(feature)); ++i) {
    shapes.push(
      {
        shape: "dot", at: mix(feature.points[i]!, feature.points[(i + 1) % feature.points.length]!, 0.5), role: "guide",
      },
    );
  }
  feature.points.forEach((at, i) => {
    shapes.push({ shape: "dot", at, role: points.has(`${feature.key} ${i}`) ? "selected" : "handle", handle: true });
  });
  return shapes;
}

/** `editing`: points can be taken hold of, so they are shown. */
export function featureShapes(
  features: readonly Feature[], selected: ReadonlySet<string>, points: ReadonlySet<string>, editing: boolean,
): OverlayShape[] {
  const shapes: OverlayShape[] = [];
  const over: OverlayShape[] = [];
  for (const feature of features) {
    const chosen = selected.has(feature.key);
    const role = roleOf(feature);
    if (feature.geometry === "place" || feature.geometry === "vector") over.push(...placeShapes(feature, role, chosen));
    else if (feature.geometry === "line") shapes.push(...lineShapes(feature, chosen ? "selected" : role, chosen));
    else {
      shapes.push({ shape: "area", points: feature.points, role });
      shapes.push(
        {
          shape: "line", points: feature.points, role: chosen ? "selected" : role, closed: true,
          width_px: chosen ? 3 : 2,
        },
      );
      const label = labelOf(feature);
      if (label) over.push({ shape: "dot", at: feature.points[0]!, role, label });
    }
    if (
      editing && chosen && feature.points.length > 1 && feature.geometry !== "vector"
    ) over.push(...handles(feature, points));
  }
  return [...shapes, ...over];
}

export function outlineShapes(outlines: readonly Radii[], centre: Point): OverlayShape[] {
  return outlines.map((radii, i) => ({
    shape: "line", points: ringOf(radii, centre), closed: true, role: roleOfOutline(i, outlines.length), width_px: 2,
  }));
}
