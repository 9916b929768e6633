// What of the drawn things is under the pointer.
import type { Feature } from "./features";
import { distance, insideRing, mix, ringArea, segments, toSegment, type Point } from "./geometry";

/** How near is near, in screen pixels. */
export const kReach_px = 12;

export type Hit = { feature: Feature } & (
  | { part: "point"; index: number }
  /** The small handle in the middle of a segment: dragging it makes a point. */
  | { part: "middle"; segment: number; share: number; at: Point }
  | { part: "segment"; segment: number; share: number; at: Point }
  | { part: "inside" }
);

export function isClosed(feature: Feature): boolean {
  return feature.geometry === "ring";
}

function nearestPoint(features: readonly Feature[], at: Point, reach: number): Hit | null {
  let best: Hit | null = null;
  let least = reach;
  for (const feature of features) {
    feature.points.forEach((point, index) => {
      const far = distance(point, at);
      if (far <= least) [best, least] = [{ feature, part: "point", index }, far];
    });
  }
  return best;
}

function nearestSegment(
  features: readonly Feature[], at: Point, reach: number, part: "middle" | "segment",
): Hit | null {
  let best: Hit | null = null;
  let least = reach;
  for (const feature of features) {
    if (feature.geometry === "place" || (part === "middle" && feature.geometry === "vector")) continue;
    const { points } = feature;
    for (let segment = 0; segment < segments(points.length, isClosed(feature)); ++segment) {
      const [a, b] = [points[segment]!, points[(segment + 1) % points.length]!];
      const near = part === "middle" ? { distance: distance(at, mix(a, b, 0.5)), share: 0.5 } : toSegment(at, a, b);
      if (part === "middle" && distance(a, b) < 3 * reach) continue;  // no room between its ends
      if (near.distance > least) continue;
      [best, least] = [{ feature, part, segment, share: near.share, at: mix(a, b, near.share) }, near.distance];
    }
  }
  return best;
}

/** Points of what is selected first, then the handles between them, then any line, then the smallest area around. */
export function hitTest(
  features: readonly Feature[], selected: ReadonlySet<string>, at: Point, pixel_m: number, insides = true,
): Hit | null {
  const reach = kReach_px * pixel_m;
  const chosen = features.filter((feature) => selected.has(feature.key));
  const places = features.filter((feature) => feature.geometry === "place" || feature.geometry === "vector");
  const hit =
    nearestPoint(chosen, at, reach) ??
    nearestPoint(places, at, reach) ??
    nearestSegment(chosen, at, reach * 0.6, "middle") ??
    nearestSegment(features, at, reach, "segment");
  if (hit || !insides) return hit;
  const around = features.filter(
    (feature) => feature.geometry === "ring" && !feature.hole && insideRing(at, feature.points),
  );
  around.sort((a, b) => Math.abs(ringArea(a.points)) - Math.abs(ringArea(b.points)));
  return around[0] ? { feature: around[0], part: "inside" } : null;
}

/** Features that lie wholly in a box. */
export function insideBox(features: readonly Feature[], a: Point, b: Point): Feature[] {
  const within = ([x, y]: Point) =>
    x >= Math.min(a[0], b[0]) && x <= Math.max(a[0], b[0]) && y >= Math.min(a[1], b[1]) && y <= Math.max(a[1], b[1]);
  return features.filter((feature) => feature.points.every(within));
}
