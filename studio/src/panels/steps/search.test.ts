import assert from "node:assert/strict";
import { test } from "node:test";
import type { OperatorInfo } from "../../api/types";
import { findOperators, fuzzy, takesAndMakes } from "./search";

const op = (name: string, summary: string): OperatorInfo => ({
  name, summary, source: "", stochastic: false, params: [],
  in: [{ name: "terrain", kind: "terrain", help: "", required: true },
    { name: "mask", kind: "field", help: "", required: false }],
  out: [{ name: "terrain", kind: "terrain", help: "", required: false }],
});
const all = [op("island.build", "An island from its outlines"),
  op("island.coral", "Sinks an island and grows its reef"),
  op("reef.grow", "Grows barrier reefs"), op("erosion.run", "Years of rivers, slides, creep and waves")];
const names = (query: string, rank = (_: OperatorInfo) => 0) => findOperators(query, all, rank).map((found) =>
  found.name);

test("by name, family and summary", () => {
  assert.equal(names("coral")[0], "island.coral");
  assert.equal(names("ero")[0], "erosion.run");
  assert.equal(names("reef")[0], "reef.grow");
  assert.deepEqual(names("creep"), ["erosion.run"]);
  assert.equal(names("ibu")[0], "island.build");
  assert.deepEqual(names("island grows"), ["island.coral"]);
  assert.deepEqual(names("hydraulic"), ["erosion.run"]);
  assert.deepEqual(names("zzz"), []);
});

test("what fits comes first", () => {
  assert.equal(names("", (found) => (found.name === "erosion.run" ? 0 : 1))[0], "erosion.run");
  assert.equal(names("coral", (found) => (found.name === "island.coral" ? 2 : 0))[0], "island.coral");
});

test("letters in a row and ports", () => {
  assert.ok(fuzzy("coral", "island.coral") > fuzzy("oral", "island.coral"));
  assert.equal(fuzzy("xyz", "island.coral"), 0);
  assert.deepEqual(takesAndMakes(all[0]!), { takes: "terrain", makes: "terrain" });
});
