import assert from "node:assert/strict";
import { test } from "node:test";
import { fitLine, fitRing, fitStroke, type Sample } from "./fit";
import { distance, lengthOf, ringArea, simpleRing, simplified, toSegment, type Point } from "./geometry";
import { recorded } from "./testing/strokes";

const options = { pixel_m: 20, cell_m: 30 };

const farthest = (drawn: readonly Point[], fitted: readonly Point[]) =>
  Math.max(...drawn.map((p) => Math.min(...fitted.slice(1).map((b, i) => toSegment(p, fitted[i]!, b).distance))));

const samples = (points: readonly Point[], pressure = 1): Sample[] => points.map(([x, y]) => ({ x, y, pressure }));

test("a recorded stroke of hundreds of samples becomes some dozens of points that lie on it", () => {
  for (const stroke of recorded) {
    const fitted = fitLine(stroke, options);
    assert.ok(fitted.length >= 8 && fitted.length <= 60, `${fitted.length} points of ${stroke.length}`);
    const off = farthest(stroke.map((s): Point => [s.x, s.y]), fitted);
    assert.ok(off < 4 * options.pixel_m, `${off} m off`);
    assert.ok(Math.abs(lengthOf(fitted) / lengthOf(stroke.map((s): Point => [s.x, s.y])) - 1) < 0.1);
  }
});

test("a straight line is two points, jitter or not, and its ends are where they were drawn", () => {
  const straight = Array.from({ length: 200 }, (_, i): Point => [i * 30, (i % 3) * 6]);
  const fitted = fitLine(samples(straight), options);
  assert.equal(fitted.length, 2);
  assert.deepEqual(fitted, [[0, 0], [5970, 10]]);
});

test("a corner stays a corner", () => {
  const corner = [...Array(60).keys()].map((i): Point => (i < 30 ? [i * 40, 0] : [29 * 40, (i - 29) * 40]));
  const fitted = fitLine(samples(corner), options);
  assert.ok(Math.min(...fitted.map((p) => distance(p, [1160, 0]))) < 2 * options.pixel_m);
});

test("nothing finer than a quarter of a cell is kept, and numbers are round", () => {
  const wave = Array.from({ length: 400 }, (_, i): Point => [i * 25.3, 900 * Math.sin(i / 30)]);
  const coarse = fitLine(samples(wave), { pixel_m: 5, cell_m: 800 });
  const fine = fitLine(samples(wave), { pixel_m: 5, cell_m: 10 });
  assert.ok(coarse.length < fine.length);
  assert.ok(coarse.every(([x, y]) => x % 100 === 0 && y % 100 === 0), JSON.stringify(coarse));
});

test("pressure is kept where it changes", () => {
  const line = Array.from({ length: 100 }, (_, i): Sample => ({ x: i * 50, y: 0, pressure: i < 50 ? 0.2 : 0.8 }));
  const fitted = fitStroke(line, options);
  assert.ok(fitted.length > 2);
  assert.ok(Math.abs(fitted[0]!.pressure - 0.2) < 0.02 && Math.abs(fitted.at(-1)!.pressure - 0.8) < 0.02);
});

test("a dab is one point, nothing is none", () => {
  assert.equal(fitStroke([{ x: 3, y: 4, pressure: 0.5 }], options).length, 1);
  assert.equal(fitStroke([], options).length, 0);
  assert.equal(fitStroke([{ x: NaN, y: 4, pressure: 1 }], options).length, 0);
});

test("a ring whose ends overlap is closed without crossing itself", () => {
  const turns = Array.from({ length: 220 }, (_, i): Point => {
    const angle = (i / 200) * 2 * Math.PI;
    return [(2000 + i) * Math.cos(angle), (2000 + i) * Math.sin(angle)];
  });
  const ring = fitRing(samples(turns), options);
  assert.ok(ring.length > 10 && ring.length <= 60);
  assert.deepEqual(simpleRing(ring), ring);
  assert.ok(Math.abs(ringArea(ring)) > 0.9 * Math.PI * 2000 ** 2);
});

test("of a figure of eight the larger loop stays", () => {
  const eight: Point[] = [[0, 0], [10, 10], [10, 0], [0, 10], [-30, 40], [-30, -30]];
  const ring = simpleRing(eight);
  assert.ok(Math.abs(ringArea(ring)) > 100);
  assert.deepEqual(simpleRing(ring), ring);
});

test("simplified keeps a ring a ring", () => {
  const circle = Array.from({ length: 100 }, (_, i): Point => [100 * Math.cos(i / 15.9), 100 * Math.sin(i / 15.9)]);
  const few = simplified(circle, 2, true);
  assert.ok(few.length >= 8 && few.length < 30);
  assert.ok(Math.abs(ringArea(few) / ringArea(circle) - 1) < 0.05);
});
