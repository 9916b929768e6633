// Things on the ground (trees, corals): read from the server's answer, and which of them a picture draws. Pure.
import type { Json } from "../api/types";

export interface ThingModel {
  name: string;
  /** Nine floats a corner: place (metres, z up), normal, colour (as displayed). */
  corners: Float32Array;
  /** Of a ball around the origin that holds it. */
  radius: number;
}

/** Five floats an instance: x, y (document's metres), z, angle (radians, counter-clockwise), scale. */
export const thingNumbers = 5;

export interface Things {
  models: ThingModel[];
  /** By model. */
  instances: Float64Array[];
}

type Members = { [key: string]: Json };

function members(value: Json | undefined): Members {
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value : {};
}
function list(value: Json | undefined): Json[] {
  return Array.isArray(value) ? value : [];
}
function number(value: Json | undefined, otherwise = 0): number {
  return typeof value === "number" && Number.isFinite(value) ? value : otherwise;
}

function floats(base64: string): Float32Array {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Float32Array(bytes.buffer, 0, bytes.length >> 2);
}

function modelOf(value: Json): ThingModel {
  const { name, triangles } = members(value);
  const corners = floats(typeof triangles === "string" ? triangles : "");
  let radius = 0;
  for (let i = 0; i + 8 < corners.length; i += 9) radius = Math.max(
    radius, Math.hypot(corners[i]!, corners[i + 1]!, corners[i + 2]!),
  );
  return { name: typeof name === "string" ? name : "", corners, radius };
}

export function readThings(answer: Json): Things {
  const { models, instances } = members(answer);
  const made = list(models).map(modelOf);
  const byModel: number[][] = made.map(() => []);
  for (const item of list(instances)) {
    const { model, x, y, z, angle_deg, scale } = members(item);
    const index = typeof model === "string" ? made.findIndex((one) => one.name === model) : number(model, -1);
    byModel[index]?.push(number(x), number(y), number(z), (number(angle_deg) * Math.PI) / 180, number(scale, 1));
  }
  return { models: made, instances: byModel.map((numbers) => Float64Array.from(numbers)) };
}

export interface ThingsView {
  eye: readonly [number, number, number];
  /** Planes as in patches.ts, but x east and y north of `origin`. */
  planes: ArrayLike<number>;
  exaggeration: number;
  /** Angle of a pixel. */
  pixel: number;
  /** Of triangles. */
  budget: number;
}

/** For each model the indices of its instances that are seen and large enough; what is larger in the picture goes
 * first. */
export function chooseThings(things: Things, view: ThingsView): Uint32Array[] {
  const seen: { model: number; index: number; size: number }[] = [];
  things.models.forEach((model, m) => {
    const all = things.instances[m]!;
    for (let i = 0; i < all.length; i += thingNumbers) {
      const x = all[i]!, y = all[i + 1]!, z = all[i + 2]! * view.exaggeration, radius = model.radius * all[i + 4]!;
      const size = radius / Math.max(1e-3, Math.hypot(x - view.eye[0], y - view.eye[1], z - view.eye[2]));
      if (size < 0.7 * view.pixel || !inside(view.planes, x, y, z, radius)) continue;
      seen.push({ model: m, index: i / thingNumbers, size });
    }
  });
  seen.sort((a, b) => b.size - a.size);
  const chosen: number[][] = things.models.map(() => []);
  let left = view.budget;
  for (const { model, index } of seen) {
    left -= things.models[model]!.corners.length / 27;
    if (left < 0) break;
    chosen[model]!.push(index);
  }
  return chosen.map((indices) => Uint32Array.from(indices));
}

function inside(planes: ArrayLike<number>, x: number, y: number, z: number, radius: number): boolean {
  for (let p = 0; p < planes.length; p += 4) {
    const a = planes[p]!, b = planes[p + 1]!, c = planes[p + 2]!;
    if (a * x + b * y + c * z + planes[p + 3]! < -radius * Math.hypot(a, b, c)) return false;
  }
  return true;
}
