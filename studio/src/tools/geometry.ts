// Plane geometry for what is drawn: distances, lengths, fewer points, rings that do not cross themselves. Metres.

export type Point = readonly [number, number];

export function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

export function mix(a: Point, b: Point, share: number): Point {
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share];
}

export function moved(points: readonly Point[], dx: number, dy: number): Point[] {
  return points.map(([x, y]) => [x + dx, y + dy]);
}

/** Distance of a place from a segment, and where on it the nearest point lies, 0 to 1. */
export function toSegment(p: Point, a: Point, b: Point): { distance: number; share: number } {
  const dx = b[0] - a[0];
  const dy = b[1] - a[1];
  const squared = dx * dx + dy * dy;
  const share = squared > 0 ? Math.min(1, Math.max(0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / squared)) : 0;
  return { distance: Math.hypot(p[0] - a[0] - share * dx, p[1] - a[1] - share * dy), share };
}

/** Number of segments: one more where the line is closed. */
export function segments(count: number, closed: boolean): number {
  return closed && count > 2 ? count : Math.max(0, count - 1);
}

export function lengthOf(points: readonly Point[], closed = false): number {
  let sum = 0;
  const count = points.length;
  for (let i = 0; i < segments(count, closed); ++i) sum += distance(points[i]!, points[(i + 1) % count]!);
  return sum;
}

/** Above 0 where the ring runs counter-clockwise. */
export function ringArea(ring: readonly Point[]): number {
  let twice = 0;
  ring.forEach(([x, y], i) => {
    const next = ring[(i + 1) % ring.length]!;
    twice += x * next[1] - next[0] * y;
  });
  return twice / 2;
}

export function insideRing([x, y]: Point, ring: readonly Point[]): boolean {
  let inside = false;
  for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
    const [ax, ay] = ring[i]!;
    const [bx, by] = ring[j]!;
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}

/** Where two segments cross, each at a share of its length; null where they do not. */
function crossing(a: Point, b: Point, c: Point, d: Point): Point | null {
  const ux = b[0] - a[0];
  const uy = b[1] - a[1];
  const vx = d[0] - c[0];
  const vy = d[1] - c[1];
  const cross = ux * vy - uy * vx;
  if (cross === 0) return null;
  const s = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / cross;
  const t = ((c[0] - a[0]) * uy - (c[1] - a[1]) * ux) / cross;
  return s > 0 && s < 1 && t > 0 && t < 1 ? mix(a, b, s) : null;
}

/** A ring drawn by hand often crosses itself where it ends: of the two loops at each crossing the larger one stays. */
export function simpleRing(ring: readonly Point[]): Point[] {
  let points = [...ring];
  for (let round = 0; round < 32; ++round) {
    const cut = firstCrossing(points);
    if (!cut) break;
    const loop = [cut.at, ...points.slice(cut.first + 1, cut.second + 1)];
    const rest = [cut.at, ...points.slice(cut.second + 1), ...points.slice(0, cut.first + 1)];
    points = Math.abs(ringArea(loop)) > Math.abs(ringArea(rest)) ? loop : rest;
  }
  return points;
}

function firstCrossing(ring: readonly Point[]): { first: number; second: number; at: Point } | null {
  const count = ring.length;
  for (let i = 0; i < count; ++i) {
    for (let j = i + 2; j < count; ++j) {
      if (i === 0 && j === count - 1) continue;
      const at = crossing(ring[i]!, ring[i + 1]!, ring[j]!, ring[(j + 1) % count]!);
      if (at) return { first: i, second: j, at };
    }
  }
  return null;
}

/** Indices of the points that Douglas and Peucker keep; `apart(p, a, b)` says how far p lies from the segment ab. */
export function keptPoints<P>(points: readonly P[], tolerance: number, apart: (p: P, a: P, b: P) => number): number[] {
  if (points.length < 3) return points.map((_, i) => i);
  const keep = new Set([0, points.length - 1]);
  const open: [number, number][] = [[0, points.length - 1]];
  for (let span = open.pop(); span; span = open.pop()) {
    const [from, to] = span;
    let farthest = from;
    let most = tolerance;
    for (let i = from + 1; i < to; ++i) {
      const far = apart(points[i]!, points[from]!, points[to]!);
      if (far > most) [farthest, most] = [i, far];
    }
    if (farthest === from) continue;
    keep.add(farthest);
    open.push([from, farthest], [farthest, to]);
  }
  return [...keep].sort((a, b) => a - b);
}

/** Fewer points, none of those left out further than `tolerance` from the rest. */
export function simplified(points: readonly Point[], tolerance: number, closed = false): Point[] {
  const apart = (p: Point, a: Point, b: Point) => toSegment(p, a, b).distance;
  if (!closed) return keptPoints(points, tolerance, apart).map((i) => points[i]!);
  if (points.length < 4) return [...points];
  let far = 0;
  points.forEach((p, i) => {
    if (distance(p, points[0]!) > distance(points[far]!, points[0]!)) far = i;
  });
  const halves = [points.slice(0, far + 1), [...points.slice(far), points[0]!]];
  return halves.flatMap((half) => keptPoints(half, tolerance, apart).map((i) => half[i]!).slice(0, -1));
}

/** The ring and its detail rounded off: each point moves to the mean of itself and its neighbours. */
export function smoothed(points: readonly Point[], closed: boolean, strength = 1): Point[] {
  const count = points.length;
  return points.map((p, i) => {
    if (!closed && (i === 0 || i === count - 1)) return p;
    const before = points[(i + count - 1) % count]!;
    const after = points[(i + 1) % count]!;
    return mix(p, [(before[0] + 2 * p[0] + after[0]) / 4, (before[1] + 2 * p[1] + after[1]) / 4], strength);
  });
}

/** A decimal step no coarser than a quarter of a tolerance, so that numbers in recipes stay short: 0.1, 1, 10 m. */
export function roundingStep(tolerance: number): number {
  return 10 ** Math.floor(Math.log10(Math.max(1e-6, tolerance / 2)));
}

export function rounded(value: number, step: number): number {
  return step >= 1 ? Math.round(value / step) * step : Number((Math.round(value / step) * step).toFixed(6));
}

export function roundedPoint([x, y]: Point, step: number): Point {
  return [rounded(x, step), rounded(y, step)];
}
