import assert from "node:assert/strict";
import { test } from "node:test";
import { dragged, evenStep, pixelStep, rounded, scaleOf } from "./scale";

const options = { usual: null, unit: "m", integer: false };

test("scales are inverse and ascend", () => {
  for (const [min, max, usual] of [[0, 1, 0.5], [0.1, 1e6, null], [0, 1000, 3], [-20000, 20000, 0], [-12000, -1, null],
    [1e-4, 1e6, 10], [0, 9000, null], [-1, 1, 0.5]] as const) {
    const scale = scaleOf({ ...options, min, max, usual });
    let before = -Infinity;
    for (let share = 0; share <= 1.0001; share += 0.05) {
      const value = scale.value(share);
      assert.ok(value >= min && value <= max, `${value} in [${min}, ${max}]`);
      assert.ok(value > before || share > 1);
      before = value;
      if (share <= 1) assert.ok(Math.abs(scale.share(value) - share) < 1e-6);
    }
    assert.equal(Math.abs(scale.value(0) - min) < 1e-9 * Math.max(1, Math.abs(min)), true);
  }
});

test("small values of long ranges can be set", () => {
  const scale = scaleOf({ ...options, min: 0, max: 1000, usual: 3 });
  assert.ok(scale.share(3) > 0.15 && scale.share(3) < 0.5);
  const degrees = scaleOf({ ...options, unit: "deg", min: 0, max: 360, usual: 0 });
  assert.equal(degrees.value(0.5), 180);
});

test("steps are even", () => {
  assert.equal(evenStep(0.034), 0.02);
  assert.equal(evenStep(7), 5);
  assert.equal(evenStep(1000), 1000);
  assert.equal(rounded(0.30000001, 0.1), 0.3);
  assert.equal(pixelStep(0.5, scaleOf({ ...options, min: 0, max: 1, usual: 0.5 }), 200, false), 0.005);
  assert.equal(pixelStep(0, null, 200, true), 1);
});

test("dragging", () => {
  const scale = scaleOf({ ...options, min: 0, max: 1, usual: 0.5 });
  const bounds = { min: 0, max: 1, integer: false };
  const drag = { start: 0.5, dx: 20, width: 200, snap: false, fine: false };
  assert.equal(dragged(drag, scale, bounds), 0.6);
  assert.equal(dragged({ ...drag, fine: true }, scale, bounds), 0.51);
  assert.equal(dragged({ ...drag, dx: 23, snap: true }, scale, bounds), 0.6);
  assert.equal(dragged({ ...drag, dx: 900 }, scale, bounds), 1);
  assert.equal(dragged({ ...drag, start: 3, dx: 4 }, null, { integer: true }), 7);
});
