import assert from "node:assert/strict";
import { test } from "node:test";
import type { Recipe, Schema } from "../../api/types";
import recipeFile from "../../document/fake_recipe.json";
import schemaFile from "../../document/fake_schema.json";
import { outputOf, presetsOf, sourcesFor, withExtension } from "./export_presets";

const schema = schemaFile as unknown as Schema;
const recipe = recipeFile as unknown as Recipe;

test("every format of the schema can be chosen, those for engines first", () => {
  const presets = presetsOf(schema);
  assert.equal(presets[0]!.id, "unreal");
  for (const format of schema.formats) assert.ok(
    presets.some((preset) => preset.format.name === format.name), format.name,
  );
});

test("an output states what differs from the default", () => {
  const unreal = presetsOf(schema).find((preset) => preset.id === "unreal")!;
  assert.deepEqual(outputOf(unreal, "u.r16", "reef.terrain", { size: 1009, fit: "by_engine", low_m: "" }),
    { from: "reef.terrain", path: "u.r16", as: "unreal", size: 1009 });
});

test("sources are what the format takes, the last step's first", () => {
  const labels = schema.formats.find((format) => format.name === "labels")!;
  assert.deepEqual(sourcesFor(recipe, schema, labels), ["reef.labels", "wind.labels", "isle.labels"]);
});

test("a name gets the extension that is missing", () => {
  const mesh = schema.formats.find((format) => format.name === "mesh")!;
  assert.equal(withExtension(mesh, "a"), "a.glb");
  assert.equal(withExtension(mesh, "a.OBJ"), "a.OBJ");
});
