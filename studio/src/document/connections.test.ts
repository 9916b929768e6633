import assert from "node:assert/strict";
import { test } from "node:test";
import type { Recipe, Schema, Step } from "../api/types";
import { connectionsOf } from "./connections";
import schemaFile from "./fake_schema.json";
import { parameterValue } from "./parameters";

const schema = schemaFile as unknown as Schema;

function read(steps: Step[]): Record<string, string | null> {
  const recipe: Recipe = { seamount: 1, steps };
  const connections = connectionsOf(recipe, schema, steps[steps.length - 1]!);
  return Object.fromEntries(connections.map(({ input, from }) => (
    [input.name, from === null ? null : "file" in from ? `file ${from.file}` : `${from.step}.${from.port}`]
  )));
}

const isle: Step = { id: "isle", op: "island.build" };

test("a step alone gives what has the same name; left out it is the step before", () => {
  const expected = { terrain: "isle.terrain", labels: "isle.labels", coordinate: "isle.coordinate" };
  assert.deepEqual(pick(read([isle, { id: "w", op: "island.wind", in: "isle" }]), Object.keys(expected)), expected);
  assert.deepEqual(pick(read([isle, { id: "w", op: "island.wind" }]), Object.keys(expected)), expected);
});

test("an output goes to the input that it is meant for", () => {
  const found = read([isle, { id: "s", op: "terrain.smooth", in: "isle.terrain" }]);
  assert.equal(found["terrain"], "isle.terrain");
  assert.equal(found["mask"], null);
});

test("inputs one by one, from steps and files", () => {
  const found = read([isle, { id: "s", op: "terrain.smooth", in: { terrain: "isle", mask: { file: "m.png" } } }]);
  assert.deepEqual(found, { ...found, terrain: "isle.terrain", mask: "file m.png" });
});

test("operators that need nothing begin anew; rows of inputs", () => {
  assert.ok(Object.values(read([isle, { id: "i", op: "island.build" }])).every((from) => from === null));
  const two: Step = { id: "two", op: "island.build" };
  const rows = read([isle, two, { id: "a", op: "island.archipelago", in: ["isle", "two"] }]);
  assert.equal(rows["terrain"], "isle.terrain");
  assert.equal(rows["terrain_2"], "two.terrain");
});

test("an operator that needs one of its inputs takes the first that the step before has", () => {
  const port = (name: string, kind: string) => ({ name, kind, help: "", required: false });
  const op = (name: string, input: ReturnType<typeof port>[], out: ReturnType<typeof port>[]) =>
    ({ name, summary: "", source: "", stochastic: false, params: [], in: input, out, needs_one: input.length > 0 });
  const terrain = port("terrain", "terrain"), tin = port("tin", "tin");
  const own: Schema = { ...schema, operators: [op("make", [], [terrain, tin]), op("extract", [tin, terrain], [port("contours", "contours")])] };
  const step: Step = { id: "lines", op: "extract" };
  const recipe: Recipe = { seamount: 1, steps: [{ id: "high", op: "make" }, step] };
  const found = connectionsOf(recipe, own, step).map(({ from }) => from);
  assert.deepEqual(found, [{ step: "high", port: "tin" }, null]);
});

test("a parameter's value: stated, by a variable, by a preset, by default", () => {
  const step: Step = { id: "isle", op: "island.build", params: { preset: "old", peak_m: "$top", massif: 0.25 } };
  const recipe: Recipe = { seamount: 1, variables: { top: 1234 }, steps: [step] };
  assert.equal(parameterValue(recipe, schema, step, "peak_m"), 1234);
  assert.equal(parameterValue(recipe, schema, step, "massif"), 0.25);
  assert.equal(parameterValue(recipe, schema, step, "relief"), 1.4);
  assert.equal(parameterValue(recipe, schema, step, "widths/lagoon_m"), 1300);
  assert.deepEqual(parameterValue(recipe, schema, step, "centre"), [0, 0]);
  assert.equal(parameterValue(recipe, schema, step, "nothing"), undefined);
});

function pick(all: Record<string, string | null>, names: string[]): Record<string, string | null> {
  return Object.fromEntries(names.map((name) => [name, all[name] ?? null]));
}
