import assert from "node:assert/strict";
import { test } from "node:test";
import type { Change, Edit, Json, Recipe } from "../api/types";
import { applyChanges, applyEdits, takeBackChanges } from "./apply";
import { freeze, NoSuchPlace, valueAt } from "./pointer";

const recipe = freeze({
  seamount: 1,
  steps: [
    { id: "isle", op: "island.build", params: { peak_m: 900, summits: [{ at: [0, 0] }, { at: [1, 1] }] } },
    { id: "reef", op: "island.coral", in: "isle" },
    { id: "flat", op: "terrain.smooth", in: { terrain: "reef.terrain" } },
  ],
  outputs: [{ path: "a.tif", from: "flat.terrain" }, { path: "b.png", from: "reef" }],
} as unknown as Json) as unknown as Recipe;

const after = (...edits: Edit[]): Json => applyEdits(recipe, edits) as unknown as Json;

test("a parameter is set by the step's id; the document before stays as it was, and what is alike is shared", () => {
  const next = after({ do: "set", pointer: "/steps/isle/params/peak_m", value: 1200 });
  assert.equal(valueAt(next, "/steps/0/params/peak_m"), 1200);
  assert.equal(recipe.steps[0]!.params!["peak_m"], 900);
  assert.equal((next as unknown as Recipe).steps[1], recipe.steps[1]);
});

test("objects on the way are made; without a value the member is taken out, and taking out nothing is nothing", () => {
  assert.deepEqual(valueAt(after({ do: "set", pointer: "/steps/reef/params/section/crest_m", value: 2 }),
    "/steps/1/params"),
    { section: { crest_m: 2 } });
  assert.equal(
    valueAt(after({ do: "set", pointer: "/steps/isle/params/peak_m" }), "/steps/0/params/peak_m"), undefined,
  );
  assert.deepEqual(after({ do: "set", pointer: "/steps/isle/params/relief" }), recipe);
});

test("items are put in, taken out and moved", () => {
  const list = "/steps/isle/params/summits";
  assert.deepEqual(
    valueAt(after({ do: "insert", list, index: 1, value: { at: [5, 5] } }), `${list}/1`), { at: [5, 5] },
  );
  assert.deepEqual(
    valueAt(after({ do: "insert", list: "/steps/reef/params/strokes", value: 1 }), "/steps/1/params/strokes"), [1],
  );
  assert.deepEqual(valueAt(after({ do: "remove", item: `${list}/0` }), list), [{ at: [1, 1] }]);
  const moved = after({ do: "move", item: "/steps/flat", index: 0 }) as unknown as Recipe;
  assert.deepEqual(moved.steps.map((step) => step.id), ["flat", "isle", "reef"]);
});

test("a renamed step is renamed wherever it is named", () => {
  const next = after({ do: "rename", id: "reef", new_id: "atoll" }) as unknown as Recipe;
  assert.deepEqual(next.steps[2]!.in, { terrain: "atoll.terrain" });
  assert.deepEqual(next.outputs!.map((output) => output.from), ["flat.terrain", "atoll"]);
});

test("what read from a step that is gone reads what it read", () => {
  const next = after({ do: "remove_step", id: "reef" }) as unknown as Recipe;
  assert.deepEqual(next.steps.map((step) => step.id), ["isle", "flat"]);
  assert.deepEqual(next.steps[1]!.in, { terrain: "isle.terrain" });
  assert.equal((after({ do: "remove_step", id: "isle" }) as unknown as Recipe).steps[0]!.in, undefined);
});

test("places that are not there are refused", () => {
  assert.throws(() => after({ do: "set", pointer: "/steps/nobody/params/a", value: 1 }), NoSuchPlace);
  assert.throws(() => after({ do: "set", pointer: "/steps/isle/params/peak_m/low", value: 1 }), NoSuchPlace);
  assert.throws(() => after({ do: "insert", list: "/seamount", value: 1 }), NoSuchPlace);
});

test("changes are made and taken back exactly, the order of members too", () => {
  const changes: Change[] = [
    { pointer: "/steps/0/params/irregularity", index: 0, after: 0.2 },
    { pointer: "/steps/0/params/peak_m", index: 1, before: 900, after: 950 },
    { pointer: "/steps/0/params/summits/0", index: 0, before: { at: [0, 0] } },
    { pointer: "/outputs/1", index: 1, after: { path: "c.png" } },
    { pointer: "/steps/1/in", index: 2, before: "isle" },
  ];
  const next = applyChanges(recipe, changes);
  assert.equal(JSON.stringify(next.steps[0]!.params), '{"irregularity":0.2,"peak_m":950,"summits":[{"at":[1,1]}]}');
  assert.deepEqual(next.outputs!.map((output) => output.path), ["a.tif", "c.png", "b.png"]);
  assert.equal(JSON.stringify(takeBackChanges(next, changes)), JSON.stringify(recipe));
});
