import assert from "node:assert/strict";
import { test } from "node:test";
import { shapesOf } from "./shapes_content";

const feature = (type: string, coordinates: never, properties = {}) => ({ type: "Feature", geometry: { type, coordinates }, properties });

test("features become shapes", () => {
  const shapes = shapesOf({
    type: "FeatureCollection",
    features: [
      feature("Point", [1, 2] as never, { class: "palm" }), feature("LineString", [[0, 0], [5, 5]] as never),
      feature("MultiPolygon", [[[[0, 0], [1, 0], [0, 1], [0, 0]]], [[[5, 5], [6, 5], [5, 6], [5, 5]]]] as never),
      feature("MultiLineString", [[[0, 0], [1, 1]]] as never), feature("Other", [] as never),
    ],
  }, "objects");
  assert.deepEqual(shapes.map((s) => s.shape), ["dot", "line", "line", "line", "line"]);
  assert.deepEqual(shapes[0], { shape: "dot", at: [1, 2], role: "height", label: "palm" });
  assert.deepEqual(shapesOf(null, "contours"), []);
});
