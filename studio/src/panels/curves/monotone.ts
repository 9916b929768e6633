// Curves through knots as the library runs them (geom/scalar/curve.h): monotone cubic after Fritsch and Carlson 1980
// with the slopes of Fritsch and Butland 1984, or linear; constant beyond the first and the last knot.

export type Knot = readonly [x: number, y: number];
export type CurveKind = "monotone_cubic" | "linear";

const secant = (a: Knot, b: Knot): number => (b[1] - a[1]) / (b[0] - a[0]);

function innerSlope(before: Knot, at: Knot, after: Knot): number {
  const left = secant(before, at);
  const right = secant(at, after);
  if (left * right <= 0) return 0;
  const wLeft = 2 * (after[0] - at[0]) + (at[0] - before[0]);
  const wRight = after[0] - at[0] + 2 * (at[0] - before[0]);
  return (wLeft + wRight) / (wLeft / left + wRight / right);
}

function endSlope(hNear: number, hFar: number, near: number, far: number): number {
  const slope = ((2 * hNear + hFar) * near - hNear * far) / (hNear + hFar);
  if (slope * near <= 0) return 0;
  if (near * far <= 0 && Math.abs(slope) > 3 * Math.abs(near)) return 3 * near;
  return slope;
}

function slopes(knots: readonly Knot[]): number[] {
  const n = knots.length;
  const k = (i: number): Knot => knots[i]!;
  if (n < 2) return knots.map(() => 0);
  if (n === 2) return [secant(k(0), k(1)), secant(k(0), k(1))];
  const found = knots.map((knot, i) => (i === 0 || i === n - 1 ? 0 : innerSlope(k(i - 1), knot, k(i + 1))));
  found[0] = endSlope(k(1)[0] - k(0)[0], k(2)[0] - k(1)[0], secant(k(0), k(1)), secant(k(1), k(2)));
  found[n - 1] = endSlope(k(n - 1)[0] - k(n - 2)[0], k(n - 2)[0] - k(n - 3)[0], secant(k(n - 2), k(n - 1)),
    secant(k(n - 3), k(n - 2)));
  return found;
}

/** The function through knots whose x ascend; of none it is 0. */
export function curveFunction(knots: readonly Knot[], kind: CurveKind = "monotone_cubic"): (x: number) => number {
  const first = knots[0];
  const last = knots[knots.length - 1];
  if (!first || !last) return () => 0;
  const m = kind === "linear" ? null : slopes(knots);
  return (x) => {
    if (!(x > first[0])) return first[1];
    if (x >= last[0]) return last[1];
    let i = 0;
    while (knots[i + 1]![0] <= x) ++i;
    const a = knots[i]!;
    const b = knots[i + 1]!;
    const h = b[0] - a[0];
    const t = (x - a[0]) / h;
    if (m === null) return a[1] + t * (b[1] - a[1]);
    const s = 1 - t;
    const value = s * s * (1 + 2 * t) * a[1] + t * t * (3 - 2 * t) * b[1] + h * t * s * (s * m[i]! - t * m[i + 1]!);
    return Math.min(Math.max(value, Math.min(a[1], b[1])), Math.max(a[1], b[1]));
  };
}
