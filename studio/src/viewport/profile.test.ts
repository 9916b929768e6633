import assert from "node:assert/strict";
import { test } from "node:test";
import { profileAlong } from "./profile";

test("a profile follows the line and adds up its climbs", () => {
  const data = profileAlong([[0, 0], [100, 0], [100, 50]], (x, y) => x - 2 * y, 301)!;
  assert.equal(data.length, 150);
  assert.equal(data.distance[300], 150);
  assert.ok(Math.abs(data.max - 100) < 0.5 && Math.abs(data.min) < 0.5);
  assert.ok(Math.abs(data.rise - 100) < 1 && Math.abs(data.fall - 100) < 1);
  assert.deepEqual(data.places[300], [100, 50]);
});

test("beside the terrain there is none", () => {
  assert.equal(profileAlong([[0, 0], [10, 0]], () => null), null);
  assert.equal(profileAlong([[0, 0]], () => 1), null);
  const part = profileAlong([[0, 0], [10, 0]], (x) => (x < 5 ? 3 : null), 11)!;
  assert.equal(part.height[10], null);
  assert.equal(part.rise, 0);
});
