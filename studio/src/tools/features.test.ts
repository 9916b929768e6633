import assert from "node:assert/strict";
import { test } from "node:test";
import type { Edit, Json, Recipe } from "../api/types";
import { applyEdits } from "../document/apply";
import { create, insertPoint, moveFeature, newItem, removeFeatures, removePoints, setPoints } from "./changes";
import { featuresOf, type Feature } from "./features";
import { hitTest, insideBox } from "./hit";
import { slotsOf } from "./slots";
import { operatorNamed } from "./testing/schema";

function recipeOf(op: string, params: { [name: string]: Json }, variables?: { [name: string]: Json }): Recipe {
  return { seamount: 1, steps: [{ id: "s", op, params }], ...(variables ? { variables } : {}) };
}
const read = (recipe: Recipe): Feature[] => featuresOf(recipe, "s", slotsOf(operatorNamed(recipe.steps[0]!.op)));
const after = (recipe: Recipe, edits: Edit[]) => applyEdits(recipe, edits).steps[0]!.params!;

test("every way of writing geometry is read", () => {
  const island = recipeOf("island.build", {
    areas: [[[0, 0], [10, 0], [0, 10]], { outer: [[0, 0], [9, 0], [0, 9]], holes: [[[1, 1], [2, 1], [1, 2]]] }],
    summits: [{ place: [1, 2], height_m: 800 }], centre: [5, 5],
  });
  assert.deepEqual(read(island).map((f) => f.key), [
    "/steps/s/params/areas/0", "/steps/s/params/areas/1/outer", "/steps/s/params/areas/1/holes/0",
    "/steps/s/params/centre", "/steps/s/params/summits/0/place",
  ]);
  const grow = recipeOf(
    "contour.grow",
    {
      outlines: [[[0, 0], [1, 0], [0, 1]], { name: "a", ring: [[0, 0], [1, 0], [0, 1]] }],
      rivers: [[[0, 0], [1, 1]], { points: [[0, 0], [1, 1]] }],
    },
  );
  assert.deepEqual(
    read(grow).map((f) => f.key.replace("/steps/s/params/", "")),
    ["outlines/0", "outlines/1/ring", "rivers/0", "rivers/1/points"],
  );
  const scene = recipeOf(
    "ecosystem.grow",
    { edits: [{ tool: "move", object: { near: [1, 2] }, by: [3, 4] }, { tool: "add", points: [[0, 0]] }] },
  );
  const moved = read(scene).find((f) => f.geometry === "vector")!;
  assert.deepEqual(moved.points, [[1, 2], [4, 6]]);
});

test("what is no geometry is left alone", () => {
  assert.deepEqual(read(recipeOf("learned.sketch", { ridges: "$nothing", rivers: 3, heights: [] })), []);
  assert.deepEqual(read(recipeOf("island.wind", { strokes: [{ points: [[0]] }, { points: "x" }] })), []);
  assert.deepEqual(read(recipeOf("terrain.crop", {})), []);
});

test("a variable is edited where it stands", () => {
  const recipe = recipeOf("learned.sketch", { ridges: "$lines" }, { lines: [{ points: [[0, 0], [10, 10]] }] });
  const feature = read(recipe)[0]!;
  const next = applyEdits(recipe, moveFeature(feature, 5, -5, 1));
  assert.deepEqual(next.variables, { lines: [{ points: [[5, -5], [15, 5]] }] });
  const drawn = create(recipe, "s", feature.slot, feature.part, [[1, 1], [2, 2]], {});
  assert.deepEqual((applyEdits(recipe, drawn.first).variables!["lines"] as Json[]).length, 2);
});

test("moving, inserting and deleting points", () => {
  const recipe = recipeOf(
    "learned.sketch", { ridges: [{ points: [[0, 0], [10, 0], [20, 0]] }], heights: [{ x_m: 1, y_m: 2, height_m: 3 }] },
  );
  const [line, height] = [
    read(recipe).find((f) => f.geometry === "line")!, read(recipe).find((f) => f.geometry === "place")!,
  ];
  assert.deepEqual(
    after(recipe, insertPoint(line, 0, 0.5, [5, 5]))["ridges"], [{ points: [[0, 0], [5, 5], [10, 0], [20, 0]] }],
  );
  assert.deepEqual(after(recipe, removePoints([line], (_, i) => i === 1))["ridges"], [{ points: [[0, 0], [20, 0]] }]);
  assert.deepEqual(after(recipe, removePoints([line], (_, i) => i > 0))["ridges"], []);
  assert.deepEqual(after(recipe, moveFeature(height, 10, 10, 1))["heights"], [{ x_m: 11, y_m: 12, height_m: 3 }]);
  assert.deepEqual(after(recipe, removeFeatures([line, height])), { ridges: [], heights: [] });
});

test("numbers along a line go with its points", () => {
  const recipe = recipeOf("contour.grow", { rivers: [{ points: [[0, 0], [10, 0], [20, 0]], bed_m: [30, 20, 10] }] });
  const river = read(recipe)[0]!;
  assert.deepEqual(after(recipe, insertPoint(river, 1, 0.5, [15, 0]))["rivers"], [
    { points: [[0, 0], [10, 0], [15, 0], [20, 0]], bed_m: [30, 20, 15, 10] },
  ]);
  assert.deepEqual(
    after(recipe, removePoints([river], (_, i) => i === 1))["rivers"], [{ points: [[0, 0], [20, 0]], bed_m: [30, 10] }],
  );
});

test("several of one list are deleted, and holes, and only what was meant", () => {
  const ring = (at: number): Json => [[at, 0], [at + 1, 0], [at, 1]];
  const recipe = recipeOf(
    "island.build", { areas: [ring(0), { outer: ring(10), holes: [ring(11), ring(12)] }, ring(20), ring(30)] },
  );
  const features = read(recipe);
  const keys = ["areas/0", "areas/2", "areas/1/holes/0"].map((key) => `/steps/s/params/${key}`);
  const left = after(recipe, removeFeatures(features.filter((f) => keys.includes(f.key))));
  assert.deepEqual(left["areas"], [{ outer: ring(10), holes: [ring(12)] }, ring(30)]);
});

test("what goes along with a place goes along", () => {
  const recipe = recipeOf(
    "ecosystem.grow", { edits: [{ tool: "bend", object: { near: [1, 2] }, at: [1, 2], by: [3, 4] }] },
  );
  const bend = read(recipe)[0]!;
  assert.deepEqual(
    after(recipe, moveFeature(bend, 10, 0, 1))["edits"],
    [{ tool: "bend", object: { near: [11, 2] }, at: [11, 2], by: [3, 4] }],
  );
  assert.deepEqual(
    after(recipe, setPoints(bend, [[1, 2], [2, 2]]))["edits"],
    [{ tool: "bend", object: { near: [1, 2] }, at: [1, 2], by: [1, 0] }],
  );
});

test("a new thing is put in once and then set", () => {
  const recipe = recipeOf("island.wind", {});
  const slot = slotsOf(operatorNamed("island.wind")).find((s) => s.id === "strokes")!;
  const drawn = create(recipe, "s", slot, slot.parts[0]!, [[0, 0], [1, 1]], { width_m: 9 });
  const once = applyEdits(recipe, drawn.first);
  const twice = applyEdits(once, drawn.again([[0, 0], [2, 2]], { width_m: 8 }));
  assert.deepEqual(twice.steps[0]!.params, { strokes: [{ points: [[0, 0], [2, 2]], width_m: 8 }] });
  const edit = slotsOf(operatorNamed("contour.edit")).find((s) => s.tool === "fill")!;
  assert.deepEqual(
    newItem(edit, edit.parts[0]!, [[0, 0], [1, 0], [0, 1]], { relief: 2 }),
    { tool: "fill", within: [[[0, 0], [1, 0], [0, 1]]], relief: 2 },
  );
});

test("the pointer finds points of what is selected, then lines, then areas", () => {
  const features = read(
    recipeOf(
      "learned.sketch", { ridges: [{ points: [[0, 0], [1000, 0]] }], rivers: [{ points: [[0, 60], [1000, 60]] }] },
    ),
  );
  const [ridge, river] = [features.find((f) => f.slot.id === "ridges")!, features.find((f) => f.slot.id === "rivers")!];
  const at = (x: number, y: number, selected: string[] = []) => hitTest(features, new Set(selected), [x, y], 10);
  assert.equal(at(500, 40)!.feature, river);
  assert.deepEqual({ ...at(20, 10, [ridge.key])! }, { feature: ridge, part: "point", index: 0 });
  assert.equal(at(500, 20, [ridge.key])!.part, "middle");
  assert.equal(at(250, 0, [ridge.key])!.part, "segment");
  assert.equal(at(500, 181), null);
  const areas = read(
    recipeOf("island.build", { areas: [[[0, 0], [9000, 0], [0, 9000]], [[500, 500], [2500, 500], [500, 2500]]] }),
  );
  assert.deepEqual(hitTest(areas, new Set(), [1000, 1000], 10), { feature: areas[1], part: "inside" });
  assert.equal(insideBox(areas, [0, 0], [3000, 3000]).length, 1);
});
