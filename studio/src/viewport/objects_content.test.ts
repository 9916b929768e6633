import assert from "node:assert/strict";
import { test } from "node:test";
import { nearestObject, objectShapes } from "./objects_content";

const object = (type: string, coordinates: number[] | number[][], name: string) =>
  ({ type: "Feature", geometry: { type, coordinates }, properties: { class: name } });
const catalogue = [
  { name: "palm", about: "", skeleton: "point" as const, colour: "#00ff00" },
  { name: "reef", about: "", skeleton: "curve" as const, colour: "#ff0000" },
];

test("objects of a class are marks of its colour, curves lines", () => {
  const { shapes, classes } = objectShapes({ type: "FeatureCollection", features: [
    object("Point", [1, 2], "palm"), object("LineString", [[0, 0], [5, 5]], "reef"), object("Point", [3, 4], "palm"),
  ] }, catalogue, true);
  assert.deepEqual(shapes, [
    { shape: "line", points: [[0, 0], [5, 5]], role: "ink", colour: "#ff0000", width_px: 1.5, only: "map" },
    { shape: "dots", places: [[1, 2], [3, 4]], colour: "#00ff00", only: "map" },
  ]);
  assert.deepEqual(classes, [{ name: "palm", count: 2, colour: "#00ff00" }, { name: "reef", count: 1, colour: "#ff0000" }]);
});

test("where nothing says what they look like they are marks in both views", () => {
  const { shapes } = objectShapes({ features: [object("Point", [1, 2], "palm")] }, catalogue, false);
  assert.deepEqual(shapes, [{ shape: "dots", places: [[1, 2]], colour: "#00ff00" }]);
  assert.deepEqual(objectShapes(null, [], false), { shapes: [], classes: [], objects: [] });
});

test("the object under the pen is the nearest one, by its line where it has one", () => {
  const palm = { name: "palm", points: [[1, 2]] as const }, reef = { name: "reef", points: [[0, 0], [10, 0]] as const };
  assert.equal(nearestObject([palm, reef], [5, 0.5], 3, false), reef);
  assert.equal(nearestObject([palm, reef], [1, 1.5], 3, false), palm);
  assert.equal(nearestObject([palm, reef], [1, 1.9], 3, true), reef);
  const ripple = { name: "ripple", points: [[4, 0.3], [5, 0.3]] as const };
  assert.equal(nearestObject([ripple, reef], [4.5, 0.3], 3, true), reef, "the longer one of two");
  assert.equal(nearestObject([palm, reef], [50, 50], 3, false), null);
});
