// The ground along a line from the side: heights at equal distances, and what they add up to. Pure.
import type { Places } from "./drape";

export interface ProfileData {
  /** Along the line, metres; the last is its length. */
  distance: number[];
  /** null: beside the terrain or unknown. */
  height: (number | null)[];
  places: [number, number][];
  length: number;
  min: number;
  max: number;
  /** Sums of what goes up and what goes down. */
  rise: number;
  fall: number;
}

/** `at`: height of a place. At least two points, else null. */
export function profileAlong(
  line: Places, at: (x: number, y: number) => number | null, count = 240,
): ProfileData | null {
  const ends: number[] = [0];
  for (let i = 1; i < line.length; ++i) {
    ends.push(ends[i - 1]! + Math.hypot(line[i]![0] - line[i - 1]![0], line[i]![1] - line[i - 1]![1]));
  }
  const length = ends[ends.length - 1]!;
  if (line.length < 2 || !(length > 0)) return null;
  const data: ProfileData = {
    distance: [], height: [], places: [], length, min: Infinity, max: -Infinity, rise: 0, fall: 0,
  };
  let before: number | null = null, piece = 1;
  for (let k = 0; k < count; ++k) {
    const s = (length * k) / (count - 1);
    while (piece + 1 < ends.length && ends[piece]! < s) ++piece;
    const [ax, ay] = line[piece - 1]!, [bx, by] = line[piece]!;
    const t = Math.min(1, (s - ends[piece - 1]!) / Math.max(1e-12, ends[piece]! - ends[piece - 1]!));
    const x = ax + t * (bx - ax), y = ay + t * (by - ay), h = at(x, y);
    data.distance.push(s);
    data.places.push([x, y]);
    data.height.push(h);
    if (h === null) continue;
    data.min = Math.min(data.min, h);
    data.max = Math.max(data.max, h);
    if (before !== null) {
      data.rise += Math.max(0, h - before);
      data.fall += Math.max(0, before - h);
    }
    before = h;
  }
  return data.min <= data.max ? data : null;
}
