import assert from "node:assert/strict";
import { test } from "node:test";
import { circle, runs, subdivided, type Projector } from "./drape";

const straight: Projector = { project: (x, y) => [x, -y], pixelSize: () => 1, hidden: () => false, flat: true };

test("a subdivided line keeps its corners and has short pieces", () => {
  const line = subdivided([[0, 0], [10, 0], [10, 5]], 3);
  assert.deepEqual(line[0], [0, 0]);
  assert.ok(line.some(([x, y]) => x === 10 && y === 0));
  assert.deepEqual(line[line.length - 1], [10, 5]);
  for (let i = 1; i < line.length; ++i) assert.ok(
    Math.hypot(line[i]![0] - line[i - 1]![0], line[i]![1] - line[i - 1]![1]) <= 3,
  );
  assert.ok(subdivided([[0, 0], [1e6, 0]], 0.001).length <= 3002);
});

test("closed lines end where they begin", () => {
  const [run] = runs([[0, 0], [1, 0], [1, 1]], true, straight);
  assert.deepEqual(run!.points[0], run!.points[run!.points.length - 1]);
});

test("lines break where ground hides them and where they pass behind the eye", () => {
  const hill: Projector = {
    ...straight, flat: false, hidden: (x) => x > 20 && x < 60, project: (x, y) => (x > 90 ? null : [x, y]),
  };
  const pieces = runs([[0, 0], [100, 0]], false, hill);
  assert.deepEqual(pieces.map((p) => p.hidden), [false, true, false]);
  assert.deepEqual(pieces[0]!.points[pieces[0]!.points.length - 1], pieces[1]!.points[0]);
});

test("a circle has its radius", () => {
  for (const [x, y] of circle(5, 6, 7)) assert.ok(Math.abs(Math.hypot(x - 5, y - 6) - 7) < 1e-9);
});
