// Tileable noise for the shaders, made once: red a sum of octaves from 8 waves across, blue and alpha its slopes (0.5:
// level), green another sum. Finer octaves fade out with the mipmaps, so nothing shimmers.
import {
  DataTexture, LinearFilter, LinearMipmapLinearFilter, LinearMipmapNearestFilter, RepeatWrapping, RGBAFormat,
  UnsignedByteType,
} from "three";

const size = 256;
const waves = 8;

function lattice(seed: number, x: number, y: number): [number, number] {
  let h = (seed ^ Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca77)) >>> 0;
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d) >>> 0;
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39) >>> 0;
  h = (h ^ (h >>> 15)) >>> 0;
  return [((h & 0xffff) / 65535) * 1.6 - 0.8, ((h >>> 16) / 65535) * 1.6 - 0.8];
}

function gradientNoise(seed: number, x: number, y: number, period: number): number {
  const ix = Math.floor(x), iy = Math.floor(y), u = x - ix, v = y - iy;
  const at = (i: number, j: number): number => {
    const [gx, gy] = lattice(seed, (ix + i) % period, (iy + j) % period);
    return gx * (u - i) + gy * (v - j);
  };
  const su = u * u * u * (u * (u * 6 - 15) + 10), sv = v * v * v * (v * (v * 6 - 15) + 10);
  const top = at(0, 0) + su * (at(1, 0) - at(0, 0)), bottom = at(0, 1) + su * (at(1, 1) - at(0, 1));
  return top + sv * (bottom - top);
}

function octaves(seed: number, x: number, y: number): number {
  let sum = 0, amplitude = 1;
  for (let period = waves; period <= size / 4; period *= 2, amplitude *= 0.6) {
    sum += amplitude * gradientNoise(seed + period, (x / size) * period, (y / size) * period, period);
  }
  return sum;
}

export function noiseTexture(smoothLevels: boolean): DataTexture {
  const first = new Float32Array(size * size), second = new Float32Array(size * size);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      first[y * size + x] = octaves(11, x, y);
      second[y * size + x] = octaves(77, x, y);
    }
  }
  const byte = (value: number): number => Math.max(0, Math.min(255, Math.round(value * 255)));
  const data = new Uint8Array(size * size * 4);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const i = y * size + x;
      const east = first[y * size + ((x + 1) % size)]! - first[y * size + ((x + size - 1) % size)]!;
      const north = first[((y + 1) % size) * size + x]! - first[((y + size - 1) % size) * size + x]!;
      data.set(
        [byte(0.5 + 0.55 * first[i]!), byte(0.5 + 0.55 * second[i]!), byte(0.5 + 2.2 * north), byte(0.5 + 2.2 * east)],
        4 * i,
      );
    }
  }
  const texture = new DataTexture(data, size, size, RGBAFormat, UnsignedByteType);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = smoothLevels ? LinearMipmapLinearFilter : LinearMipmapNearestFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}
