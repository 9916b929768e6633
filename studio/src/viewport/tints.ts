// Height and depth tints of the map, as the C++ renderer has them (src/seamount/ops/render/tints.cpp): one ramp, sea in
// its first half by the logarithm of the depth, land in the other; and the ramp of scalar fields.
import { DataTexture, LinearFilter, RGBAFormat, UnsignedByteType } from "three";
import { roundDownNice } from "./ticks";

export type Colour = readonly [number, number, number];
type Stop = readonly [place: number, colour: Colour];

const land: readonly Stop[] = [
  [0, [233, 232, 206]], [0.05, [196, 208, 168]], [0.16, [178, 194, 150]], [0.3, [201, 205, 160]],
  [0.45, [222, 211, 168]],
  [0.6, [214, 191, 150]], [0.75, [199, 173, 143]], [0.88, [214, 200, 184]], [1, [243, 240, 236]],
];
const sea: readonly Stop[] = [
  [0, [233, 232, 206]], [0.07, [196, 228, 214]], [0.2, [157, 214, 211]], [0.36, [115, 188, 204]],
  [0.54, [79, 154, 189]],
  [0.72, [55, 118, 165]], [0.87, [40, 86, 135]], [1, [27, 58, 101]],
];
/** Of scalar fields: dark is little. */
const field: readonly Stop[] = [
  [0, [38, 24, 74]], [0.15, [62, 52, 124]], [0.3, [52, 94, 141]], [0.45, [35, 134, 141]], [0.6, [42, 168, 122]],
  [0.75, [122, 200, 84]], [0.9, [222, 216, 70]], [1, [252, 236, 140]],
];

/** Colours of mountain, beach, lagoon, reef and abyss: those of the theme. */
export const labelColours: readonly Colour[] = [
  [140, 107, 79], [227, 207, 143], [95, 201, 196], [217, 112, 143], [39, 81, 138],
];
export const labelNames = ["mountain", "beach", "lagoon", "reef", "abyss"] as const;

export const kneeDepth = 12;

function between(stops: readonly Stop[], place: number): Colour {
  let i = 1;
  while (i + 1 < stops.length && stops[i]![0] < place) ++i;
  const [from, a] = stops[i - 1]!, [to, b] = stops[i]!;
  const t = Math.min(1, Math.max(0, (place - from) / (to - from)));
  return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
}

export function fieldColour(place: number): Colour {
  return between(field, place);
}

export function tintColour(place: number): Colour {
  return place < 0.5 ? between(sea, 1 - 2 * place) : between(land, 2 * place - 1);
}

export interface TintScale {
  /** Depth of the darkest blue; heights of the first and the last tint of land. */
  deepest: number;
  base: number;
  top: number;
}

function roundUp(x: number): number {
  const step = roundDownNice(x) / 10;
  return Math.ceil(x / (2 * step) - 1e-9) * 2 * step;
}

/** `dry`: of the lowest dry ground below the sea, or 0. */
export function tintScale(min: number, max: number, dry = 0): TintScale {
  const base = dry < 0 ? -roundUp(Math.max(1, -dry)) : min > 0.35 * max ? min : 0;
  return {
    deepest: roundUp(Math.max(1, -min)),
    base,
    top: base > 0 ? Math.max(max, base + 1) : roundUp(Math.max(1, max)),
  };
}

/** Place of a height on the ramp. */
export function tintPlace(scale: TintScale, height: number, dry = false): number {
  if (height < 0 && !dry) return 0.5 - 0.5 * Math.min(
    1, Math.log1p(-height / kneeDepth) / Math.log1p(scale.deepest / kneeDepth),
  );
  return 0.5 + 0.5 * Math.min(1, Math.max(0, (height - scale.base) / Math.max(1e-3, scale.top - scale.base)));
}

export function tintTexture(): DataTexture {
  const size = 1024, data = new Uint8Array(size * 4);
  for (let i = 0; i < size; ++i) data.set([...tintColour(i / (size - 1)).map(Math.round), 255], 4 * i);
  const texture = new DataTexture(data, size, 1, RGBAFormat, UnsignedByteType);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
