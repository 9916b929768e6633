// Objects of a scene as shapes over the ground, in the colours of their classes. Pure.
import type { Json } from "../api/types";
import { classColour, type CatalogueClass } from "../document/catalogue";
import type { OverlayShape } from "./types";

type Members = { [key: string]: Json };
type Point = readonly [number, number];

export interface ObjectClass {
  name: string;
  colour: string;
  count: number;
}

const members = (value: Json | undefined): Members =>
  (value !== null && typeof value === "object" && !Array.isArray(value) ? value : {});
const list = (value: Json | undefined): Json[] => (Array.isArray(value) ? value : []);

function point(value: Json | undefined): Point | null {
  const [x, y] = list(value);
  return typeof x === "number" && typeof y === "number" ? [x, y] : null;
}

/** One object of a scene, for who looks for the nearest. */
export interface SceneObject {
  name: string;
  /** One point: it stands at a place. */
  points: readonly Point[];
}

export interface LivingShapes {
  shapes: OverlayShape[];
  classes: ObjectClass[];
  objects: SceneObject[];
}

/** `modelled`: they stand in the 3D view as things, so that marks of them are for the map alone. */
export function objectShapes(answer: Json, catalogue: readonly CatalogueClass[], modelled: boolean): LivingShapes {
  const counts = new Map<string, number>(), places = new Map<string, Point[]>(), lines: OverlayShape[] = [];
  const objects: SceneObject[] = [];
  const only = modelled ? { only: "map" as const } : {};
  for (const feature of list(members(answer)["features"])) {
    const { geometry, properties } = members(feature), { type, coordinates } = members(geometry);
    const name = String(members(properties)["class"] ?? "");
    counts.set(name, (counts.get(name) ?? 0) + 1);
    if (type === "Point") {
      const at = point(coordinates);
      if (at === null) continue;
      objects.push({ name, points: [at] });
      const known = places.get(name);
      if (known) known.push(at);
      else places.set(name, [at]);
    } else if (type === "LineString") {
      const points = list(coordinates).map(point).filter((at): at is Point => at !== null);
      objects.push({ name, points });
      lines.push({ shape: "line", points, role: "ink", colour: classColour(catalogue, name), width_px: 1.5, ...only });
    }
  }
  const dots = [...places].map(([name, at]): OverlayShape =>
    ({ shape: "dots", places: at, colour: classColour(catalogue, name), ...only }));
  const classes = [...counts].map(([name, count]) => ({ name, count, colour: classColour(catalogue, name) }));
  return { shapes: [...lines, ...dots], classes: classes.sort((a, b) => b.count - a.count), objects };
}

function distanceToLine(at: Point, points: readonly Point[]): number {
  let least = Infinity;
  for (let i = 0; i < points.length; ++i) {
    const [ax, ay] = points[Math.max(0, i - 1)]!, [bx, by] = points[i]!, along = (bx - ax) ** 2 + (by - ay) ** 2;
    const share = along > 0 ? ((at[0] - ax) * (bx - ax) + (at[1] - ay) * (by - ay)) / along : 0;
    const t = Math.min(1, Math.max(0, share));
    least = Math.min(least, Math.hypot(ax + t * (bx - ax) - at[0], ay + t * (by - ay) - at[1]));
  }
  return least;
}

function lengthOf(points: readonly Point[]): number {
  return points.reduce((sum, [x, y], i) => {
    const [px, py] = points[Math.max(0, i - 1)]!;
    return sum + Math.hypot(x - px, y - py);
  }, 0);
}

/** The nearest object within a reach; of lines alone where only they will do. Of lines that are about as near as each
 * other, the longest is meant. */
export function nearestObject(objects: readonly SceneObject[], at: Point, reach_m: number, lines: boolean): SceneObject | null {
  let nearest: SceneObject | null = null, least = reach_m, length = 0;
  for (const object of objects) {
    if (lines && object.points.length < 2) continue;
    const away = distanceToLine(at, object.points), distance = lines ? Math.max(away, reach_m / 4) : away;
    if (distance > least) continue;
    const long = lines ? lengthOf(object.points) : 0;
    if (distance === least && long <= length && nearest !== null) continue;
    [nearest, least, length] = [object, distance, long];
  }
  return nearest;
}
