// Which patches of ground are drawn, and how finely: a quadtree over the height field (CDLOD: F. Strugar, "Continuous
// distance-dependent level of detail for rendering heightmaps", 2010). A patch is a grid of patchCells by patchCells;
// one of level l has a vertex every 2^l cells and morphs into the grid of level l + 1 towards the end of its range, so
// that neighbours meet. Where a part of the ground is known more finely there are patches of levels below 0, in that
// part and beside it alike: what is drawn is one surface, and neighbours meet there as everywhere. Blocks that lie
// wholly under the sea are left out where the sea hides them.
import type { DetailGround } from "./detail_ground";
import { blockCells, type HeightField } from "./heights";

export const patchCells = 16;
/** The finest patch is a block of this level of the height field's tree. */
const leafLevel = Math.log2(patchCells / blockCells);
/** Ranges in sides of a patch: below 6 neighbours would not meet. */
const leastRange = 6;
const morphBegin = 0.78;

export interface PatchView {
  /** Metres east and south of the north-west corner; heights exaggerated. */
  eye: readonly [number, number, number];
  /** Planes a x + b y + c z + d >= 0 around what is seen, in the same system; four numbers each. */
  planes: ArrayLike<number>;
  exaggeration: number;
  /** Nothing below is drawn but dry ground: 0 where there is water, else -Infinity. */
  floor: number;
  /** About so many patches are wanted at most. */
  budget: number;
  /** The ground is cut at its edges, under water too. */
  walls?: boolean;
  /** Part of the ground that is known more finely. */
  detail?: DetailGround | null;
}

/** Per patch: west, north (cells from the corner), side (cells), begin and end of its morphing (metres). */
export const patchNumbers = 5;

export interface Patches {
  count: number;
  numbers: Float32Array;
}

const most = 1024;

export function choosePatches(
  field: HeightField, view: PatchView, into = new Float32Array(most * patchNumbers),
): Patches {
  // As finely as the budget allows.
  let range = 16, finest = -(view.detail?.levels ?? 0);
  for (;;) {
    const count = choose(field, view, range, finest, into);
    if (count <= view.budget || (range <= leastRange && finest === 0)) {
      return { count: Math.min(count, most), numbers: into };
    }
    if (range <= leastRange) ++finest;
    else range = Math.max(leastRange, range * Math.max(0.6, Math.min(0.95, Math.sqrt(view.budget / count))));
  }
}

function choose(field: HeightField, view: PatchView, range: number, finest: number, into: Float32Array): number {
  const top = Math.max(0, field.tree.length - 1 - leafLevel);
  const cell = field.frame.cell_m;
  let count = 0;
  const rangeOf = (level: number): number => range * patchCells * 2 ** level * cell;

  const put = (level: number, x: number, y: number): void => {
    if (count < most) {
      const side = patchCells * 2 ** level, end = rangeOf(level);
      into.set(
        [x * side, y * side, side, level === top ? 1e12 : morphBegin * end, level === top ? 2e12 : end],
        count * patchNumbers,
      );
    }
    ++count;
  };

  const visit = (level: number, x: number, y: number): void => {
    // Patches smaller than the tree's finest blocks lie in one of them.
    const of = Math.max(0, Math.min(field.tree.length - 1, level + leafLevel)), tree = field.tree[of]!;
    const part = Math.max(0, -level - leafLevel), column = x >> part, row = y >> part;
    if (column >= tree.columns || row >= tree.rows) return;
    const i = row * tree.columns + column, side = patchCells * 2 ** level * cell;
    let least = tree.low[i]!, greatest = tree.high[i]!;
    const dry = tree.dry?.[i] === 1 || (view.detail?.field.dry ?? null) !== null, floor = dry ? -Infinity : view.floor;
    if (view.detail) [least, greatest] = view.detail.bounds(x * side, y * side, side, least, greatest);
    const outermost = x === 0 || y === 0 || (x + 1) * side >= field.width_m || (y + 1) * side >= field.height_m;
    if (greatest <= floor && !(view.walls && outermost)) return;
    const low = view.exaggeration * Math.max(floor, least);
    const high = view.exaggeration * Math.max(floor, greatest);
    const box = [x * side, y * side, low, (x + 1) * side, (y + 1) * side, high];
    if (!seen(view.planes, box)) return;
    if (level === finest || distance(view.eye, box) >= rangeOf(level - 1)) return put(level, x, y);
    for (let child = 0; child < 4; ++child) visit(level - 1, 2 * x + (child & 1), 2 * y + (child >> 1));
  };
  visit(top, 0, 0);
  return count;
}

function distance(eye: readonly [number, number, number], box: readonly number[]): number {
  let sum = 0;
  for (let k = 0; k < 3; ++k) {
    const outside = Math.max(box[k]! - eye[k]!, 0, eye[k]! - box[k + 3]!);
    sum += outside * outside;
  }
  return Math.sqrt(sum);
}

function seen(planes: ArrayLike<number>, box: readonly number[]): boolean {
  for (let p = 0; p < planes.length; p += 4) {
    const a = planes[p]!, b = planes[p + 1]!, c = planes[p + 2]!;
    const x = box[a > 0 ? 3 : 0]!, y = box[b > 0 ? 4 : 1]!, z = box[c > 0 ? 5 : 2]!;
    if (a * x + b * y + c * z + planes[p + 3]! < 0) return false;
  }
  return true;
}

/** What the vertex shader does to a grid vertex (0 to patchCells in each direction) of a patch, for tests. */
export function morphed(patch: ArrayLike<number>, i: number, j: number, distance_m: number): [number, number] {
  const step = patch[2]! / patchCells;
  const k = Math.min(1, Math.max(0, (distance_m - patch[3]!) / (patch[4]! - patch[3]!)));
  return [patch[0]! + step * (i - (i % 2) * k), patch[1]! + step * (j - (j % 2) * k)];
}
