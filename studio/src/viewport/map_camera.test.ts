import assert from "node:assert/strict";
import { test } from "node:test";
import { fitted, panned, toGround, toScreen, zoomed } from "./map_camera";

const size = { width: 800, height: 500 };
const eye = { x: 1000, y: 2000, pixel_m: 10 };

test("north is up and places come back", () => {
  assert.deepEqual(toScreen(eye, size, 1000, 2100), [400, 240]);
  assert.deepEqual(toGround(eye, size, 400, 240), [1000, 2100]);
});

test("zooming keeps the place under the cursor, panning takes it along", () => {
  const before = toGround(eye, size, 120, 400);
  assert.deepEqual(toGround(zoomed(eye, size, 120, 400, 0.5, 1, 100), size, 120, 400), before);
  assert.deepEqual(toGround(panned(eye, 30, -20), size, 150, 380), before);
  assert.equal(zoomed(eye, size, 0, 0, 1e-9, 2, 100).pixel_m, 2);
});

test("a fitted rectangle is inside the margins", () => {
  const fit = fitted({ west: 0, east: 5000, south: -1000, north: 1000 }, size);
  const [left, top] = toScreen(fit, size, 0, 1000);
  assert.ok(Math.abs(left - 24) < 1e-9 && top >= 24);
});
