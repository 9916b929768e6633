// Heights on the processor's side: bilinear samples, statistics, and a tree of least and greatest heights over blocks
// of cells, which picking and the choice of patches walk down.
//
// Block coordinates count cells from the north-west corner of the frame: cell i covers [i, i + 1], its sample is at
// i + 0.5.
import type { Frame } from "../api/types";
import type { Rectangle } from "./map_camera";
import type { Raster } from "./types";

/** Cells along the side of a block of the tree's finest level. */
export const blockCells = 4;

export interface TreeLevel {
  columns: number;
  rows: number;
  low: Float32Array;
  high: Float32Array;
  /** 1: a block has dry ground below the sea. Absent: none has. */
  dry?: Uint8Array;
}

export class HeightField {
  readonly columns: number;
  readonly rows: number;
  readonly min: number;
  readonly max: number;
  /** Of the sea's floor and of dry ground, 0 or less. */
  readonly lowestSea: number;
  readonly lowestDry: number;
  /** Finest first; the last has one block. */
  get tree(): readonly TreeLevel[] {
    this.built ??= markedTree(this.values, this.dry, this.columns, this.rows);
    return this.built;
  }
  private built: TreeLevel[] | null = null;
  /** Root mean square tangent of slopes that are not nearly level. */
  readonly typicalSlope: number;
  /** Share of the border that lies under the sea. */
  readonly seaBorder: number;
  /** Mean depth there, metres > 0. */
  readonly borderDepth: number;
  /** Without unknown cells: those have the height of a neighbour. */
  readonly values: Float32Array;
  private readonly known: Float32Array | Uint8Array;

  constructor(
    readonly frame: Frame,
    values: Float32Array | Uint8Array,
    readonly key: string,
    readonly coarse: boolean,
    /** 255: ground that is dry though it may lie below the sea, else 0; null: there is none. */
    readonly dry: Uint8Array | null = null,
  ) {
    this.columns = frame.columns;
    this.rows = frame.rows;
    this.known = values;
    this.values = filled(values, frame.columns);
    [this.min, this.max] = extremes(this.values);
    this.typicalSlope = typicalSlope(this.values, this.columns, this.rows, frame.cell_m);
    [this.lowestSea, this.lowestDry] = lowest(this.values, dry, this.min);
    [this.seaBorder, this.borderDepth] = border(this.values, this.columns, this.rows);
  }

  static of(raster: Raster): HeightField {
    return new HeightField(raster.frame, raster.values, raster.key, raster.coarse, raster.dry ?? null);
  }

  get width_m(): number {
    return this.columns * this.frame.cell_m;
  }
  get height_m(): number {
    return this.rows * this.frame.cell_m;
  }
  get rectangle(): Rectangle {
    const { west, north } = this.frame;
    return { west, north, east: west + this.width_m, south: north - this.height_m };
  }
  /** Around what stands over the sea or close under its surface; all where that is little. */
  get dryRectangle(): Rectangle {
    const { columns, rows, high, dry } = this.tree[0]!, side = blockCells * this.frame.cell_m;
    let left = columns, right = -1, top = rows, bottom = -1;
    for (let y = 0; y < rows; ++y) {
      for (let x = 0; x < columns; ++x) {
        if (high[y * columns + x]! < -25 && dry?.[y * columns + x] !== 1) continue;
        left = Math.min(left, x);
        right = Math.max(right, x);
        top = Math.min(top, y);
        bottom = Math.max(bottom, y);
      }
    }
    if (right - left < 0.1 * columns && bottom - top < 0.1 * rows) return this.rectangle;
    const { west, north } = this.frame;
    return {
      west: west + left * side, east: west + (right + 1) * side, north: north - top * side,
      south: north - (bottom + 1) * side,
    };
  }
  get centre(): [number, number] {
    return [this.frame.west + this.width_m / 2, this.frame.north - this.height_m / 2];
  }
  /** The sea goes on beyond the terrain. */
  get inSea(): boolean {
    return this.seaBorder > 0.5;
  }

  contains(x: number, y: number): boolean {
    const u = (x - this.frame.west) / this.frame.cell_m, v = (this.frame.north - y) / this.frame.cell_m;
    return u >= 0 && v >= 0 && u <= this.columns && v <= this.rows;
  }

  /** Height at a place of the document; null outside and where it is unknown. */
  at(x: number, y: number): number | null {
    if (!this.contains(x, y)) return null;
    const u = (x - this.frame.west) / this.frame.cell_m, v = (this.frame.north - y) / this.frame.cell_m;
    const column = Math.min(this.columns - 1, Math.floor(u)), row = Math.min(this.rows - 1, Math.floor(v));
    return Number.isNaN(this.known[row * this.columns + column]!) ? null : this.sample(u, v);
  }

  /** How dry the ground at a place is, 0 to 1: bilinear. */
  dryShare(x: number, y: number): number {
    if (this.dry === null) return 0;
    return bilinear(this.dry, this.columns, this.rows, ...this.cellsOf(x, y)) / 255;
  }

  /** Of the ground or, where that is lower and not dry, of water at a level; in block coordinates. */
  surface(u: number, v: number, water: number): number {
    const height = this.sample(u, v);
    if (height >= water) return height;
    return this.dry !== null && bilinear(this.dry, this.columns, this.rows, u, v) > 127 ? height : water;
  }

  /** Bilinear, in block coordinates, clamped to the border. */
  sample(u: number, v: number): number {
    return bilinear(this.values, this.columns, this.rows, u, v);
  }

  private cellsOf(x: number, y: number): [number, number] {
    return [(x - this.frame.west) / this.frame.cell_m, (this.frame.north - y) / this.frame.cell_m];
  }
}

function bilinear(h: Float32Array | Uint8Array, columns: number, rows: number, u: number, v: number): number {
  const x = Math.min(columns - 1, Math.max(0, u - 0.5)), y = Math.min(rows - 1, Math.max(0, v - 0.5));
  const column = Math.min(columns - 2, Math.floor(x)), row = Math.min(rows - 2, Math.floor(y));
  if (column < 0 || row < 0) return h[Math.floor(y) * columns + Math.floor(x)]!;
  const s = x - column, t = y - row, i = row * columns + column, below = i + columns;
  const top = h[i]! + s * (h[i + 1]! - h[i]!), bottom = h[below]! + s * (h[below + 1]! - h[below]!);
  return top + t * (bottom - top);
}

function filled(values: Float32Array | Uint8Array, columns: number): Float32Array {
  let unknown = false;
  if (values instanceof Float32Array) {
    for (let i = 0; i < values.length && !unknown; ++i) unknown = Number.isNaN(values[i]!);
    if (!unknown) return values;
  }
  const result = Float32Array.from(values);
  for (let i = 1; i < result.length; ++i) {
    if (Number.isNaN(result[i]!)) result[i] = i % columns === 0 ? result[Math.max(0, i - columns)]! : result[i - 1]!;
  }
  for (let i = result.length - 2; i >= 0; --i) if (Number.isNaN(result[i]!)) result[i] = result[i + 1]!;
  if (Number.isNaN(result[0]!)) result.fill(0);
  return result;
}

/** Blocks know the heights of their cells and of one more on each side: the bilinear surface reaches so far. */
function finestLevel(values: Float32Array, columns: number, rows: number): TreeLevel {
  const across = Math.ceil(columns / blockCells), down = Math.ceil(rows / blockCells);
  const low = new Float32Array(across * down), high = new Float32Array(across * down);
  for (let by = 0; by < down; ++by) {
    const y0 = Math.max(0, by * blockCells - 1), y1 = Math.min(rows - 1, (by + 1) * blockCells);
    for (let bx = 0; bx < across; ++bx) {
      const x0 = Math.max(0, bx * blockCells - 1), x1 = Math.min(columns - 1, (bx + 1) * blockCells);
      let least = Infinity, most = -Infinity;
      for (let y = y0; y <= y1; ++y) {
        for (let i = y * columns + x0, end = y * columns + x1; i <= end; ++i) {
          const h = values[i]!;
          if (h < least) least = h;
          if (h > most) most = h;
        }
      }
      low[by * across + bx] = least;
      high[by * across + bx] = most;
    }
  }
  return { columns: across, rows: down, low, high };
}

function buildTree(values: Float32Array, columns: number, rows: number): TreeLevel[] {
  const levels = [finestLevel(values, columns, rows)];
  for (let from = levels[0]!; from.columns > 1 || from.rows > 1; from = levels[levels.length - 1]!) {
    const across = (from.columns + 1) >> 1, down = (from.rows + 1) >> 1;
    const low = new Float32Array(across * down).fill(Infinity), high = new Float32Array(across * down).fill(-Infinity);
    for (let y = 0; y < from.rows; ++y) {
      for (let x = 0; x < from.columns; ++x) {
        const i = y * from.columns + x, to = (y >> 1) * across + (x >> 1);
        low[to] = Math.min(low[to]!, from.low[i]!);
        high[to] = Math.max(high[to]!, from.high[i]!);
      }
    }
    levels.push({ columns: across, rows: down, low, high });
  }
  return levels;
}

function markedTree(values: Float32Array, dry: Uint8Array | null, columns: number, rows: number): TreeLevel[] {
  const tree = buildTree(values, columns, rows);
  if (dry !== null) markDry(tree, dry, columns, rows);
  return tree;
}

function extremes(values: Float32Array): [number, number] {
  let min = Infinity, max = -Infinity;
  for (let i = 0; i < values.length; ++i) {
    const h = values[i]!;
    if (h < min) min = h;
    if (h > max) max = h;
  }
  return [min, max];
}

/** Tells the blocks of a tree which of their cells, and of those around, are dry below the sea. */
function markDry(tree: readonly TreeLevel[], dry: Uint8Array, columns: number, rows: number): void {
  const finest = tree[0]!, marks = (finest.dry = new Uint8Array(finest.columns * finest.rows));
  for (let by = 0; by < finest.rows; ++by) {
    const y0 = Math.max(0, by * blockCells - 1), y1 = Math.min(rows - 1, (by + 1) * blockCells);
    for (let bx = 0; bx < finest.columns; ++bx) {
      const x0 = Math.max(0, bx * blockCells - 1), x1 = Math.min(columns - 1, (bx + 1) * blockCells);
      let any = false;
      for (let y = y0; y <= y1 && !any; ++y) any = dry.subarray(y * columns + x0, y * columns + x1 + 1).includes(255);
      marks[by * finest.columns + bx] = any ? 1 : 0;
    }
  }
  for (let k = 1; k < tree.length; ++k) {
    const from = tree[k - 1]!, to = tree[k]!, marked = (to.dry = new Uint8Array(to.columns * to.rows));
    from.dry!.forEach((mark, i) => {
      if (mark === 1) marked[(Math.floor(i / from.columns) >> 1) * to.columns + ((i % from.columns) >> 1)] = 1;
    });
  }
}

function lowest(values: Float32Array, dry: Uint8Array | null, min: number): [number, number] {
  if (dry === null) return [Math.min(0, min), 0];
  let sea = 0, ground = 0;
  values.forEach((h, i) => {
    if (dry[i] === 0) sea = Math.min(sea, h);
    else ground = Math.min(ground, h);
  });
  return [sea, ground];
}

function typicalSlope(values: Float32Array, columns: number, rows: number, cell_m: number): number {
  const step = Math.max(1, Math.floor(Math.sqrt((columns * rows) / 65536)));
  let sum = 0, count = 0;
  for (let y = 0; y + 1 < rows; y += step) {
    for (let x = 0; x + 1 < columns; x += step) {
      const i = y * columns + x;
      const east = values[i + 1]! - values[i]!, south = values[i + columns]! - values[i]!;
      const square = (east * east + south * south) / (cell_m * cell_m);
      if (square < 4e-4) continue;
      sum += Math.min(square, 4);
      ++count;
    }
  }
  return count === 0 ? 0 : Math.sqrt(sum / count);
}

function border(values: Float32Array, columns: number, rows: number): [number, number] {
  let below = 0, count = 0, depth = 0;
  const add = (h: number): void => {
    ++count;
    if (h > 0) return;
    ++below;
    depth -= h;
  };
  for (let x = 0; x < columns; ++x) [values[x]!, values[(rows - 1) * columns + x]!].forEach(add);
  for (let y = 0; y < rows; ++y) [values[y * columns]!, values[(y + 1) * columns - 1]!].forEach(add);
  return [below / Math.max(1, count), below > 0 ? depth / below : 0];
}

/** Whether two lie in about the same place. */
export function sameRectangle(a: HeightField, b: HeightField): boolean {
  const near = (p: number, q: number): boolean => Math.abs(p - q) < 0.02 * Math.max(a.width_m, b.width_m);
  return near(a.frame.west, b.frame.west) && near(a.frame.north, b.frame.north) &&
    near(a.width_m, b.width_m) && near(a.height_m, b.height_m);
}
