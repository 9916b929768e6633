// The eraser: what of a line lies under it goes, and what is left of it are lines again.
import type { Edit, Json } from "../api/types";
import { setPoints, fewest, removeFeatures } from "./changes";
import { itemMembers, type Feature } from "./features";
import { distance, mix, roundedPoint, type Point } from "./geometry";

export interface Piece {
  points: Point[];
  /** Places of its points on the old line. */
  from: number[];
}

/** Shares of a segment at which it enters and leaves a disc. */
function through(a: Point, b: Point, centre: Point, radius: number): [number, number] | null {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const [fx, fy] = [a[0] - centre[0], a[1] - centre[1]];
  const squared = dx * dx + dy * dy;
  const half = fx * dx + fy * dy;
  const root = half * half - squared * (fx * fx + fy * fy - radius * radius);
  if (squared === 0 || root <= 0) return null;
  const [t0, t1] = [(-half - Math.sqrt(root)) / squared, (-half + Math.sqrt(root)) / squared];
  return t1 <= 0 || t0 >= 1 ? null : [Math.max(0, t0), Math.min(1, t1)];
}

/** What is left of a line outside a disc; null: it is untouched. */
export function outsideDisc(points: readonly Point[], centre: Point, radius: number): Piece[] | null {
  const pieces: Piece[] = [];
  let piece: Piece = { points: [], from: [] };
  let touched = false;
  const add = (point: Point, at: number) => {
    piece.points.push(point);
    piece.from.push(at);
  };
  const end = () => {
    if (piece.points.length > 1) pieces.push(piece);
    piece = { points: [], from: [] };
  };
  points.forEach((point, i) => {
    if (distance(point, centre) > radius) add(point, i);
    const next = points[i + 1];
    const cut = next && through(point, next, centre, radius);
    if (!next || !cut) return;
    touched = true;
    if (cut[0] > 0) add(mix(point, next, cut[0]), i + cut[0]);
    end();
    if (cut[1] < 1) add(mix(point, next, cut[1]), i + cut[1]);
  });
  if (points.length === 1) touched = distance(points[0]!, centre) <= radius;
  end();
  return touched ? pieces : null;
}

/** Outside of a swept disc. */
export function outsideSweep(points: readonly Point[], way: readonly Point[], radius: number): Piece[] | null {
  let pieces: Piece[] = [{ points: [...points], from: points.map((_, i) => i) }];
  let touched = false;
  for (const centre of way) {
    pieces = pieces.flatMap((piece) => {
      const left = outsideDisc(piece.points, centre, radius);
      if (!left) return [piece];
      touched = true;
      return left.map((rest) => ({
        points: rest.points,
        from: rest.from.map((at) => {
          const low = Math.min(piece.from.length - 1, Math.floor(at));
          const high = Math.min(piece.from.length - 1, low + 1);
          return piece.from[low]! + (piece.from[high]! - piece.from[low]!) * (at - low);
        }),
      }));
    });
  }
  return touched ? pieces : null;
}

function asItem(feature: Feature, piece: Piece): Json {
  const edits = setPoints(feature, piece.points, piece.from);
  if (Array.isArray(feature.item.value)) return piece.points.map(([x, y]) => [x, y]);
  const item: { [name: string]: Json } = { ...itemMembers(feature) };
  for (const edit of edits) {
    if (edit.do !== "set" || edit.value === undefined) continue;
    const path = edit.pointer.slice(feature.item.pointer.length + 1).split("/");
    item[path[0]!] = edit.value;
  }
  return item;
}

/** The edits of a stroke of the eraser over lines and places; rings go when their border is met. */
export function eraseEdits(features: readonly Feature[], way: readonly Point[], radius: number, step: number): Edit[] {
  const gone: Feature[] = [];
  const cut: Edit[] = [];
  const more: Edit[] = [];
  for (const feature of features) {
    const closed = feature.geometry === "ring";
    const line = closed ? [...feature.points, feature.points[0]!] : feature.points;
    const pieces = outsideSweep(line, way, radius);
    if (!pieces) continue;
    const long = pieces.map((piece) => ({ ...piece, points: piece.points.map((p) => roundedPoint(p, step)) }));
    const left = feature.geometry === "line" ? long.filter((piece) => piece.points.length >= fewest(feature)) : [];
    if (left.length === 0) {
      gone.push(feature);
      continue;
    }
    cut.push(...setPoints(feature, left[0]!.points, left[0]!.from));
    const list = feature.slot.list ? feature.item.pointer.replace(/\/\d+$/, "") : null;
    if (!list) continue;
    for (const piece of left.slice(1)) more.push({ do: "insert", list, value: asItem(feature, piece) });
  }
  return [...cut, ...more, ...removeFeatures(gone)];
}
