// Fine heights within a window of a coarse height field: the ground is the fine one there, and goes over into the
// coarse one at the window's border, for what draws it (shaders/detail.glsl) as for what asks for heights. Pure.
import { atEdge, covers, fadeOf, frameOfWindow, innerRectangle, type Source, type Window } from "./detail_window";
import { blockCells, HeightField } from "./heights";
import type { Rectangle } from "./map_camera";
import { pick, type Ray } from "./picking";

type Four = [number, number, number, number];

export class DetailGround {
  readonly field: HeightField;
  /** Places of the coarse ground (0 to 1) times the last two plus the first two are places of the window. */
  readonly place: Four;
  /** Weights of the window grow from its sides (west, north, east, south) by `fade`, and are at least `edge` there. */
  readonly fade: Four;
  readonly edge: Four;
  /** Levels between the window's cells and the coarse ones. */
  readonly levels: number;
  private readonly inner: Rectangle;

  constructor(
    readonly coarse: HeightField, source: Source, readonly window: Window, values: Float32Array | Uint8Array,
    dry?: Uint8Array,
  ) {
    const frame = frameOfWindow(source, window), from = coarse.frame;
    this.field = new HeightField(frame, values, source.key, false, dry ?? null);
    const { width_m, height_m } = this.field;
    this.place = [
      (from.west - frame.west) / width_m, (frame.north - from.north) / height_m,
      coarse.width_m / width_m, coarse.height_m / height_m,
    ];
    const edges = atEdge(source, window), fade = fadeOf(source, window.level);
    this.fade = edges.map((edge, i) => (edge ? 0 : (i % 2 === 0 ? window.columns : window.rows) / fade)) as Four;
    this.edge = edges.map((edge) => (edge ? 1 : 0)) as Four;
    this.levels = source.level - window.level;
    this.inner = innerRectangle(source, window);
  }

  get cell_m(): number {
    return this.field.frame.cell_m;
  }

  /** Whether a part of the ground shows the window alone. */
  covers(part: Rectangle): boolean {
    return covers(this.inner, part);
  }

  /** Share of the window at a place: as in the shaders. */
  weight(x: number, y: number): number {
    const { frame, width_m, height_m } = this.field;
    const u = (x - frame.west) / width_m, v = (frame.north - y) / height_m;
    const t = Math.min(1, ...[u, v, 1 - u, 1 - v].map((d, i) => d * this.fade[i]! + this.edge[i]!));
    return t <= 0 ? 0 : t * t * (3 - 2 * t);
  }

  /** Least and greatest heights of a square of the ground, metres east and south of its corner, from the coarse
   * ones. */
  bounds(east: number, south: number, side: number, least: number, greatest: number): [number, number] {
    const { coarse: { frame: from }, field } = this, cell = this.cell_m;
    const u = (from.west + east - field.frame.west) / cell;
    const v = (field.frame.north - from.north + south) / cell;
    const size = side / cell;
    if (u > field.columns || v > field.rows || u + size < 0 || v + size < 0) return [least, greatest];
    const level = Math.min(field.tree.length - 1, Math.max(0, Math.ceil(Math.log2(size / blockCells))));
    const block = blockCells * 2 ** level;
    const { columns, rows, low, high } = field.tree[level]!;
    for (let y = Math.max(0, Math.floor(v / block)); y <= Math.min(rows - 1, Math.floor((v + size) / block)); ++y) {
      const east = Math.min(columns - 1, Math.floor((u + size) / block));
      for (let x = Math.max(0, Math.floor(u / block)); x <= east; ++x) {
        least = Math.min(least, low[y * columns + x]!);
        greatest = Math.max(greatest, high[y * columns + x]!);
      }
    }
    return [least, greatest];
  }
}

/** What knows a place most finely; null: none of them knows it. */
export function finerOf(details: readonly (DetailGround | null)[], x: number, y: number): DetailGround | null {
  let best: DetailGround | null = null;
  for (const detail of details) {
    if (detail !== null && detail.weight(x, y) > 0 && (best === null || detail.cell_m < best.cell_m)) best = detail;
  }
  return best;
}

/** Height at a place, as finely as it is known; null outside and where it is unknown. */
export function heightAt(field: HeightField, detail: DetailGround | null, x: number, y: number): number | null {
  const weight = detail?.weight(x, y) ?? 0, height = field.at(x, y);
  if (weight === 0 || height === null) return height;
  const fine = detail!.field.at(x, y);
  return fine === null ? null : height + weight * (fine - height);
}

/** Whether ground below the sea is dry at a place: as in the shaders. */
export function dryAt(field: HeightField, detail: DetailGround | null, x: number, y: number): boolean {
  const weight = detail?.weight(x, y) ?? 0;
  if (field.dry === null && (weight === 0 || detail!.field.dry === null)) return false;
  const coarse = field.dryShare(x, y);
  return (weight === 0 ? coarse : coarse + weight * (detail!.field.dryShare(x, y) - coarse)) > 0.5;
}

/** Where a ray meets the ground, of which a part may be known finely. */
export function pickGround(
  field: HeightField, detail: DetailGround | null, ray: Ray, floor = -Infinity,
): number | null {
  const met = pick(field, ray, floor);
  if (detail === null) return met;
  const fine = pick(detail.field, ray, floor);
  const inside = (t: number | null): boolean => t !== null && detail.weight(along(ray, t, 0), along(ray, t, 1)) > 0.5;
  if (fine !== null && inside(fine) && (met === null || fine < met || inside(met))) return fine;
  return met;
}

function along(ray: Ray, t: number, k: 0 | 1): number {
  return ray.from[k] + t * (ray.to[k] - ray.from[k]);
}

/** Whether the ground hides a place a little over it from an eye. */
export function hiddenBehind(
  field: HeightField, detail: DetailGround | null, place: Ray["to"], eye: Ray["from"],
): boolean {
  const met = pickGround(field, detail, { from: eye, to: place });
  return met !== null && met < 0.995;
}
