import assert from "node:assert/strict";
import { test } from "node:test";
import type { PortInfo, Recipe, Schema } from "../api/types";
import { shownOf } from "./shown";

const port = (name: string, kind = name, required = true): PortInfo => ({ name, kind, help: "", required });
const operator = (name: string, input: PortInfo[], out: PortInfo[]) =>
  ({ name, summary: "", source: "", stochastic: false, in: input, out, params: [] });
const schema: Schema = {
  version: "", formats: [], kinds: [], domain: [],
  operators: [
    operator("floor", [], [port("terrain")]), operator("grow", [port("terrain")], [port("objects"), port("terrain")]),
    operator("look", [port("terrain"), port("objects")], [port("things")]),
    operator("draw", [port("terrain")], [port("image")]),
    operator("network", [], [port("tin")]), operator("heights", [port("tin")], [port("tin")]),
    operator("land", [port("tin")], [port("terrain")]),
  ],
};
const scene: Recipe = { seamount: 1, steps: [
  { id: "floor", op: "floor" }, { id: "life", op: "grow", in: { terrain: "floor.terrain" } },
  { id: "things", op: "look", in: { terrain: "floor.terrain", objects: "life.objects" } },
  { id: "view", op: "draw", in: { terrain: "life.terrain" } },
] };

test("with the ground of a scene comes what lives on it, and what that looks like", () => {
  const life = { terrain: "life.terrain", objects: "life.objects", things: "things.things" };
  assert.deepEqual(shownOf(scene, schema, null, null), { ...life, overlay: null });
  assert.deepEqual(shownOf(scene, schema, "life", null), { ...life, overlay: null });
  assert.deepEqual(shownOf(scene, schema, "floor", null), { terrain: "floor.terrain", overlay: null, objects: null, things: null });
});

test("things stand on the ground of their scene, not on the one before it", () => {
  const shown = shownOf(scene, schema, "things", null);
  assert.deepEqual([shown.terrain, shown.overlay], ["life.terrain", "things.things"]);
});

test("a network is seen with the ground that it becomes", () => {
  const recipe: Recipe = { seamount: 1, steps: [
    { id: "grown", op: "network" }, { id: "high", op: "heights", in: { tin: "grown.tin" } },
    { id: "land", op: "land", in: { tin: "high.tin" } },
  ] };
  const { terrain, overlay } = shownOf(recipe, schema, "grown", null);
  assert.deepEqual([terrain, overlay], ["land.terrain", "grown.tin"]);
});
