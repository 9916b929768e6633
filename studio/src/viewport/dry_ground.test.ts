import assert from "node:assert/strict";
import { test } from "node:test";
import { readRaster } from "../api/client";
import { DetailGround, dryAt, pickGround } from "./detail_ground";
import { HeightField } from "./heights";
import { choosePatches, patchNumbers } from "./patches";
import { tintPlace, tintScale } from "./tints";

const size = 64, frame = { columns: size, rows: size, cell_m: 10, west: 0, north: 640, crs: "" };
const hollow = (x: number, y: number): boolean => x >= 8 && x < 24 && y >= 8 && y < 24;
const beside = (x: number, y: number): boolean => x >= 7 && x < 25 && y >= 7 && y < 25;

/** Land with a hollow of 50 m below the sea in the north-west, and a sea as deep in the east. */
function field(dry = true): HeightField {
  const values = new Float32Array(size * size).fill(30), marks = new Uint8Array(size * size);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      if (hollow(x, y)) values[y * size + x] = -50;
      if (x >= 40) values[y * size + x] = -70;
      if (beside(x, y)) marks[y * size + x] = 255;
    }
  }
  return new HeightField(frame, values, "k", false, dry ? marks : null);
}

test("a raster's bytes end in what is dry", () => {
  const bytes = new Uint8Array(2 * 4 + 2);
  new Float32Array(bytes.buffer, 0, 2).set([-5, 7]);
  bytes.set([255, 0], 8);
  const { values, dry } = readRaster("2 1 f32 dry", bytes.buffer);
  assert.deepEqual([[...values], [...dry!]], [[-5, 7], [255, 0]]);
  assert.equal(readRaster("2 1 f32", bytes.buffer.slice(0, 8)).dry, undefined);
});

test("water lies over the sea's floor and not in a dry hollow", () => {
  const ground = field();
  assert.equal(ground.surface(16, 16, 0), -50);
  assert.equal(ground.surface(50, 16, 0), 0);
  assert.equal(field(false).surface(16, 16, 0), 0);
  // Down to where the ground itself crosses the level, at the hollow's border.
  for (let u = 7; u < 10; u += 0.1) assert.ok(Math.abs(ground.surface(u, 16, 0) - ground.sample(u, 16)) < 1e-6);
  assert.deepEqual([ground.lowestSea, ground.lowestDry], [-70, -50]);
  assert.deepEqual([field(false).lowestSea, field(false).lowestDry], [-70, 0]);
});

test("a ray meets the hollow's floor, and the sea's surface", () => {
  const at = (x: number, y: number): number =>
    100 + 200 * -pickGround(field(), null, { from: [x - 40, y + 20, 100], to: [x, y, -100] }, 0)!;
  assert.ok(Math.abs(at(165, 475) + 50) < 0.5);
  assert.ok(Math.abs(at(505, 475)) < 0.5);
});

test("patches of a dry hollow are drawn, those of a sea's floor are not", () => {
  const view = { eye: [320, 320, 900], planes: [], exaggeration: 1, floor: 0, budget: 1000 } as const;
  const drawn = (ground: HeightField, x: number, y: number): boolean => {
    const { count, numbers } = choosePatches(ground, view);
    for (let i = 0; i < count; ++i) {
      const [west, north, side] = numbers.subarray(i * patchNumbers, i * patchNumbers + 3) as unknown as number[];
      if (x >= west! && x < west! + side! && y >= north! && y < north! + side!) return true;
    }
    return false;
  };
  const all = field(), values = all.values.map((h) => Math.min(h, -1));
  const low = new HeightField(frame, values, "k", false, all.dry);
  assert.ok(drawn(low, 16, 16));
  assert.ok(!drawn(low, 56, 56));
  assert.ok(!drawn(new HeightField(frame, values, "k", false), 16, 16));
});

test("a window of finer ground says it for itself", () => {
  const source = { key: "k", frame: { ...frame, columns: 256, rows: 256, cell_m: 2.5 }, level: 2 };
  const window = { level: 0, x: 0, y: 0, columns: 128, rows: 256 };
  const fine = new DetailGround(
    field(false), source, window, new Float32Array(128 * 256).fill(-50), new Uint8Array(128 * 256).fill(255),
  );
  assert.ok(dryAt(field(false), fine, 100, 320));
  assert.ok(!dryAt(field(false), fine, 600, 320));
  const none = new DetailGround(field(), source, window, new Float32Array(128 * 256).fill(-50));
  assert.ok(!dryAt(field(), none, 165, 475));
  assert.ok(dryAt(field(), null, 165, 475));
});

test("dry ground has the tints of land, from its lowest", () => {
  const scale = tintScale(-300, 900, -86);
  assert.ok(scale.base <= -86 && scale.base > -120);
  assert.ok(tintPlace(scale, -50) < 0.5);
  assert.ok(tintPlace(scale, -50, true) > 0.5 && tintPlace(scale, -50, true) < tintPlace(scale, 0, true));
  assert.equal(tintScale(-300, 900).base, 0);
});
