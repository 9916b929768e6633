// From shapes on the ground to lines in the picture: pure, for the map (straight) and the 3D view (over hill and dale).

export interface Projector {
  /** Place in the picture in CSS pixels; null where it is behind the eye. */
  project(x: number, y: number): readonly [number, number] | null;
  /** Metres a pixel around there. */
  pixelSize(x: number, y: number): number;
  /** Whether ground stands before it. */
  hidden(x: number, y: number): boolean;
  /** Straight lines stay straight. */
  readonly flat: boolean;
}

export type Places = readonly (readonly [number, number])[];

/** A piece of a line that is all seen or all hidden. */
export interface Run {
  points: [number, number][];
  hidden: boolean;
}

const mostPieces = 3000;

/** A line with points so near to each other that it follows the ground. */
export function subdivided(points: Places, step_m: number): Places {
  if (points.length < 2) return points;
  let total = 0;
  for (let i = 1; i < points.length; ++i) total += Math.hypot(
    points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1],
  );
  const step = Math.max(step_m, total / mostPieces);
  const result: [number, number][] = [[points[0]![0], points[0]![1]]];
  for (let i = 1; i < points.length; ++i) {
    const [ax, ay] = points[i - 1]!, [bx, by] = points[i]!;
    const pieces = Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / step));
    for (let k = 1; k <= pieces; ++k) result.push([ax + ((bx - ax) * k) / pieces, ay + ((by - ay) * k) / pieces]);
  }
  return result;
}

/** The pieces of a line in the picture. */
export function runs(points: Places, closed: boolean, by: Projector): Run[] {
  let line = closed && points.length > 2 ? [...points, points[0]!] : points;
  if (!by.flat && line.length > 0) {
    const [x, y] = line[Math.floor(line.length / 2)]!;
    line = subdivided(line, 5 * by.pixelSize(x, y));
  }
  const result: Run[] = [];
  let now: Run | null = null;
  for (const [x, y] of line) {
    const at = by.project(x, y);
    if (at === null) {
      now = null;
      continue;
    }
    const hidden = by.hidden(x, y);
    if (now !== null && now.hidden !== hidden) {
      now.points.push([at[0], at[1]]);
      now = null;
    }
    if (now === null) {
      now = { points: [], hidden };
      result.push(now);
    }
    now.points.push([at[0], at[1]]);
  }
  return result;
}

export function circle(x: number, y: number, radius: number, count = 72): Places {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const;
  });
}
