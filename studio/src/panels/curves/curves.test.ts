import assert from "node:assert/strict";
import { test } from "node:test";
import { added, moved, removed, split } from "./knots";
import { fromPixel, keyStep, ticks, toPixel, viewedValues } from "./curve_view";
import { painted } from "./histogram";
import { type Knot, curveFunction } from "./monotone";

const profile: Knot[] = [[0, 900], [1, 120], [2, 0], [3, -15], [4, -5], [5, -1100]];
const bounds = { x: [0, 5], y: [-12000, 12000], apart: 0.01 } as const;

test("through every knot, never beyond them, constant outside", () => {
  const f = curveFunction(profile);
  for (const [x, y] of profile) assert.equal(f(x), y);
  for (let i = 0; i + 1 < profile.length; ++i) {
    for (let t = 0; t <= 1; t += 0.05) {
      const [a, b] = [profile[i]!, profile[i + 1]!];
      const y = f(a[0] + t * (b[0] - a[0]));
      assert.ok(y <= Math.max(a[1], b[1]) && y >= Math.min(a[1], b[1]));
    }
  }
  assert.equal(f(-3), 900);
  assert.equal(f(9), -1100);
});

test("the library's numbers", () => {
  // CurveFunction of (0, 0), (1, 1), (3, 2): slopes 1.1666..., 0.6774..., 0.3333... .
  const f = curveFunction([[0, 0], [1, 1], [3, 2]]);
  const m = 3 + 3 / 1;
  const inner = (5 + 4) / (5 / 1 + 4 / 0.5);
  assert.ok(m > 0);
  assert.ok(Math.abs(f(0.5) - (0.5 + 0.125 * ((2 * 1 + 2) * 1 / 3 - 0.5 / 3 - inner))) < 1e-12);
  assert.equal(curveFunction([[0, 0], [2, 4]])(0.5), 1);
  assert.equal(curveFunction([[0, 0], [1, 4], [2, 0]], "linear")(1.5), 2);
  assert.equal(curveFunction([[1, 7]])(3), 7);
  assert.equal(curveFunction([])(3), 0);
});

test("knots stay in order and in bounds", () => {
  assert.deepEqual(moved(profile, 2, [9, 20000], bounds)[2], [2.99, 12000]);
  assert.deepEqual(moved(profile, 0, [0.5, 950], bounds, true)[0], [0, 950]);
  assert.deepEqual(moved(profile, 0, [0.5, 950], bounds)[0], [0.5, 950]);
  assert.equal(added(profile, [1.001, 3], bounds), null);
  assert.deepEqual(added(profile, [1.5, 3], bounds)?.index, 2);
  assert.equal(removed(profile, 1).length, 5);
  assert.deepEqual(split(profile, 4, bounds, "linear")?.knots[5], [4.5, -552.5]);
});

test("views and ticks", () => {
  assert.deepEqual(ticks([0, 1], 4), [0, 0.25, 0.5, 0.75, 1]);
  assert.deepEqual(ticks([-1100, 900], 4), [-1000, -500, 0, 500]);
  assert.deepEqual(viewedValues(profile, { ...bounds, y: [0, 1] }), [0, 1]);
  const view = { x: [0, 5], y: viewedValues(profile, bounds), width: 300, height: 150 } as const;
  const [px, py] = toPixel(view, [2, 30]);
  const [x, y] = fromPixel(view, px, py);
  assert.ok(Math.abs(x - 2) < 1e-9 && Math.abs(y - 30) < 1e-9);
  assert.equal(keyStep([0, 1], false), 0.01);
});

test("painting bars", () => {
  assert.deepEqual(painted([1, 1, 1, 1], { bar: 0, share: 0 }, { bar: 2, share: 1 }, 2), [0, 1, 2, 1]);
  assert.deepEqual(painted([1, 1], { bar: 1, share: 0.2 }, { bar: 1, share: 0.5 }, 1), [1, 0.5]);
});
