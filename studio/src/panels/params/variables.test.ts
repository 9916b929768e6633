import assert from "node:assert/strict";
import { test } from "node:test";
import type { ParamInfo, Recipe } from "../../api/types";
import { bindNewEdits, fittingVariables, freshVariable, isBindable, usesOf } from "./variables";

const info = (kind: ParamInfo["kind"], choices?: string[]): ParamInfo =>
  ({ name: "peak_m", kind, unit: "m", help: "", default: 0, ...(choices ? { choices } : {}) });
const variables = { top: 900, half: 0.5, calm: true, style: "alps", places: [1, 2] };

test("variables fit where their value would", () => {
  assert.deepEqual(fittingVariables(info("number"), variables), ["top", "half"]);
  assert.deepEqual(fittingVariables(info("integer"), variables), ["top"]);
  assert.deepEqual(fittingVariables(info("switch"), variables), ["calm"]);
  assert.deepEqual(fittingVariables(info("choice", ["alps"]), variables), ["style"]);
  assert.deepEqual(fittingVariables(info("choice", ["other"]), variables), []);
  assert.deepEqual(fittingVariables(info("point"), variables), ["places"]);
  assert.ok(isBindable(info("curve")) && !isBindable(info("tools")));
});

test("a new variable has the parameter's name and value, and the parameter has the variable", () => {
  assert.equal(freshVariable("peak_m", {}), "peak_m");
  assert.equal(freshVariable("peak_m", { peak_m: 1 }), "peak_m_2");
  assert.deepEqual(bindNewEdits("/steps/isle/params/peak_m", "top", 900), [
    { do: "set", pointer: "/variables/top", value: 900 }, { do: "set", pointer: "/steps/isle/params/peak_m", value: "$top" },
  ]);
});

test("places of a variable are counted", () => {
  const recipe: Recipe = { seamount: 1, variables: { top: 900, same: "$top" }, steps: [
    { id: "isle", op: "island.build", params: { peak_m: "$top", walk: { heights: ["$top", "$topmost"] } } },
  ] };
  assert.equal(usesOf(recipe, "top"), 3);
  assert.equal(usesOf(recipe, "none"), 0);
});
