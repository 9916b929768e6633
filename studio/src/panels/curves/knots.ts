// Changes to the knots of a curve: each gives new knots whose x ascend and whose values keep to the bounds.
import { type CurveKind, type Knot, curveFunction } from "./monotone";

export interface CurveBounds {
  x: readonly [number, number];
  y: readonly [number, number];
  /** Least distance of two knots along x. */
  apart: number;
}

const clamp = (value: number, [low, high]: readonly [number, number]): number => Math.min(high, Math.max(low, value));
const tidy = (value: number): number => Number(value.toPrecision(6));

/** A knot elsewhere, between its neighbours. Of a curve that `keepsEnds` the first and last keep their x. */
export function moved(knots: readonly Knot[], index: number, to: Knot, bounds: CurveBounds, keepsEnds = false): Knot[] {
  const left = knots[index - 1];
  const right = knots[index + 1];
  const fixed = keepsEnds && (!left || !right);
  const x = fixed ? knots[index]![0]
    : clamp(to[0], [left ? left[0] + bounds.apart : bounds.x[0], right ? right[0] - bounds.apart : bounds.x[1]]);
  return knots.map((knot, i) => (i === index ? [tidy(x), tidy(clamp(to[1], bounds.y))] as const : knot));
}

/** A knot more; null where one is too near. */
export function added(knots: readonly Knot[], at: Knot, bounds: CurveBounds): { knots: Knot[]; index: number } | null {
  const x = clamp(at[0], bounds.x);
  if (knots.some((knot) => Math.abs(knot[0] - x) < bounds.apart)) return null;
  const index = knots.filter((knot) => knot[0] < x).length;
  const knot: Knot = [tidy(x), tidy(clamp(at[1], bounds.y))];
  return { knots: [...knots.slice(0, index), knot, ...knots.slice(index)], index };
}

/** A knot on the curve, in the middle of the widest gap next to `index`. */
export function split(knots: readonly Knot[], index: number, bounds: CurveBounds,
                      kind: CurveKind): { knots: Knot[]; index: number } | null {
  const here = knots[index]?.[0] ?? bounds.x[0];
  const left = knots[index - 1]?.[0] ?? bounds.x[0];
  const right = knots[index + 1]?.[0] ?? bounds.x[1];
  const x = right - here >= here - left ? (here + right) / 2 : (here + left) / 2;
  return added(knots, [x, curveFunction(knots, kind)(x)], bounds);
}

export function removed(knots: readonly Knot[], index: number): Knot[] {
  return knots.filter((_, i) => i !== index);
}

/** Reads a parameter's value; what is no knot is left out. */
export function readKnots(value: unknown): Knot[] {
  if (!Array.isArray(value)) return [];
  return value.filter((knot): knot is [number, number] =>
    Array.isArray(knot) && typeof knot[0] === "number" && typeof knot[1] === "number");
}
