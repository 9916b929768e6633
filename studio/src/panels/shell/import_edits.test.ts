import assert from "node:assert/strict";
import { test } from "node:test";
import type { Recipe, Schema } from "../../api/types";
import { applyEdits } from "../../document/apply";
import schemaFile from "../../document/fake_schema.json";
import { importPlan } from "./import_edits";

const schema = schemaFile as unknown as Schema;
const recipe: Recipe = {
  seamount: 1,
  steps: [{ id: "isle", op: "island.build" }, { id: "soft", op: "terrain.smooth", in: { terrain: "isle.terrain" } }],
};

test("elevation is a step at the top, and nothing below changes", () => {
  const plan = importPlan(schema, recipe, "soft", "files/0123456789abcdef0123-alps.tif", "terrain")!;
  const next = applyEdits(recipe, plan.edits);
  assert.deepEqual(
    next.steps[0], { id: "alps", op: "terrain.import", params: { file: "files/0123456789abcdef0123-alps.tif" } },
  );
  assert.deepEqual(next.steps.slice(1), recipe.steps);
  assert.equal(plan.select, "alps");
});

test("what fits an open input of the selected step goes there", () => {
  const plan = importPlan(schema, recipe, "soft", "mask.png", "field")!;
  assert.deepEqual(
    applyEdits(recipe, plan.edits).steps[1]!.in, { terrain: "isle.terrain", mask: { file: "mask.png" } },
  );
  assert.equal(importPlan(schema, recipe, null, "mask.png", "report"), null);
});

test("a coast begins an island; painted regions too", () => {
  const plan = importPlan(schema, { seamount: 1, steps: [] }, null, "coast.geojson", "drawing")!;
  assert.deepEqual(applyEdits({ seamount: 1, steps: [] }, plan.edits).steps, [
    { id: "isle", op: "island.build", params: { coast: "coast.geojson" } },
  ]);
  const painted = importPlan(schema, { seamount: 1, steps: [] }, null, "painted.png", "labels")!;
  assert.deepEqual(
    (painted.edits[0] as unknown as { value: { in: unknown } }).value.in, { labels: { file: "painted.png" } },
  );
});
