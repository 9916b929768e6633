// Small pictures of rasters: terrain shaded with tints by height and depth, labels in their colours, fields in grey.
import type { Raster } from "../../viewport/types";

type Colour = readonly [number, number, number];

const LABELS: readonly Colour[] = [[140, 107, 79], [227, 207, 143], [95, 201, 196], [217, 112, 143], [39, 81, 138]];
const NOTHING: Colour = [96, 104, 112];
/** Share of the greatest depth, then of the greatest height. */
const SEA: readonly (readonly [number, Colour])[] = [[0, [112, 176, 190]], [0.06, [74, 140, 170]], [0.4, [44, 96, 140]],
  [1, [24, 54, 92]]];
const LAND: readonly (readonly [number, Colour])[] = [[0, [196, 186, 140]], [0.04, [122, 146, 92]],
  [0.35, [104, 128, 82]], [0.65, [142, 128, 104]], [0.9, [186, 180, 172]], [1, [240, 242, 244]]];

function ramp(stops: readonly (readonly [number, Colour])[], at: number): Colour {
  for (let i = 1; i < stops.length; ++i) {
    const [right, to] = stops[i]!;
    const [left, from] = stops[i - 1]!;
    if (at > right && i + 1 < stops.length) continue;
    const t = Math.min(1, Math.max(0, (at - left) / (right - left)));
    return [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), from[2] + t * (to[2] - from[2])];
  }
  return stops[0]![1];
}

/** Cell under a pixel of a picture that the raster fills, cut at its longer side. */
function coverer(raster: Raster, width: number, height: number): (px: number, py: number) => [number, number] {
  const { columns, rows } = raster.frame;
  const scale = Math.min(columns / width, rows / height);
  const left = (columns - width * scale) / 2;
  const top = (rows - height * scale) / 2;
  const clamp = (value: number, count: number) => Math.min(count - 1, Math.max(0, Math.floor(value)));
  return (px, py) => [clamp(left + (px + 0.5) * scale, columns), clamp(top + (py + 0.5) * scale, rows)];
}

/** Light from the north-west on the ground, 0 to 1; slopes are exaggerated until the picture has relief. */
function shader(raster: Raster): (column: number, row: number) => number {
  const { columns, rows, cell_m } = raster.frame;
  const values = raster.values;
  const at = (column: number, row: number) => values[Math.min(rows - 1, Math.max(0, row)) * columns
    + Math.min(columns - 1, Math.max(0, column))]!;
  const relief = Math.max(1e-6, raster.max - raster.min);
  const exaggeration = Math.max(1, (0.22 * cell_m * Math.max(columns, rows)) / relief);
  return (column, row) => {
    const dx = ((at(column + 1, row) - at(column - 1, row)) / (2 * cell_m)) * exaggeration;
    const dy = ((at(column, row - 1) - at(column, row + 1)) / (2 * cell_m)) * exaggeration;
    if (!Number.isFinite(dx) || !Number.isFinite(dy)) return 0.7;
    return Math.min(1, Math.max(0, (0.5 * dx - 0.5 * dy + 0.72) / Math.sqrt(1 + dx * dx + dy * dy)));
  };
}

function terrainColour(raster: Raster): (value: number, light: number, dry: boolean) => Colour {
  return (value, light, dry) => {
    const flooded = value < 0 && !dry;
    const colour = flooded ? ramp(SEA, value / Math.min(-1e-9, raster.min))
      : ramp(LAND, (value - Math.max(0, raster.min)) / Math.max(1e-9, raster.max - Math.max(0, raster.min)));
    const strength = flooded ? 0.75 + 0.35 * light : 0.5 + 0.72 * light;
    return [colour[0] * strength, colour[1] * strength, colour[2] * strength];
  };
}

/** RGBA, row by row from the top. */
export function pictureOf(raster: Raster, kind: string, width: number, height: number): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(width * height * 4);
  const cell = coverer(raster, width, height);
  const light = kind === "terrain" ? shader(raster) : null;
  const terrain = terrainColour(raster);
  const range = Math.max(1e-12, raster.max - raster.min);
  for (let py = 0; py < height; ++py) {
    for (let px = 0; px < width; ++px) {
      const [column, row] = cell(px, py);
      const index = row * raster.frame.columns + column, value = raster.values[index]!;
      let colour = NOTHING;
      if (raster.values instanceof Uint8Array) colour = LABELS[value] ?? NOTHING;
      else if (Number.isFinite(value)) {
        const grey = 30 + (210 * (value - raster.min)) / range;
        colour = light ? terrain(value, light(column, row), raster.dry?.[index] === 255) : [grey, grey, grey];
      }
      pixels.set([colour[0], colour[1], colour[2], 255], (py * width + px) * 4);
    }
  }
  return pixels;
}
