import assert from "node:assert/strict";
import { test } from "node:test";
import { DetailGround, finerOf, heightAt, hiddenBehind, pickGround } from "./detail_ground";
import { frameOfWindow, innerRectangle, type Source, type Window } from "./detail_window";
import { frameOfLevel } from "../document/results";
import { HeightField } from "./heights";
import { choosePatches, patchNumbers } from "./patches";

const source: Source = {
  key: "k", frame: { columns: 1024, rows: 1024, cell_m: 10, west: 0, north: 10240, crs: "" }, level: 2,
};
const window: Window = { level: 0, x: 256, y: 320, columns: 384, rows: 320 };

/** Hills with furrows that the coarse cells do not see. */
const trueHeight = (x: number, y: number): number =>
  150 + 100 * Math.sin(x / 900) * Math.cos(y / 700) + 12 * Math.cos((Math.PI * (x - 5)) / 20);

function sampled(frame: { columns: number; rows: number; cell_m: number; west: number; north: number }): Float32Array {
  return Float32Array.from({ length: frame.columns * frame.rows }, (_, i) =>
    trueHeight(
      frame.west + ((i % frame.columns) + 0.5) * frame.cell_m,
      frame.north - (Math.floor(i / frame.columns) + 0.5) * frame.cell_m,
    ));
}

const coarse = new HeightField(
  frameOfLevel(source.frame, 2, 256, 256), sampled(frameOfLevel(source.frame, 2, 256, 256)), "k", false,
);
const detail = new DetailGround(coarse, source, window, sampled(frameOfWindow(source, window)));
const inner = innerRectangle(source, window);

test("heights are the fine ones within a window and the coarse ones beside it, without a step between", () => {
  const middle = [0.5 * (inner.west + inner.east) + 5, 0.5 * (inner.south + inner.north) + 5] as const;
  assert.equal(detail.weight(...middle), 1);
  assert.ok(Math.abs(heightAt(coarse, detail, ...middle)! - trueHeight(...middle)) < 6);
  assert.equal(heightAt(coarse, detail, 500, 500), coarse.at(500, 500));
  assert.equal(heightAt(coarse, detail, -500, 500), null);
  let before = heightAt(coarse, detail, 2000, middle[1])!;
  for (let x = 2001; x < 4000; ++x) {
    const height = heightAt(coarse, detail, x, middle[1])!;
    assert.ok(Math.abs(height - before) < 2.6, String(x));
    before = height;
  }
});

test("what knows a place most finely is asked", () => {
  const other = new DetailGround(
    coarse, source, { ...window, level: 1, x: 128, y: 160, columns: 192, rows: 160 }, new Float32Array(192 * 160),
  );
  assert.equal(finerOf([other, detail], 4500, 5400), detail);
  assert.equal(finerOf([null, other], 4500, 5400), other);
  assert.equal(finerOf([other, detail], 100, 100), null);
});

test("a ray meets the fine ground where that is known", () => {
  for (const [x, y] of [[4505, 5405], [4515, 5421], [800, 800]] as const) {
    const ray = { from: [x - 900, y - 300, 900], to: [x, y, heightAt(coarse, detail, x, y)!] } as const;
    const t = pickGround(coarse, detail, ray)!;
    const along = (k: number): number => ray.from[k as 0]! + t * (ray.to[k as 0]! - ray.from[k as 0]!);
    const at = [along(0), along(1), along(2)] as const;
    assert.ok(Math.abs(at[2] - heightAt(coarse, detail, at[0], at[1])!) < 0.5, String([x, y]));
  }
  const low = heightAt(coarse, detail, 4505, 5400)! + 0.5;
  assert.ok(hiddenBehind(coarse, detail, [4505, 5400, low], [4545, 5400, low + 4]), "behind a furrow's crest");
  assert.ok(!hiddenBehind(coarse, null, [800, 800, coarse.at(800, 800)! + 1], [820, 800, coarse.at(800, 800)! + 300]));
});

test("bounds hold the fine heights", () => {
  for (const [east, south, side] of [[2700, 3600, 40], [2560, 3200, 640], [0, 0, 10240], [100, 100, 80]] as const) {
    const [least, greatest] = detail.bounds(east, south, side, 150, 150);
    for (let k = 0; k < 200; ++k) {
      const x = coarse.frame.west + east + side * ((k * 0.618) % 1);
      const y = coarse.frame.north - south - side * ((k * 0.414) % 1);
      if (detail.weight(x, y) < 1) continue;
      const height = detail.field.at(x, y)!;
      assert.ok(height >= least - 1e-3 && height <= greatest + 1e-3);
    }
  }
});

test("patches are finer than coarse cells near the eye, cover the ground once, and keep to the budget", () => {
  const view = { eye: [4500, 4900, 320], planes: [], exaggeration: 1, floor: -Infinity, detail } as const;
  const fine = choosePatches(coarse, { ...view, budget: 1000 });
  let area = 0, least = Infinity;
  for (let i = 0; i < fine.count; ++i) {
    const side = fine.numbers[i * patchNumbers + 2]!;
    area += side * side;
    least = Math.min(least, side);
  }
  assert.equal(least, 4);
  assert.equal(area, 256 * 256);
  const few = choosePatches(coarse, { ...view, budget: 120 });
  assert.ok(few.count <= choosePatches(coarse, { ...view, detail: null, budget: 1 }).count || few.count <= 120);
});
