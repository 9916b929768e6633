// Where a ray meets the ground: down the tree of least and greatest heights, nearest blocks first.
import { blockCells, type HeightField } from "./heights";

export interface Ray {
  /** Metres of the document's system; heights as they are, without exaggeration. */
  from: readonly [number, number, number];
  to: readonly [number, number, number];
}

interface Walk {
  field: HeightField;
  /** Start and direction in block coordinates, heights in metres. */
  u: number;
  v: number;
  z: number;
  du: number;
  dv: number;
  dz: number;
  floor: number;
}

/** Parameter (0 at from, 1 at to, beyond it too) of the first place where the ray is not above max(height, floor). */
export function pick(field: HeightField, ray: Ray, floor = -Infinity): number | null {
  const cell = field.frame.cell_m;
  const walk: Walk = {
    field,
    u: (ray.from[0] - field.frame.west) / cell,
    v: (field.frame.north - ray.from[1]) / cell,
    z: ray.from[2],
    du: (ray.to[0] - ray.from[0]) / cell,
    dv: (ray.from[1] - ray.to[1]) / cell,
    dz: ray.to[2] - ray.from[2],
    floor,
  };
  return descend(walk, field.tree.length - 1, 0, 0, 0, Infinity);
}

function slab(at: number, along: number, low: number, high: number, span: [number, number]): boolean {
  if (Math.abs(along) < 1e-12) return at >= low && at <= high;
  const a = (low - at) / along, b = (high - at) / along;
  span[0] = Math.max(span[0], Math.min(a, b));
  span[1] = Math.min(span[1], Math.max(a, b));
  return span[0] <= span[1];
}

function descend(w: Walk, level: number, x: number, y: number, begin: number, end: number): number | null {
  const tree = w.field.tree[level]!;
  if (x >= tree.columns || y >= tree.rows) return null;
  const size = blockCells * 2 ** level, i = y * tree.columns + x;
  const span: [number, number] = [begin, end];
  if (!slab(w.u, w.du, x * size, Math.min(w.field.columns, (x + 1) * size), span)) return null;
  if (!slab(w.v, w.dv, y * size, Math.min(w.field.rows, (y + 1) * size), span)) return null;
  // Below the block's lowest ground is inside it, too: a ray may enter through the side.
  const highest = Math.max(w.floor, tree.high[i]!);
  if (!slab(w.z, w.dz, -1e12, highest, span)) return null;
  if (level === 0) return march(w, span[0], span[1]);
  const first = (w.du < 0 ? 1 : 0) + (w.dv < 0 ? 2 : 0);
  let best: number | null = null;
  for (const order of [0, 1, 2, 3]) {
    const child = order ^ first;
    const met = descend(w, level - 1, 2 * x + (child & 1), 2 * y + (child >> 1), span[0], best ?? span[1]);
    if (met !== null && (best === null || met < best)) best = met;
    if (best !== null && order === 0) return best;
  }
  return best;
}

function above(w: Walk, t: number): number {
  return w.z + t * w.dz - w.field.surface(w.u + t * w.du, w.v + t * w.dv, w.floor);
}

function march(w: Walk, begin: number, end: number): number | null {
  if (above(w, begin) <= 0) return begin;
  const steps = Math.max(1, Math.ceil(2 * Math.hypot(w.du, w.dv) * (end - begin)));
  let before = begin;
  for (let k = 1; k <= Math.min(steps, 64); ++k) {
    const t = begin + ((end - begin) * k) / Math.min(steps, 64);
    if (above(w, t) <= 0) return bisect(w, before, t);
    before = t;
  }
  return null;
}

function bisect(w: Walk, out: number, inside: number): number {
  for (let k = 0; k < 24; ++k) {
    const middle = 0.5 * (out + inside);
    if (above(w, middle) <= 0) inside = middle;
    else out = middle;
  }
  return inside;
}
