import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import type { Edit, Json, ParamInfo, Recipe } from "../../api/types";
import type { Studio } from "../../document/studio";
import { drawnText } from "./measures";
import { fieldOf, innerScope, isChanged, matchesSearch, presetMembers, resetField, scopeOf, setField } from "./scope";
import { bytesText, changeLabel, numberText, secondsText, titleOf } from "./words";

const number = (name: string, value: Json, unit = ""): ParamInfo =>
  ({ name, kind: "number", unit, help: `${name} of it`, default: value });
const slopes: ParamInfo = { ...number("slopes", {}), kind: "group",
  tools: [{ name: "", about: "", params: [number("creep_m2_yr", 0.005, "m2/yr")] }] };
const preset: ParamInfo = { ...number("preset", null), kind: "preset",
  presets: [{ name: "old", about: "", values: { years: 700000, "slopes.creep_m2_yr": 0.04 } }] };
const params = [preset, number("years", 100000, "yr"), slopes, number("peak_m", null, "m")];

function studioWith(variables: { [name: string]: Json } = {}): { studio: Studio;
  sent: { edits: Edit[]; label: string }[] } {
  const sent: { edits: Edit[]; label: string }[] = [];
  const recipe: Recipe = { seamount: 1, steps: [], variables };
  const studio = { document: signal({ recipe }), edit: async (edits: Edit[], label: string) =>
    (sent.push({ edits, label }), true) };
  return { studio: studio as unknown as Studio, sent };
}

test("stated, preset, default, derived, variable", () => {
  const { studio } = studioWith({ age: 5 });
  const standing = (stated: Json, name: string) => {
    const scope = scopeOf(studio, "worn", "worn", "/steps/worn/params", params, stated);
    const field = fieldOf(scope, params.find((info) => info.name === name)!);
    return [field.standing, field.value];
  };
  assert.deepEqual(standing({}, "years"), ["default", 100000]);
  assert.deepEqual(standing({ years: 3 }, "years"), ["stated", 3]);
  assert.deepEqual(standing({ preset: "old" }, "years"), ["preset", 700000]);
  assert.deepEqual(standing({ years: "$age" }, "years"), ["variable", 5]);
  assert.deepEqual(standing({}, "peak_m"), ["derived", null]);
});

test("presets reach into groups", () => {
  const { studio } = studioWith();
  assert.deepEqual(presetMembers(params, { preset: "old" }), { years: 700000, slopes: { creep_m2_yr: 0.04 } });
  const scope = scopeOf(studio, "worn", "worn", "/steps/worn/params", params, { preset: "old" });
  const inner = innerScope(scope, "slopes", slopes.tools![0]!.params, true);
  assert.deepEqual(fieldOf(inner, inner.params[0]!).value, 0.04);
  assert.equal(inner.pointer, "/steps/worn/params/slopes");
});

test("edits", () => {
  const { studio, sent } = studioWith();
  const scope = scopeOf(studio, "worn", "worn", "/steps/worn/params", params, { slopes: { creep_m2_yr: 1 } });
  const inner = innerScope(scope, "slopes", slopes.tools![0]!.params, true);
  const field = fieldOf(inner, inner.params[0]!);
  setField(field, 2);
  assert.deepEqual(sent[0], { edits: [{ do: "set", pointer: "/steps/worn/params/slopes/creep_m2_yr", value: 2 }],
    label: "worn: creep 1 m²/yr → 2 m²/yr" });
  resetField(field);
  assert.deepEqual(sent[1]?.edits, [{ do: "set", pointer: "/steps/worn/params/slopes" }]);
  resetField(fieldOf(scope, params[1]!));
  assert.equal(sent.length, 2);
  assert.equal(isChanged(fieldOf(scope, slopes)), true);
});

test("words", () => {
  assert.equal(titleOf("valley_spacing_m"), "Valley spacing");
  assert.equal(titleOf("creep_m2_yr"), "Creep");
  assert.equal(numberText(0.30000000004), "0.3");
  assert.equal(numberText(3e-5), "3e-5");
  assert.equal(numberText(12345.678), "12346");
  assert.equal(changeLabel("reef", number("subsidence", 0), 0.2, 0.4), "reef: subsidence 0.2 → 0.4");
  assert.equal(secondsText(75), "1 min 15 s");
  assert.equal(bytesText(5 * 1024 * 1024), "5.0 MiB");
  assert.ok(matchesSearch(slopes, "creep"));
  assert.ok(!matchesSearch(slopes, "glacier"));
});

test("what is drawn is counted", () => {
  assert.equal(drawnText("strokes", [{ points: [[0, 0], [3000, 4000]], width_m: 100 }]), "1 stroke, 5 km");
  assert.equal(drawnText("polygons",
    [[[0, 0], [100, 0], [100, 100], [0, 100]], { outer: [[0, 0], [10, 0], [10, 10], [0, 10]] }]),
    "2 areas, 10100 m²");
  assert.equal(drawnText("points", []), "none");
  assert.equal(drawnText("outlines", [4000, 5200]), "1 outline, up to 5200 m");
  assert.equal(drawnText("regions", [{ name: "a", ring: [[0, 0], [1000, 0], [1000, 1000], [0, 1000]] }]),
    "1 region, 1 km²");
});
