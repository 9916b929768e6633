import assert from "node:assert/strict";
import { test } from "node:test";
import type { Recipe } from "../api/types";
import { applyEdits } from "../document/apply";
import { connectionsOf, stepOf } from "../document/connections";
import { addStep, freshId } from "./adding";
import { offersFor } from "./offers";
import { slotAt } from "./bridge";
import { slotsOf } from "./slots";
import { operatorNamed, schema } from "./testing/schema";

const recipe: Recipe = {
  seamount: 1,
  steps: [
    { id: "isle", op: "island.build" },
    { id: "wind", op: "island.wind", in: "isle" },
    { id: "reef", op: "island.coral" },
    { id: "sketch", op: "learned.sketch", in: { terrain: "reef.terrain" } },
    { id: "worn", op: "erosion.run", in: { terrain: "reef.terrain" } },
    { id: "high", op: "terrain.mask", in: { terrain: "reef.terrain" } },
  ],
  outputs: [{ path: "a.png", from: "wind.terrain", labels: "wind.labels" }, { path: "b.tif", from: "wind" }],
};

const titles = (step: string | null, where: "rail" | "more") =>
  offersFor(recipe, schema, step)[where].map((offer) => offer.look.title);

test("what draws into the selected step is in the rail", () => {
  assert.deepEqual(
    titles("wind", "rail"),
    ["Select and move", "Eraser", "Wind", "Centre", "Measure a distance", "Profile along a line"],
  );
  assert.ok(titles("sketch", "rail").includes("Ridge") && titles("sketch", "rail").includes("River"));
  assert.deepEqual(titles(null, "rail").slice(1, 4), ["Draw a coast", "Sketch ridges", "Draw regions of contours"]);
  assert.deepEqual(titles(null, "more"), []);
  const behind = offersFor(recipe, schema, null, "reef").more.map((offer) => offer.help);
  assert.ok(behind.includes("adds terrain.sculpt behind reef"), String(behind));
});

test("the rest says which step it would add, or which it draws into", () => {
  const more = offersFor(recipe, schema, "wind").more;
  assert.deepEqual(more.map((offer) => offer.help).slice(0, 3), [
    "adds terrain.sculpt behind wind", "adds classify.paint behind wind", "adds reef.grow behind wind",
  ]);
  const worn = titles("worn", "more");
  for (
    const title of ["Paint the uplift", "Paint the hardness", "Paint the mask"]
  ) assert.ok(worn.includes(title), title);
  assert.ok(titles("sketch", "more").includes("Paint the erase"));
  assert.ok(titles("high", "more").includes("Paint over it"));
  const painted = applyEdits(
    recipe, addStep(recipe, schema, { at: "wind", op: "terrain.sculpt", where: "behind" }, "sculpt", {}),
  );
  const again = offersFor(painted, schema, "wind").more.find((offer) => offer.adds!.op === "terrain.sculpt")!;
  assert.equal(again.adds!.existing, "sculpt");
  assert.equal(again.help, "in the step sculpt");
});

test("keys of one step's tools are its own", () => {
  for (const { name } of schema.operators) {
    const one: Recipe = { seamount: 1, steps: [{ id: "s", op: name }] };
    const keys = offersFor(one, schema, "s").rail.map((offer) => offer.look.keys).filter((key) => key !== "");
    assert.equal(new Set(keys).size, keys.length, `${name}: ${keys.join(" ")}`);
  }
});

const read = (document: Recipe, id: string) =>
  Object.fromEntries(
    connectionsOf(document, schema, stepOf(document, id)!).filter((c) => c.from).map(
      (c) => [c.input.name, Object.values(c.from!).join(".")],
    ),
  );

test("a step behind is read by all that read the selected one, where it passes on what they read", () => {
  const next = applyEdits(
    recipe, addStep(recipe, schema, { at: "wind", op: "terrain.sculpt", where: "behind" }, "sculpt", { strokes: [] }),
  );
  assert.deepEqual(next.steps.map((step) => step.id), ["isle", "wind", "sculpt", "reef", "sketch", "worn", "high"]);
  assert.deepEqual(read(next, "sculpt"), { terrain: "wind.terrain" });
  assert.deepEqual(
    read(next, "reef"), { terrain: "sculpt.terrain", labels: "wind.labels", coordinate: "wind.coordinate" },
  );
  assert.deepEqual(
    next.outputs, [{ path: "a.png", from: "sculpt.terrain", labels: "wind.labels" }, { path: "b.tif", from: "sculpt" }],
  );
});

test("labels that are painted behind keep the terrain as it was", () => {
  const next = applyEdits(
    recipe, addStep(recipe, schema, { at: "wind", op: "classify.paint", where: "behind" }, "paint", {}),
  );
  assert.deepEqual(
    read(next, "reef"), { terrain: "wind.terrain", labels: "paint.labels", coordinate: "wind.coordinate" },
  );
  assert.deepEqual(next.outputs![0], { path: "a.png", from: "wind.terrain", labels: "paint.labels" });
});

test("a step before feeds one input, over what was connected, on the same ground", () => {
  const next = applyEdits(
    recipe, addStep(recipe, schema, { at: "worn", op: "terrain.paint", where: "before", input: "uplift" }, "paint", {}),
  );
  assert.deepEqual(next.steps.map((step) => step.id), ["isle", "wind", "reef", "sketch", "paint", "worn", "high"]);
  assert.deepEqual(read(next, "worn"), { terrain: "reef.terrain", uplift: "paint.values" });
  assert.deepEqual(read(next, "paint"), { terrain: "reef.terrain" });
  const over = applyEdits(
    next, addStep(next, schema, { at: "worn", op: "terrain.paint", where: "before", input: "uplift" }, "more", {}),
  );
  assert.deepEqual(read(over, "more"), { values: "paint.values", terrain: "reef.terrain" });
});

test("a step alone changes nothing else", () => {
  const short: Recipe = { seamount: 1, steps: [{ id: "isle", op: "island.build" }], outputs: [{ path: "a.tif" }] };
  const next = applyEdits(
    short, addStep(short, schema, { op: "learned.sketch", where: "alone" }, freshId(short, "learned.sketch"), {}),
  );
  assert.deepEqual(next.steps.map((step) => step.id), ["isle", "sketch"]);
  assert.deepEqual(next.outputs, [{ path: "a.tif", from: "isle" }]);
});

test("ids are free", () => {
  assert.equal(freshId(recipe, "learned.sketch"), "sketch_2");
  assert.equal(freshId(recipe, "terrain.sculpt"), "sculpt");
});

test("a place in the panel of parameters has its slot", () => {
  const edit = slotsOf(operatorNamed("contour.edit"));
  assert.equal(slotAt(edit, "/steps/s/params/edits/2/stroke", "slope")!.id, "edits:slope");
  assert.equal(slotAt(slotsOf(operatorNamed("reef.grow")), "/steps/s/params/starts/line")!.id, "starts/line");
  assert.equal(slotAt(slotsOf(operatorNamed("terrain.noise")), "/steps/s/params/x"), undefined);
});
