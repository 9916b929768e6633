import assert from "node:assert/strict";
import { test } from "node:test";
import type { Json, Recipe } from "../api/types";
import { applyEdits } from "../document/apply";
import { eraseEdits, outsideDisc, outsideSweep } from "./erase";
import { featuresOf } from "./features";
import type { Point } from "./geometry";
import { coastOf, dragOutline, finer, nearestOutline, radiusAt, readOutlines, writeOutlines } from "./polar";
import { slotsOf } from "./slots";
import { operatorNamed } from "./testing/schema";

function erased(op: string, params: { [name: string]: Json }, way: Point[], radius: number): Json {
  const recipe: Recipe = { seamount: 1, steps: [{ id: "s", op, params }] };
  const features = featuresOf(recipe, "s", slotsOf(operatorNamed(op)));
  return applyEdits(recipe, eraseEdits(features, way, radius, 1)).steps[0]!.params! as Json;
}

test("a disc cuts a line in two, and knows where", () => {
  const pieces = outsideDisc([[0, 0], [100, 0]], [50, 0], 10)!;
  assert.deepEqual(pieces.map((piece) => piece.points), [[[0, 0], [40, 0]], [[60, 0], [100, 0]]]);
  assert.deepEqual(pieces.map((piece) => piece.from), [[0, 0.4], [0.6, 1]]);
  assert.equal(outsideDisc([[0, 0], [100, 0]], [50, 11], 10), null);
  assert.deepEqual(outsideDisc([[0, 0], [5, 0]], [2, 0], 10), []);
});

test("a sweep goes on cutting what is left", () => {
  const pieces = outsideSweep([[0, 0], [100, 0]], [[20, 0], [80, 0]], 10)!;
  assert.deepEqual(pieces.map((piece) => piece.points), [[[0, 0], [10, 0]], [[30, 0], [70, 0]], [[90, 0], [100, 0]]]);
  assert.deepEqual(pieces[1]!.from.map((at) => Number(at.toFixed(6))), [0.3, 0.7]);
});

test("pieces are things of their own with all that the line said", () => {
  assert.deepEqual(erased("contour.grow",
    { rivers: [{ points: [[0, 0], [100, 0]], bed_m: [10, 0], mouth_width_m: 5 }] }, [[50, 0]], 10), {
    rivers: [
      { points: [[0, 0], [40, 0]], bed_m: [10, 6], mouth_width_m: 5 },
      { points: [[60, 0], [100, 0]], bed_m: [4, 0], mouth_width_m: 5 },
    ],
  });
});

test("places and areas under it go as a whole; what is far stays", () => {
  const ridges: Json = [{ points: [[0, 500], [100, 500]] }];
  assert.deepEqual(erased("learned.sketch",
    { ridges, heights: [{ x_m: 0, y_m: 0, height_m: 1 }, { x_m: 900, y_m: 0, height_m: 1 }] }, [[5, 0]], 10), {
    ridges, heights: [{ x_m: 900, y_m: 0, height_m: 1 }],
  });
  assert.deepEqual(erased("island.build",
    { areas: [[[0, 0], [100, 0], [0, 100]], [[500, 500], [600, 500], [500, 600]]] }, [[0, 50]], 5), {
    areas: [[[500, 500], [600, 500], [500, 600]]],
  });
});

test("radii: read, written, found", () => {
  assert.deepEqual(readOutlines([100, [1, 2, 3, 4]]), [[100], [1, 2, 3, 4]]);
  assert.deepEqual(readOutlines([["a"]]), []);
  assert.deepEqual(writeOutlines([[5, 5, 5], [1, 2]]), [5, [1, 2]]);
  assert.equal(radiusAt([1, 2, 3, 4], Math.PI / 4), 1.5);
  assert.equal(finer([7]).length, 48);
  assert.equal(nearestOutline([[100], [200], [300]], [0, 190], [0, 0]), 1);
});

test("dragging an outline is soft, local, and crosses no other", () => {
  const drag = {
    outline: 0, from: [1000, 0] as Point, to: [1900, 0] as Point, centre: [0, 0] as Point, radius_m: 600, smooth: false,
    step: 10,
  };
  const [inner, outer] = dragOutline([[1000], [1500]], drag);
  assert.equal(inner![0], 1900);
  assert.ok(inner![2]! > 1000 && inner![2]! < 1900);
  assert.equal(inner![24], 1000);
  assert.ok(outer!.every((radius, i) => radius > inner![i]!));
  assert.equal(outer![24], 1500);
  const rough = finer([1000]).map((r, i) => r + (i % 2) * 100);
  const [smoother] = dragOutline([rough], { ...drag, from: [1000, 0], to: [1000, 0], smooth: true });
  assert.ok(smoother![0]! > 1000 && smoother![24] === 1000);
});

test("the coast of a label map", () => {
  const frame = { columns: 40, rows: 40, cell_m: 10, west: -200, north: 200, crs: "" };
  const values = new Uint8Array(1600).map(
    (_, i) => (Math.hypot((i % 40) - 19.5, Math.floor(i / 40) - 19.5) < 10 ? 0 : 4),
  );
  const raster = { key: "k", frame, values, coarse: false, min: 0, max: 4 };
  const coast = coastOf(raster, [0, 0], 1)!;
  assert.ok(coast.every((radius) => Math.abs(radius - 100) <= 12), String(coast));
  assert.equal(coastOf({ ...raster, values: new Uint8Array(1600).fill(4) }, [0, 0], 1), null);
});
