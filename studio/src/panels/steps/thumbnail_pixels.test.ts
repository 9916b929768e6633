import assert from "node:assert/strict";
import { test } from "node:test";
import type { Raster } from "../../viewport/types";
import { pictureOf } from "./thumbnail_pixels";

const raster = (values: Float32Array | Uint8Array, columns: number, min = 0, max = 1): Raster => ({
  key: "k", values, coarse: true, min, max,
  frame: { columns, rows: values.length / columns, cell_m: 10, west: 0, north: 0, crs: "" },
});
const pixel = (pixels: Uint8ClampedArray, i: number) => [...pixels.slice(i * 4, i * 4 + 4)];

test("labels have their colours, fields are grey, what is unknown is neither", () => {
  assert.deepEqual(pixel(pictureOf(raster(new Uint8Array([0, 4]), 2), "labels", 2, 1), 1), [39, 81, 138, 255]);
  const field = pictureOf(raster(new Float32Array([0, 1, NaN, 0.5]), 4), "field", 4, 1);
  assert.deepEqual(pixel(field, 0), [30, 30, 30, 255]);
  assert.deepEqual(pixel(field, 1), [240, 240, 240, 255]);
  assert.deepEqual(pixel(field, 2), [96, 104, 112, 255]);
});

test("sea is blue, land is not, and slopes to the light are brighter", () => {
  const heights = Float32Array.from({ length: 64 }, (_, i) => (i % 8) * 100 - 350);
  const pixels = pictureOf(raster(heights, 8, -350, 350), "terrain", 8, 8);
  const [r = 0, , b = 0] = pixel(pixels, 8);
  assert.ok(b > r);
  const [r2 = 0, , b2 = 0] = pixel(pixels, 14);
  assert.ok(r2 > b2);
  const falling = Float32Array.from(heights, (h) => -h);
  const east = pictureOf(raster(falling.map((h) => h + 400), 8, 50, 750), "terrain", 8, 8);
  const west = pictureOf(raster(heights.map((h) => h + 400), 8, 50, 750), "terrain", 8, 8);
  assert.notDeepEqual(pixel(east, 28), pixel(west, 27));
});

test("long rasters are cut, not squeezed", () => {
  const values = Uint8Array.from({ length: 8 * 2 }, (_, i) => (i % 8 < 3 || i % 8 > 4 ? 0 : 4));
  const pixels = pictureOf(raster(values, 8), "labels", 2, 2);
  assert.deepEqual(pixel(pixels, 0), [39, 81, 138, 255]);
});
