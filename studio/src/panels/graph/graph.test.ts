import assert from "node:assert/strict";
import { test } from "node:test";
import type { OperatorInfo, PortInfo, Recipe } from "../../api/types";
import { NODE_WIDTH, graphOf, neighbour, portPoint, wireDistance } from "./geometry";
import { bestPort, betweenEdits, connectEdits, disconnectEdits, fittingPorts } from "./wiring";

const port = (text: string): PortInfo => {
  const [name = "", kind = ""] = text.replace("!", "").split(":");
  return { name, kind, help: "", required: text.endsWith("!") };
};
const op = (name: string, inputs: string, outputs: string): OperatorInfo => ({
  name, summary: "", source: "", stochastic: false, params: [],
  in: inputs.split(" ").filter(Boolean).map(port), out: outputs.split(" ").filter(Boolean).map(port),
});
const known = [op("a.make", "", "terrain:terrain labels:labels"), op("a.smooth", "terrain:terrain! mask:field",
  "terrain:terrain"),
  op("a.mask", "terrain:terrain!", "mask:field"),
    op("a.many", "terrain:terrain! a:field b:field c:field d:field e:field", "terrain:terrain")];
const operators = (name: string) => known.find((candidate) => candidate.name === name);
const recipe: Recipe = { seamount: 1, steps: [{ id: "m", op: "a.make" }, { id: "s", op: "a.smooth" },
  { id: "k", op: "a.mask", in: "m" },
  { id: "t", op: "a.smooth", in: { terrain: "s", mask: "k" } },
    { id: "w", op: "a.many", in: { terrain: "t.terrain", c: "k.mask" } }] };
const model = graphOf(recipe, operators);

test("nodes, wires and ports", () => {
  assert.equal(model.wires.length, 6);
  assert.deepEqual(model.byId.get("w")!.ins.map((shown) => shown.name), ["terrain", "c"]);
  assert.equal(model.byId.get("w")!.hiddenIns, 4);
  const [x] = portPoint(model.byId.get("m")!, "out", "terrain");
  assert.equal(x, model.byId.get("m")!.x + NODE_WIDTH);
});

test("only what fits, and no circles", () => {
  const wire = { step: "t", side: "out", port: port("terrain:terrain") } as const;
  assert.deepEqual([...fittingPorts(wire, model).keys()], ["w/in/terrain"]);
  const mask = { step: "k", side: "out", port: port("mask:field") } as const;
  assert.equal(fittingPorts(mask, model).size, 7);
  assert.equal(bestPort(mask, model.byId.get("w")!, model)?.name, "a");
  const back = { step: "t", side: "in", port: port("terrain:terrain!") } as const;
  assert.deepEqual([...fittingPorts(back, model).values()].map((target) => target.step), ["m", "s"]);
});

test("connecting, moving an end, coming in between", () => {
  const wire = { step: "k", side: "out", port: port("mask:field"), off: { to: "t", input: "mask" } } as const;
  assert.deepEqual(connectEdits(wire, { step: "s", port: port("mask:field") }, recipe, operators).edits, [
    { do: "set", pointer: "/steps/t/in", value: "s" },
      { do: "set", pointer: "/steps/s/in", value: { terrain: "m", mask: "k" } }]);
  const between = model.wires.find((candidate) => candidate.from === "m" && candidate.to === "k")!;
  assert.deepEqual(betweenEdits(model.byId.get("s")!, between, model, recipe, operators)?.edits, [
    { do: "set", pointer: "/steps/s/in" }, { do: "set", pointer: "/steps/k/in" }]);
  assert.equal(betweenEdits(model.byId.get("t")!, between, model, recipe, operators), null);
  assert.deepEqual(disconnectEdits("s", "terrain", recipe, operators).edits,
    [{ do: "set", pointer: "/steps/s/in", value: {} }]);
});

test("arrows and distances", () => {
  assert.equal(neighbour(model, "t", "ArrowRight"), "w");
  assert.ok(["s", "k"].includes(neighbour(model, "t", "ArrowLeft")!));
  assert.equal(neighbour(model, "w", "ArrowRight"), null);
  assert.ok(wireDistance({ from: [0, 0], to: [100, 0], crossings: [], aside: 0 }, [50, 3]) < 4);
});
