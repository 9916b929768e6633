// Sun and sky in numbers, after the C++ renderer's sky (src/seamount/ops/render/sky.cpp), exposed like film: an evening
// is not drawn as dark as it is.
import { sunVector, type ViewOptions } from "./options";

export type Rgb = [number, number, number];

export interface Lamps {
  toSun: Rgb;
  /** On a surface that faces the sun, and of the whole sky on level ground. */
  sun: Rgb;
  sky: Rgb;
  /** Of the sky's colours. */
  skyScale: number;
}

function ramp(low: number, high: number, x: number): number {
  const t = Math.min(1, Math.max(0, (x - low) / (high - low)));
  return t * t * (3 - 2 * t);
}

function unexposed(toSun: Rgb): Lamps {
  const mass = 1 / (Math.max(0, toSun[2]) + 0.06), day = 0.35 + 0.65 * ramp(0, 0.5, toSun[2]);
  const sun = [0.095, 0.15, 0.255].map((depth) => 3.55 * Math.exp(-mass * depth)) as Rgb;
  return { toSun, sun, sky: [0.345 * day, 0.435 * day, 0.585 * day], skyScale: day };
}

function onTheGround(lamps: Lamps): number {
  const height = Math.max(0.02, lamps.toSun[2]), weights = [0.2126, 0.7152, 0.0722];
  return weights.reduce((sum, weight, i) => sum + weight * (height * lamps.sun[i]! + lamps.sky[i]!), 0);
}

export function lamps(sun: ViewOptions["sun"]): Lamps {
  const raw = unexposed(sunVector(sun));
  const usual = onTheGround(unexposed(sunVector({ azimuth_deg: 0, elevation_deg: 30 })));
  const exposure = (usual / onTheGround(raw)) ** 0.6;
  const scaled = (c: Rgb): Rgb => [c[0] * exposure, c[1] * exposure, c[2] * exposure];
  return { toSun: raw.toSun, sun: scaled(raw.sun), sky: scaled(raw.sky), skyScale: raw.skyScale * exposure };
}
