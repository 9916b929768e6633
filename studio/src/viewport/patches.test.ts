import assert from "node:assert/strict";
import { test } from "node:test";
import { HeightField } from "./heights";
import { choosePatches, morphed, patchCells, patchNumbers, type PatchView } from "./patches";

function hills(columns: number, rows: number): HeightField {
  const values = new Float32Array(columns * rows);
  for (let y = 0; y < rows; ++y) {
    for (let x = 0; x < columns; ++x) values[y * columns + x] = 40 * Math.sin(x / 17) * Math.cos(y / 23) + 5;
  }
  return new HeightField({ columns, rows, cell_m: 10, west: 0, north: 0, crs: "" }, values, "k", false);
}

const everywhere: PatchView = { eye: [1500, 2600, 120], planes: [], exaggeration: 1, floor: -Infinity, budget: 100000 };

function listed(field: HeightField, view: PatchView): number[][] {
  const { count, numbers } = choosePatches(field, view);
  return Array.from({ length: count }, (_, i) => [...numbers.subarray(i * patchNumbers, (i + 1) * patchNumbers)]);
}

test("the patches cover the ground once", () => {
  const field = hills(500, 300);
  let area = 0;
  for (const [x, y, side] of listed(field, everywhere)) {
    area += Math.max(0, Math.min(500, x! + side!) - x!) * Math.max(0, Math.min(300, y! + side!) - y!);
  }
  assert.equal(area, 500 * 300);
});

test("where patches of different levels meet, the finer has morphed and the coarser has not", () => {
  const field = hills(512, 512);
  for (const eye of [[1500, 2600, 120], [100, 100, 60], [2560, 2560, 900]] as const) {
    const patches = listed(field, { ...everywhere, eye, budget: 1 });
    assert.ok(new Set(patches.map((p) => p[2])).size > 1);
    const distance = (x: number, y: number): number =>
      Math.hypot(x * 10 - eye[0], y * 10 - eye[1], field.sample(x, y) - eye[2]);
    for (const fine of patches) {
      for (const coarse of patches) {
        if (coarse[2]! <= fine[2]!) continue;
        assert.ok(coarse[2] === 2 * fine[2]! || !touch(fine, coarse), "neighbours differ by one level");
        if (coarse[2] !== 2 * fine[2]!) continue;
        for (let k = 0; k <= patchCells; ++k) {
          for (const [i, j] of [[0, k], [patchCells, k], [k, 0], [k, patchCells]] as const) {
            const x = fine[0]! + (i * fine[2]!) / patchCells, y = fine[1]! + (j * fine[2]!) / patchCells;
            if (
              x < coarse[0]! || y < coarse[1]! || x > coarse[0]! + coarse[2]! || y > coarse[1]! + coarse[2]!
            ) continue;
            const d = distance(x, y);
            assert.ok(d >= fine[4]! - 1e-3, "the finer one is in its parent's grid");
            assert.ok(d <= coarse[3]! + 1e-3, "the coarser one is in its own grid");
            const [mx, my] = morphed(fine, i, j, d);
            assert.ok(Number.isInteger((mx - coarse[0]!) / (coarse[2]! / patchCells)) || mx === x);
            assert.ok(Number.isInteger((my - coarse[1]!) / (coarse[2]! / patchCells)) || my === y);
          }
        }
      }
    }
  }
});

function touch(a: number[], b: number[]): boolean {
  return a[0]! <= b[0]! + b[2]! && b[0]! <= a[0]! + a[2]! && a[1]! <= b[1]! + b[2]! && b[1]! <= a[1]! + a[2]!;
}

test("the budget is kept as far as neighbours still meet; what is not seen and what is flooded is left out", () => {
  const field = hills(512, 512);
  const all = listed(field, everywhere).length;
  assert.ok(listed(field, { ...everywhere, budget: 200 }).length <= Math.max(200, 0.7 * all));
  const half = listed(field, { ...everywhere, planes: [1, 0, 0, -2560] });
  assert.ok(half.every(([x, , side]) => (x! + side!) * 10 >= 2560) && half.length < all);
  assert.equal(listed(field, { ...everywhere, floor: 100 }).length, 0);
});
