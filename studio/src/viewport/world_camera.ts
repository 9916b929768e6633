// The eye of the 3D view and how it moves: around a place, along the picture, towards a place, or as one flies. Metres
// of the document's system, heights times the exaggeration. Pure: every move gives a new eye.

export type Vector = readonly [number, number, number];

export interface Eye {
  readonly at: Vector;
  /** Bearing one looks along, clockwise from north. */
  readonly azimuth: number;
  /** Angle over the horizon; below it negative. */
  readonly pitch: number;
}

export interface Lens {
  readonly width: number;
  readonly height: number;
  /** Vertical field of view. */
  readonly fov: number;
}

export const fieldOfView = (38 * Math.PI) / 180;
const steepest = (89.5 * Math.PI) / 180;

export function add(a: Vector, b: Vector, scale = 1): Vector {
  return [a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]];
}
export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
export function between(a: Vector, b: Vector): Vector {
  return [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
}
export function length(a: Vector): number {
  return Math.hypot(a[0], a[1], a[2]);
}

export interface Axes {
  forward: Vector;
  right: Vector;
  up: Vector;
}

export function axes(eye: Eye): Axes {
  const ca = Math.cos(eye.azimuth), sa = Math.sin(eye.azimuth), cp = Math.cos(eye.pitch), sp = Math.sin(eye.pitch);
  return { forward: [sa * cp, ca * cp, sp], right: [ca, -sa, 0], up: [-sa * sp, -ca * sp, cp] };
}

/** Direction, of unit depth, through a place of the picture in pixels from its upper left. */
export function direction(eye: Eye, lens: Lens, x: number, y: number): Vector {
  const { forward, right, up } = axes(eye);
  const scale = (2 * Math.tan(lens.fov / 2)) / lens.height;
  return add(add(forward, right, scale * (x - lens.width / 2)), up, scale * (lens.height / 2 - y));
}

/** Where a place lies in the picture, and how deep; null behind the eye. */
export function project(eye: Eye, lens: Lens, place: Vector): [x: number, y: number, depth: number] | null {
  const { forward, right, up } = axes(eye);
  const to = between(eye.at, place), depth = dot(to, forward);
  if (depth <= 1e-6) return null;
  const scale = lens.height / (2 * Math.tan(lens.fov / 2)) / depth;
  return [lens.width / 2 + scale * dot(to, right), lens.height / 2 - scale * dot(to, up), depth];
}

function turn(v: Vector, axis: Vector, angle: number): Vector {
  const c = Math.cos(angle), s = Math.sin(angle), along = dot(v, axis) * (1 - c);
  const across: Vector = [
    axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0],
  ];
  return [
    c * v[0] + s * across[0] + along * axis[0],
    c * v[1] + s * across[1] + along * axis[1],
    c * v[2] + s * across[2] + along * axis[2],
  ];
}

/** Turns around a place, which stays where it is in the picture. */
export function orbit(eye: Eye, pivot: Vector, turn_rad: number, tilt_rad: number): Eye {
  const pitch = Math.min(steepest * 0.5, Math.max(-steepest, eye.pitch + tilt_rad));
  let arm = turn(between(pivot, eye.at), axes(eye).right, pitch - eye.pitch);
  arm = turn(arm, [0, 0, 1], -turn_rad);
  return { at: add(pivot, arm), azimuth: eye.azimuth + turn_rad, pitch };
}

/** Turns the head. */
export function look(eye: Eye, turn_rad: number, tilt_rad: number): Eye {
  const pitch = Math.min(steepest, Math.max(-steepest, eye.pitch + tilt_rad));
  return { at: eye.at, azimuth: eye.azimuth + turn_rad, pitch };
}

/** Moves along the picture's plane, so that what is `depth` away follows the pointer. */
export function pan(eye: Eye, lens: Lens, depth: number, right_px: number, down_px: number): Eye {
  const { right, up } = axes(eye);
  const scale = (depth * 2 * Math.tan(lens.fov / 2)) / lens.height;
  return { ...eye, at: add(add(eye.at, right, -scale * right_px), up, scale * down_px) };
}

/** Comes `factor` times as near (below 1: nearer) to a place, which stays where it is in the picture. */
export function approach(eye: Eye, place: Vector, factor: number, nearest: number): Eye {
  const arm = between(place, eye.at), far = length(arm);
  const wanted = Math.max(nearest, far * factor);
  if (far < 1e-6 || (factor < 1 && far <= nearest)) return eye;
  return { ...eye, at: add(place, arm, wanted / far) };
}

export function fly(eye: Eye, forward_m: number, right_m: number, up_m: number): Eye {
  const a = axes(eye);
  return { ...eye, at: add(add(add(eye.at, a.forward, forward_m), a.right, right_m), [0, 0, 1], up_m) };
}

/** Box of the ground in the same system. */
export interface Box {
  readonly low: Vector;
  readonly high: Vector;
}

function corners(box: Box): Vector[] {
  return Array.from({ length: 8 }, (_, i): Vector => [
    (i & 1 ? box.high : box.low)[0], (i & 2 ? box.high : box.low)[1], (i & 4 ? box.high : box.low)[2],
  ]);
}

/** An eye that has the whole box in the middle of the picture, in a direction. */
export function frame(box: Box, lens: Lens, azimuth: number, pitch: number): Eye {
  let middle: Vector = [
    0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), 0.5 * (box.low[2] + box.high[2]),
  ];
  let eye: Eye = { at: middle, azimuth, pitch };
  const { forward, right, up } = axes(eye);
  const tanY = Math.tan(lens.fov / 2) * 0.92, tanX = (tanY * lens.width) / Math.max(1, lens.height);
  for (let turn = 0; turn < 4; ++turn) {
    let back = 1;
    for (const corner of corners(box)) {
      const to = between(middle, corner), depth = dot(to, forward);
      back = Math.max(back, Math.abs(dot(to, right)) / tanX - depth, Math.abs(dot(to, up)) / tanY - depth);
    }
    eye = { ...eye, at: add(middle, forward, -back) };
    // The near side looks larger: what is seen is brought to the middle, and then one can come nearer.
    let left = Infinity, rightmost = -Infinity, low = Infinity, high = -Infinity;
    for (const corner of corners(box)) {
      const to = between(eye.at, corner), depth = dot(to, forward);
      left = Math.min(left, dot(to, right) / depth);
      rightmost = Math.max(rightmost, dot(to, right) / depth);
      low = Math.min(low, dot(to, up) / depth);
      high = Math.max(high, dot(to, up) / depth);
    }
    middle = add(add(middle, right, 0.4 * back * (left + rightmost)), up, 0.4 * back * (low + high));
  }
  return eye;
}

/** Not under the ground, and not further off than `farthest` from the box's middle. */
export function confined(eye: Eye, box: Box, groundAt: (x: number, y: number) => number, clearance: number): Eye {
  const middle: Vector = [0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), 0];
  const size = Math.max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  let at = eye.at;
  const out = between(middle, at), far = length(out), farthest = 6 * size;
  if (far > farthest) at = add(middle, out, farthest / far);
  const least = groundAt(at[0], at[1]) + clearance;
  if (at[2] < least) at = [at[0], at[1], least];
  return at === eye.at ? eye : { ...eye, at };
}

/** The four sides of what is seen and what lies before the eye, as planes a x + b y + c z + d >= 0 with x east and y
 * south (`north`: 1, north) of an origin (patches.ts). */
export function viewPlanes(eye: Eye, lens: Lens, origin: readonly [number, number], north: 1 | -1 = -1): Float64Array {
  const { forward, right, up } = axes(eye);
  const tanY = Math.tan(lens.fov / 2), tanX = (tanY * lens.width) / lens.height;
  const none: Vector = [0, 0, 0];
  const normals: Vector[] = [
    add(add(none, forward, tanX), right), add(add(none, forward, tanX), right, -1),
    add(add(none, forward, tanY), up), add(add(none, forward, tanY), up, -1), forward,
  ];
  const at: Vector = [eye.at[0] - origin[0], eye.at[1] - origin[1], eye.at[2]];
  return Float64Array.from(normals.flatMap((n) => [n[0], north * n[1], n[2], -dot(n, at)]));
}
