// A terrain for pages without a server: an island with valleys in a shallow sea, with labels and a mask to match.
import type { Frame } from "../api/types";

function hash(x: number, y: number, seed: number): number {
  let h = Math.imul(x, 374761393) ^ Math.imul(y, 668265263) ^ Math.imul(seed, 2246822519);
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967295;
}

function noise(x: number, y: number, seed: number): number {
  const i = Math.floor(x), j = Math.floor(y);
  const u = x - i, v = y - j;
  const a = u * u * (3 - 2 * u), b = v * v * (3 - 2 * v);
  const top = hash(i, j, seed) * (1 - a) + hash(i + 1, j, seed) * a;
  const bottom = hash(i, j + 1, seed) * (1 - a) + hash(i + 1, j + 1, seed) * a;
  return (top * (1 - b) + bottom * b) * 2 - 1;
}

function ridged(x: number, y: number, seed: number): number {
  let sum = 0, amplitude = 0.5, frequency = 1;
  for (let octave = 0; octave < 5; ++octave) {
    sum += amplitude * (1 - Math.abs(noise(x * frequency, y * frequency, seed + octave)));
    amplitude *= 0.5;
    frequency *= 2.03;
  }
  return sum;
}

export function fakeHeights(frame: Frame, seed: number, peak_m: number): Float32Array {
  const heights = new Float32Array(frame.columns * frame.rows);
  const half = (frame.columns * frame.cell_m) / 2;
  for (let row = 0; row < frame.rows; ++row) {
    for (let column = 0; column < frame.columns; ++column) {
      const x = ((column + 0.5) * frame.cell_m - half) / half;
      const y = ((row + 0.5) * frame.cell_m) / half - 1;
      const coast = Math.hypot(x, y) / (0.52 + 0.12 * noise(x * 2 + 7, y * 2 + 3, seed));
      const cone = Math.max(0, 1 - coast);
      const height = cone * peak_m * (0.45 + 1.1 * ridged(x * 4, y * 4, seed) * cone);
      const sea = -Math.min(1, Math.max(0, coast - 1) * 1.6) * 400;
      const reef = 26 * Math.exp(-(((coast - 1.28) / 0.06) ** 2));
      heights[row * frame.columns + column] = coast < 1 ? height : Math.min(sea * 0.5 - 4 + reef, 1.2);
    }
  }
  return heights;
}

/** 0 mountain, 1 beach, 2 lagoon, 3 reef, 4 abyss. */
export function fakeLabels(heights: Float32Array): Uint8Array {
  return Uint8Array.from(heights, (z) => (z > 12 ? 0 : z > 0 ? 1 : z > -25 ? 3 : z > -90 ? 2 : 4));
}

export function fakeMask(heights: Float32Array, peak_m: number): Float32Array {
  return heights.map((z) => Math.min(1, Math.max(0, z / peak_m)));
}
