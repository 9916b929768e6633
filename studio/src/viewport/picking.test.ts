import assert from "node:assert/strict";
import { test } from "node:test";
import { hiddenBehind } from "./detail_ground";
import { HeightField } from "./heights";
import { pick } from "./picking";

const frame = { columns: 96, rows: 64, cell_m: 10, west: 1000, north: 5000, crs: "" };

function cone(): HeightField {
  const values = new Float32Array(96 * 64);
  for (let y = 0; y < 64; ++y) {
    for (let x = 0; x < 96; ++x) values[y * 96 + x] = 200 - 10 * Math.hypot(x + 0.5 - 48, y + 0.5 - 32);
  }
  return new HeightField(frame, values, "k", false);
}

test("the tree holds the heights", () => {
  const field = cone();
  assert.ok(field.max > 190 && field.max <= 200);
  assert.equal(field.tree[field.tree.length - 1]!.low[0], field.min);
  assert.ok(field.inSea);
});

test("a ray straight down meets the sampled height", () => {
  const field = cone();
  const t = pick(field, { from: [1400, 4700, 1000], to: [1400, 4700, 0] })!;
  assert.ok(Math.abs(1000 - t * 1000 - field.at(1400, 4700)!) < 0.01);
});

test("slanting rays meet what a fine march meets", () => {
  const field = cone();
  let seed = 1;
  const random = (): number => ((seed = (seed * 16807) % 2147483647) / 2147483647);
  for (let i = 0; i < 300; ++i) {
    const angle = 2 * Math.PI * random();
    const from = [1480 + 900 * Math.cos(angle), 4680 + 900 * Math.sin(angle), 100 + 500 * random()] as const;
    const to = [1100 + 700 * random(), 4450 + 450 * random(), -300] as const;
    let want: number | null = null;
    for (let k = 0; k <= 40000 && want === null; ++k) {
      const t = k / 20000, h = field.at(from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]));
      if (h !== null && from[2] + t * (to[2] - from[2]) <= h) want = t;
    }
    const got = pick(field, { from, to });
    assert.equal(got === null, want === null);
    if (got !== null && want !== null) assert.ok(Math.abs(got - want) < 2e-3, `${got} ${want}`);
  }
});

test("water stops rays, and a summit hides what is behind", () => {
  const field = cone();
  const t = pick(field, { from: [1050, 4950, 100], to: [1050, 4950, 0] }, 0)!;
  assert.ok(Math.abs(t - 1) < 1e-6);
  assert.ok(hiddenBehind(field, null, [1880, 4680, field.at(1880, 4680)! + 1], [1050, 4680, 60]));
  assert.ok(!hiddenBehind(field, null, [1300, 4680, field.at(1300, 4680)! + 1], [1050, 4680, 60]));
});

test("unknown cells have no height, but can be sampled", () => {
  const values = new Float32Array(96 * 64).fill(5);
  values[5] = NaN;
  const field = new HeightField(frame, values, "k", false);
  assert.equal(field.at(1055, 4995), null);
  assert.equal(field.sample(5.5, 0.5), 5);
});
