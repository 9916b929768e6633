import assert from "node:assert/strict";
import { test } from "node:test";
import type { OperatorInfo, PortInfo, Recipe } from "../../api/types";
import { allConnections, connectionsOf, downstream, offersFor } from "./connections";
import { duplicateStep, fitAfter, freeId, insertIntoWire, insertStep } from "./insert";

const port = (text: string): PortInfo => {
  const [name = "", kind = ""] = text.replace("!", "").split(":");
  return { name, kind, help: "", required: text.endsWith("!") };
};
const op = (name: string, inputs: string, outputs: string): OperatorInfo => ({
  name, summary: "", source: "", stochastic: false, params: [],
  in: inputs.split(" ").filter(Boolean).map(port), out: outputs.split(" ").filter(Boolean).map(port),
});
const known = [
  op("island.build", "outlines:drawing labels:labels", "terrain:terrain labels:labels coordinate:field"),
  op("island.coral", "terrain:terrain! labels:labels!", "terrain:terrain labels:labels"),
  op("terrain.smooth", "terrain:terrain! mask:field", "terrain:terrain"),
  op("terrain.mask", "terrain:terrain!", "mask:field"),
  op("terrain.blend", "terrain:terrain! with:terrain! mask:field", "terrain:terrain"),
  op("render.map", "terrain:terrain! labels:labels", "image:image"),
  op("island.archipelago", "terrain:terrain labels:labels terrain_2:terrain labels_2:labels",
    "terrain:terrain labels:labels"),
];
const operators = (name: string) => known.find((o) => o.name === name);
const get = (name: string) => operators(name)!;
const plain = (map: ReadonlyMap<string, unknown>) => Object.fromEntries(map);

const chain: Recipe = { seamount: 1, steps: [
  { id: "isle", op: "island.build" }, { id: "reef", op: "island.coral" },
  { id: "picture", op: "render.map", in: { terrain: "reef.terrain" } }] };

test("shorthand is followed", () => {
  assert.deepEqual(plain(connectionsOf(chain, 1, operators)),
    { terrain: { step: "isle", port: "terrain" }, labels: { step: "isle", port: "labels" } });
  const recipe: Recipe = { seamount: 1, steps: [...chain.steps,
    { id: "a", op: "render.map", in: "isle" }, { id: "b", op: "terrain.smooth", in: "isle.coordinate" },
    { id: "c", op: "island.archipelago", in: ["isle", "reef"] },
      { id: "d", op: "terrain.smooth", in: { terrain: "reef", mask: { file: "m.png" } } },
    { id: "e", op: "island.build" }] };
  assert.deepEqual(plain(connectionsOf(recipe, 3, operators)),
    { terrain: { step: "isle", port: "terrain" }, labels: { step: "isle", port: "labels" } });
  assert.deepEqual(plain(connectionsOf(recipe, 4, operators)), { mask: { step: "isle", port: "coordinate" } });
  assert.deepEqual(plain(connectionsOf(recipe, 5, operators)), {
    terrain: { step: "isle", port: "terrain" }, labels: { step: "isle", port: "labels" },
    terrain_2: { step: "reef", port: "terrain" }, labels_2: { step: "reef", port: "labels" } });
  assert.deepEqual(plain(connectionsOf(recipe, 6, operators)), { terrain: { step: "reef", port: "terrain" },
    mask: { file: "m.png" } });
  assert.deepEqual(plain(connectionsOf(recipe, 7, operators)), {});
});

test("an operator that needs one input takes one of the step before", () => {
  const extract = { ...op("contour.extract", "tin:tin terrain:terrain", "contours:contours"), needs_one: true };
  const known2 = (name: string) => (name === "contour.extract" ? extract : operators(name));
  const recipe: Recipe = { seamount: 1,
    steps: [{ id: "isle", op: "island.build" }, { id: "lines", op: "contour.extract" }] };
  assert.deepEqual(plain(connectionsOf(recipe, 1, known2)), { terrain: { step: "isle", port: "terrain" } });
});

test("what fits is of the kind and makes no cycle", () => {
  const all = allConnections(chain, operators);
  assert.deepEqual([...downstream("isle", all)], ["isle", "reef", "picture"]);
  assert.deepEqual(offersFor("picture", port("labels:labels"), chain, operators).map((offer) => offer.step),
    ["isle", "reef"]);
  assert.deepEqual(offersFor("isle", port("labels:labels"), chain, operators), []);
});

test("a step in a chain of shorthand needs no connections written", () => {
  const { id, edits } = insertStep(get("terrain.smooth"), "reef", chain, operators);
  assert.equal(id, "smooth");
  assert.deepEqual(edits, [{ do: "insert", list: "/steps", index: 2, value: { id: "smooth", op: "terrain.smooth" } }]);
});

test("what would read something else is written out", () => {
  const { edits } = insertStep(get("terrain.smooth"), "isle", chain, operators);
  assert.deepEqual(edits[0], { do: "set", pointer: "/steps/reef/in", value: "isle" });
  assert.equal(edits.length, 2);
  const ends: Recipe = { ...chain, steps: chain.steps.slice(0, 2), outputs: [{ path: "a.tif" }] };
  assert.deepEqual(insertStep(get("terrain.mask"), "reef", ends, operators).edits[0],
    { do: "set", pointer: "/outputs/0/from", value: "reef" });
});

test("required inputs are looked for upstream", () => {
  const recipe: Recipe = { seamount: 1, steps: [{ id: "isle", op: "island.build" }, { id: "m", op: "terrain.mask" }] };
  const { edits } = insertStep(get("terrain.smooth"), "m", recipe, operators);
  const insert = edits.find((edit) => edit.do === "insert");
  assert.deepEqual(insert?.do === "insert" && insert.value,
    { id: "smooth", op: "terrain.smooth", in: { terrain: "isle", mask: "m" } });
});

test("blend takes the step for both", () => {
  const { edits } = insertStep(get("terrain.blend"), "reef", chain, operators);
  const insert = edits.find((edit) => edit.do === "insert");
  assert.deepEqual(insert?.do === "insert" && insert.value,
    { id: "blend", op: "terrain.blend", in: { terrain: "reef", with: "reef" } });
});

test("into a wire", () => {
  const insertion = insertIntoWire(get("terrain.smooth"), { step: "reef", port: "terrain" }, "picture",
    port("terrain:terrain!"), chain, operators);
  assert.deepEqual(insertion?.edits.at(-1), { do: "set", pointer: "/steps/picture/in" });
  assert.equal(insertIntoWire(get("render.map"), { step: "isle", port: "terrain" }, "reef", port("terrain:terrain!"),
    chain, operators), null);
});

test("a copy reads what the original reads, and nobody reads the copy", () => {
  const { id, edits } = duplicateStep("isle", chain, operators)!;
  assert.equal(id, "isle_2");
  assert.deepEqual(edits, [{ do: "set", pointer: "/steps/reef/in", value: "isle" },
    { do: "insert", list: "/steps", index: 1, value: { id: "isle_2", op: "island.build" } }]);
  const copy = duplicateStep("reef", chain, operators)!.edits.at(-1);
  assert.deepEqual(copy?.do === "insert" && copy.value, { id: "reef_2", op: "island.coral", in: "isle" });
});

test("ids and fit", () => {
  assert.equal(freeId("island.coral", chain), "coral");
  assert.equal(freeId("reef", chain), "reef_2");
  assert.equal(freeId("erosion.run", chain), "erosion");
  assert.equal(fitAfter(get("island.coral"), get("island.build")), "follows");
  assert.equal(fitAfter(get("island.coral"), get("terrain.smooth")), "other");
  assert.equal(fitAfter(get("island.build"), get("terrain.smooth")), "begins");
});
