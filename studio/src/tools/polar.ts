// Outlines of an island as radii around a centre: dragged with a soft brush, kept in their order.
import type { Json } from "../api/types";
import type { Raster } from "../viewport/types";
import { distance, rounded, type Point } from "./geometry";
import type { Role } from "../viewport/types";

/** Radii at equal steps of the angle, counter-clockwise from east. */
export type Radii = readonly number[];

export const kRadii = 48;
const kNames: readonly Role[] = ["mountain", "beach", "lagoon", "reef", "abyss"];

/** Which outline it is: of one the coast, of five the regions from the inside out. */
export function roleOfOutline(index: number, count: number): Role {
  return count === 1 ? "coast" : (kNames[index] ?? "coast");
}

export function readOutlines(value: Json | undefined): Radii[] {
  if (!Array.isArray(value)) return [];
  const outlines = value.map((item) => (typeof item === "number" ? [item] : item));
  const numbers = (item: Json): item is number[] => Array.isArray(item) && item.length > 0
    && item.every((r) => typeof r === "number");
  return outlines.every(numbers) ? (outlines as number[][]) : [];
}

export function writeOutlines(outlines: readonly Radii[]): Json {
  return outlines.map((radii) => (radii.every((r) => r === radii[0]) ? radii[0]! : [...radii]));
}

/** Radius at an angle, straight between the given ones. */
export function radiusAt(radii: Radii, angle: number): number {
  const turns = angle / (2 * Math.PI);
  const at = (turns - Math.floor(turns)) * radii.length;
  const low = Math.floor(at) % radii.length;
  return radii[low]! + (radii[(low + 1) % radii.length]! - radii[low]!) * (at - Math.floor(at));
}

export function angleOf(at: Point, centre: Point): number {
  return Math.atan2(at[1] - centre[1], at[0] - centre[0]);
}

/** At least so many radii, so that a brush has something to move. */
export function finer(radii: Radii, count = kRadii): number[] {
  if (radii.length >= count) return [...radii];
  return Array.from({ length: count }, (_, i) => radiusAt(radii, (2 * Math.PI * i) / count));
}

export function ringOf(radii: Radii, centre: Point, least = 96): Point[] {
  const all = finer(radii, least);
  return all.map((r, i) => {
    const angle = (2 * Math.PI * i) / all.length;
    return [centre[0] + r * Math.cos(angle), centre[1] + r * Math.sin(angle)];
  });
}

/** Which outline passes nearest to a place. */
export function nearestOutline(outlines: readonly Radii[], at: Point, centre: Point): number {
  const far = distance(at, centre);
  const angle = angleOf(at, centre);
  let best = 0;
  outlines.forEach((radii, i) => {
    if (Math.abs(radiusAt(radii, angle) - far) < Math.abs(radiusAt(outlines[best]!, angle) - far)) best = i;
  });
  return best;
}

interface Drag {
  outline: number;
  from: Point;
  to: Point;
  centre: Point;
  /** Half width of the brush along the outline. */
  radius_m: number;
  smooth: boolean;
  /** Numbers are rounded to it. */
  step: number;
}

/** Share of a drag that a place at this distance from the brush's middle follows. */
export function softly(share: number): number {
  return share >= 1 ? 0 : (1 - share * share) ** 2;
}

/** The outlines after a drag; neighbouring outlines are pushed along rather than crossed. */
export function dragOutline(outlines: readonly Radii[], drag: Drag): number[][] {
  const count = Math.max(kRadii, ...outlines.map((radii) => radii.length));
  const result = outlines.map((radii) => finer(radii, count));
  const moved = result[drag.outline]!;
  const change = distance(drag.to, drag.centre) - distance(drag.from, drag.centre);
  const middle = angleOf(drag.from, drag.centre);
  const before = [...moved];
  const reach = Math.max(distance(drag.from, drag.centre), drag.step);
  before.forEach((radius, i) => {
    const apart = Math.abs(((2 * Math.PI * i) / count - middle + 3 * Math.PI) % (2 * Math.PI) - Math.PI);
    const weight = softly((apart * reach) / Math.max(drag.radius_m, (Math.PI * reach * 1.01) / count));
    const mean = (before[(i + count - 1) % count]! + before[(i + 1) % count]!) / 2;
    const to = drag.smooth ? radius + (mean - radius) * weight : radius + change * weight;
    moved[i] = rounded(Math.max(10 * drag.step, to), drag.step);
  });
  for (let i = 0; i < count; ++i) {
    for (let k = drag.outline + 1; k < result.length; ++k) {
      result[k]![i] = Math.max(result[k]![i]!, result[k - 1]![i]! + drag.step);
    }
    for (let k = drag.outline - 1; k >= 0; --k) result[k]![i] = Math.max(
      drag.step, Math.min(result[k]![i]!, result[k + 1]![i]! - drag.step),
    );
  }
  return result;
}

/** The coast that a label map shows around a centre: the outermost land in each direction; null where there is none. */
export function coastOf(labels: Raster, centre: Point, step: number): number[] | null {
  const { frame, values } = labels;
  const isLand = (x: number, y: number) => {
    const column = Math.floor((x - frame.west) / frame.cell_m);
    const row = Math.floor((frame.north - y) / frame.cell_m);
    const inside = column >= 0 && row >= 0 && column < frame.columns && row < frame.rows;
    return inside && values[row * frame.columns + column]! <= 1;
  };
  const farthest = Math.hypot(frame.columns, frame.rows) * frame.cell_m;
  const radii = Array.from({ length: kRadii }, (_, i) => {
    const angle = (2 * Math.PI * i) / kRadii;
    let radius = 0;
    for (let r = 0; r < farthest; r += frame.cell_m / 2) {
      if (isLand(centre[0] + r * Math.cos(angle), centre[1] + r * Math.sin(angle))) radius = r;
    }
    return rounded(radius, step);
  });
  return radii.every((r) => r > 0) ? radii : null;
}
