import assert from "node:assert/strict";
import { test } from "node:test";
import { shapesOf } from "./shapes_content";

const feature = (type: string, coordinates: never) => ({ type: "Feature", geometry: { type, coordinates }, properties: {} });

test("features become shapes", () => {
  const shapes = shapesOf({
    type: "FeatureCollection",
    features: [
      feature("Point", [1, 2] as never), feature("LineString", [[0, 0], [5, 5]] as never),
      feature("MultiPolygon", [[[[0, 0], [1, 0], [0, 1], [0, 0]]], [[[5, 5], [6, 5], [5, 6], [5, 5]]]] as never),
      feature("MultiLineString", [[[0, 0], [1, 1]]] as never), feature("Other", [] as never),
    ],
  }, "drawing");
  assert.deepEqual(shapes.map((s) => s.shape), ["dot", "line", "line", "line", "lines"]);
  assert.deepEqual(shapes[0], { shape: "dot", at: [1, 2], role: "ink" });
});

test("contours and the edges of a network are one shape", () => {
  const first = [[0, 0], [5, 5]], second = [[1, 1], [2, 3]];
  const contours = { features: [feature("LineString", first as never), feature("LineString", second as never)] };
  assert.deepEqual(shapesOf(contours, "contours"), [{ shape: "lines", lines: [first, second], role: "contour", width_px: 1.25 }]);
  const network = { features: [feature("MultiLineString", [first, second] as never)] };
  assert.deepEqual(shapesOf(network, "tin"), [{ shape: "lines", lines: [first, second], role: "ink", width_px: 0.75 }]);
  assert.deepEqual(shapesOf(null, "contours"), [{ shape: "lines", lines: [], role: "contour", width_px: 1.25 }]);
});
