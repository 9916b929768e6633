import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import type { Json, Recipe } from "../api/types";
import { openStudio, type OpenedStudio } from "../document/open_studio";
import type { GroundPointer, OverlayShape, PenTarget } from "../viewport/types";
import { activeTool, chosen, reach, selectedPoints, selection } from "./active";
import { toolActions, toolKey } from "./actions";
import type { Sample } from "./fit";
import { DrawingServer } from "./testing/server";
import { recorded } from "./testing/strokes";
import { toolsOf, type ToolBox } from "./toolbox";

/** A map of numbers: what tools show, and a hand that draws over it. */
class Paper {
  pen: PenTarget | null = null;
  shapes: readonly OverlayShape[] = [];
  setPen(pen: PenTarget | null): void {
    this.pen = pen;
  }
  setOverlayShapes(shapes: readonly OverlayShape[]): void {
    this.shapes = shapes;
  }
  at([x, y]: readonly [number, number], more: Partial<GroundPointer> = {}): GroundPointer {
    return {
      x, y, height: 420.4, pressure: 1, device: "mouse", shift: false, ctrl: false, alt: false, pixel_m: 20, ...more,
    };
  }
  async stroke(
    points: readonly (readonly [number, number])[], more: Partial<GroundPointer> = {}, pressures?: number[],
  ): Promise<void> {
    const samples = points.map((p, i) => this.at(p, { ...more, pressure: pressures?.[i] ?? 1 }));
    this.pen!.down(samples[0]!);
    for (let i = 1; i < samples.length; i += 5) {
      this.pen!.move(samples.slice(i, i + 5));
      if (i % 40 === 1) await frame();
    }
    this.pen!.up(samples[samples.length - 1]!);
    await settled();
  }
  async click(x: number, y: number, more: Partial<GroundPointer> = {}): Promise<void> {
    this.pen!.down(this.at([x, y], more));
    this.pen!.up(this.at([x, y], more));
    await settled();
  }
}

const frame = () => new Promise((done) => setTimeout(done, 20));
let studio: OpenedStudio;
let tools: ToolBox;
let server: DrawingServer;
let paper: Paper;

async function settled(): Promise<void> {
  await frame();
  while (studio.busy.value) await frame();
}

async function open(steps: Recipe["steps"], selected: string | null, more: Partial<Recipe> = {}): Promise<void> {
  server = new DrawingServer({ seamount: 1, domain: { width_m: 24000, height_m: 24000, cell_m: 40 }, steps, ...more });
  studio = await openStudio(server);
  tools = toolsOf(studio);
  paper = new Paper();
  studio.selected.value = selected;
  tools.attach(paper);
}

const params = (id: string) => studio.step(id)!.params as { [name: string]: Json };
const items = (id: string, list: string) => (params(id)[list] ?? []) as { [name: string]: Json }[];
const labels = () => studio.document.value.history.map((entry) => entry.label);
const press = (key: string, more = {}) => toolKey(
  studio, { key, ctrlKey: false, shiftKey: false, altKey: false, metaKey: false, ...more },
);
const pointsOf = (stroke: readonly Sample[]) => stroke.map((s) => [s.x, s.y] as const);

afterEach(() => {
  tools.close();
  studio.close();
  activeTool.value = "edit:select";
  selection.value = selectedPoints.value = new Set();
  chosen.value = {};
  reach.value = null;
});

test("a ridge drawn in one go is one item and one entry of the history", async () => {
  await open([{ id: "land", op: "learned.sketch" }], "land");
  assert.ok(press("r"));
  await paper.stroke(pointsOf(recorded[0]!));
  const points = items("land", "ridges")[0]!["points"] as Json[];
  assert.ok(points.length > 8 && points.length <= 60);
  assert.deepEqual(labels(), ["land: ridge drawn"]);
  await paper.stroke(pointsOf(recorded[2]!));
  assert.equal(items("land", "ridges").length, 2);
  assert.deepEqual(labels(), ["land: ridge drawn", "land: ridge drawn"]);
  await studio.undo();
  assert.equal(items("land", "ridges").length, 1);
});

test("the recipe follows the pen, and a cancelled stroke leaves no trace", async () => {
  await open([{ id: "land", op: "learned.sketch" }], "land");
  activeTool.value = "slot:rivers";
  paper.pen!.down(paper.at([0, 0]));
  paper.pen!.move([paper.at([1000, 0]), paper.at([2000, 500])]);
  await frame();
  assert.equal(items("land", "rivers").length, 1);
  paper.pen!.cancel();
  await settled();
  await settled();
  assert.equal(params("land")?.["rivers"], undefined);
  assert.equal(studio.document.value.done, 0);
});

test("clicks make a line; Backspace takes one back, Enter ends it, Escape leaves nothing", async () => {
  await open([{ id: "land", op: "learned.sketch" }], "land");
  activeTool.value = "slot:ridges";
  for (const [x, y] of [[0, 0], [1000, 0], [5000, 5000], [2000, 1000]] as const) await paper.click(x, y);
  await paper.click(3000, 3000);
  assert.ok(press("Backspace"));
  assert.ok(press("Enter"));
  await settled();
  assert.deepEqual(items("land", "ridges"), [{ points: [[0, 0], [1000, 0], [5000, 5000], [2000, 1000]] }]);
  assert.equal(labels().length, 1);
  for (const [x, y] of [[0, 0], [1000, 0]] as const) await paper.click(x, y);
  assert.ok(press("Escape"));
  await settled();
  await settled();
  assert.equal(items("land", "ridges").length, 1);
});

test("a height is the ground's, and digits give another", async () => {
  await open([{ id: "land", op: "learned.sketch" }], "land");
  assert.ok(press("h"));
  await paper.click(1000, 2000);
  assert.deepEqual(items("land", "heights"), [{ x_m: 1000, y_m: 2000, height_m: 420 }]);
  for (const key of ["1", "7", "0", "0"]) assert.ok(press(key));
  assert.ok(press("Enter"));
  await settled();
  assert.deepEqual(items("land", "heights"), [{ x_m: 1000, y_m: 2000, height_m: 1700 }]);
  assert.deepEqual(labels(), ["land: height placed", "land: height typed"]);
  await paper.stroke([[1000, 2000], [1500, 2500], [3000, 3000]]);
  assert.deepEqual(items("land", "heights"), [{ x_m: 3000, y_m: 3000, height_m: 1700 }]);
});

test("another step ends what is half done", async () => {
  await open([{ id: "land", op: "learned.sketch" }, { id: "isle", op: "island.build" }], "land");
  assert.ok(press("h"));
  await paper.click(1000, 2000);
  assert.ok(press("9"));
  studio.selected.value = "isle";
  await settled();
  assert.equal(tools.busy.value, false);
  assert.equal(items("land", "heights")[0]!["height_m"], 9);
  activeTool.value = "slot:areas";
  for (const [x, y] of [[0, 0], [900, 0], [900, 900]] as const) await paper.click(x, y);
  studio.selected.value = null;
  await settled();
  assert.equal((params("isle")["areas"] as Json[]).length, 1);
});

test("selecting, moving points and the whole, inserting, deleting, nudging", async () => {
  const line: Json = { points: [[0, 0], [4000, 0], [4000, 4000]] };
  await open([{ id: "land", op: "learned.sketch", params: { ridges: [line] } }], "land");
  const points = () => items("land", "ridges")[0]?.["points"];
  await paper.click(2500, 0);
  assert.equal(selection.value.size, 1);
  await paper.stroke([[0, 0], [100, 100], [200, -600]]);
  assert.deepEqual(points(), [[200, -600], [4000, 0], [4000, 4000]]);
  await paper.stroke([[4000, 3000], [4100, 3000], [5000, 3000]]);
  assert.deepEqual(points(), [[1200, -600], [5000, 0], [5000, 4000]]);
  paper.pen!.double!(paper.at([5000, 1000]));
  await settled();
  assert.equal((points() as Json[]).length, 4);
  assert.ok(press("Delete"));
  await settled();
  assert.equal((points() as Json[]).length, 3);
  assert.ok(press("ArrowRight") && press("ArrowRight"));
  await settled();
  assert.deepEqual(points(), [[1240, -600], [5040, 0], [5040, 4000]]);
  assert.deepEqual(labels().slice(2), ["land: point added", "land: point deleted", "land: nudged"]);
  assert.ok(press("a", { ctrlKey: true }) && press("Delete"));
  await settled();
  assert.deepEqual(items("land", "ridges"), []);
});

test("wind has the brush's width; Ctrl turns it round; brackets change it", async () => {
  await open([{ id: "isle", op: "island.build" }, { id: "wind", op: "island.wind", in: "isle" }], "wind");
  activeTool.value = "slot:strokes";
  assert.ok(press("]"));
  await paper.stroke([[0, 0], [2000, 100], [4000, 0]], { ctrl: true });
  const [stroke] = items("wind", "strokes");
  assert.equal(stroke!["strength_m"], -400);
  assert.equal(stroke!["width_m"], 630);
});

test("sculpting adds a step behind at the first stroke, and none before", async () => {
  await open([{ id: "isle", op: "island.build" }, { id: "reef", op: "island.coral", in: "isle" }], "isle");
  tools.take("add:terrain.sculpt:behind");
  assert.equal(studio.document.value.recipe.steps.length, 2);
  paper.pen!.down(paper.at([0, 0]));
  await frame();
  assert.equal(studio.selected.value, "sculpt");
  paper.pen!.cancel();
  await settled();
  await settled();
  assert.deepEqual(studio.document.value.recipe.steps.map((step) => step.id), ["isle", "reef"]);
  assert.equal(studio.selected.value, "isle");
  tools.take("add:terrain.sculpt:behind");
  await paper.stroke(pointsOf(recorded[0]!));
  assert.deepEqual(studio.document.value.recipe.steps.map((step) => step.id), ["isle", "sculpt", "reef"]);
  assert.equal(labels().length, 1);
  assert.equal(activeTool.value, "slot:strokes:raise");
  await paper.stroke(pointsOf(recorded[2]!), { ctrl: true });
  await paper.stroke(pointsOf(recorded[2]!), { shift: true });
  await paper.click(0, 0);
  assert.deepEqual(items("sculpt", "strokes").map((stroke) => stroke["tool"]), ["raise", "lower", "smooth", "raise"]);
});

test("pressure of a pen is kept with the points, and not where a tool has none", async () => {
  await open([{ id: "a", op: "terrain.sculpt" }, { id: "b", op: "classify.paint" }], "a");
  activeTool.value = "slot:strokes:raise";
  const [stroke] = recorded;
  await paper.stroke(pointsOf(stroke!), { device: "pen" }, stroke!.map((s) => s.pressure));
  const drawn = items("a", "strokes")[0]!;
  assert.equal((drawn["pressure"] as number[]).length, (drawn["points"] as Json[]).length);
  studio.selected.value = "b";
  activeTool.value = "slot:strokes:region";
  assert.ok(press("3"));
  await paper.stroke(pointsOf(stroke!), { device: "pen" }, stroke!.map((s) => s.pressure));
  assert.deepEqual(Object.keys(items("b", "strokes")[0]!).sort(), ["points", "radius_m", "region", "tool"]);
  assert.equal(items("b", "strokes")[0]!["region"], "lagoon");
});

test("areas: a lasso, corners, and a hole with Ctrl", async () => {
  await open([{ id: "isle", op: "island.build" }], "isle");
  activeTool.value = "slot:areas";
  const circle = (r: number) => Array.from(
    { length: 60 }, (_, i) => [r * Math.cos(i / 9), r * Math.sin(i / 9)] as const,
  );
  await paper.stroke(circle(6000));
  await paper.stroke(circle(2000), { ctrl: true });
  const [area] = params("isle")["areas"] as { [name: string]: Json }[];
  assert.equal((area!["holes"] as Json[]).length, 1);
  for (const [x, y] of [[8000, 8000], [9000, 8000], [9000, 9000], [8000, 8000]] as const) await paper.click(x, y);
  assert.deepEqual((params("isle")["areas"] as Json[])[1], [[8000, 8000], [9000, 8000], [9000, 9000]]);
  assert.deepEqual(labels(), ["isle: coast drawn", "isle: hole drawn", "isle: coast drawn"]);
});

test("a contour is deleted by a click, those in a lasso by drawing around them", async () => {
  await open([{ id: "lines", op: "contour.edit" }], "lines");
  assert.ok(press("e"));
  await paper.click(1000, 1000);
  assert.deepEqual(items("lines", "edits"), [{ tool: "delete", select: { at: [[1000, 1000]] } }]);
});

test("an object is moved by dragging it, at the end of its growth", async () => {
  await open([{ id: "life", op: "ecosystem.grow", params: { iterations: 12 } }], "life");
  activeTool.value = "slot:edits:move";
  await paper.stroke([[0, 0], [500, 0], [1000, 500]]);
  assert.deepEqual(items("life", "edits"), [{ tool: "move", object: { near: [0, 0] }, by: [1000, 500], after: 11 }]);
});

test("the eraser cuts", async () => {
  await open([{ id: "land", op: "learned.sketch", params: { ridges: [{ points: [[-5000, 0], [5000, 0]] }] } }], "land");
  activeTool.value = "edit:erase";
  await paper.stroke([[0, -2000], [0, 0], [0, 2000]]);
  assert.equal(items("land", "ridges").length, 2);
  assert.deepEqual(labels(), ["land: erased"]);
});

test("measuring changes nothing", async () => {
  await open([{ id: "land", op: "learned.sketch" }], "land");
  activeTool.value = "measure:distance";
  await paper.stroke([[0, 0], [1500, 0], [3000, 4000]]);
  assert.ok(paper.shapes.some((shape) => shape.shape === "dot" && shape.label === "5.00 km"));
  assert.equal(studio.document.value.revision, 1);
});

test("every tool of every step survives any order of events, and the recipe stays one", async () => {
  const { schema } = await import("./testing/schema");
  let state = 11;
  const random = () => (state = (Math.imul(state, 1103515245) + 12345) >>> 0) / 2 ** 32;
  await open(schema.operators.map((op) => ({ id: op.name.replace(".", "_"), op: op.name, in: {} })), null);
  for (const step of studio.document.value.recipe.steps.map((one) => one.id)) {
    studio.selected.value = step;
    for (const offer of tools.offers.value.rail) {
      tools.take(offer.id);
      for (let i = 0; i < 12; ++i) {
        const at = paper.at(
          [24000 * (random() - 0.5), 24000 * (random() - 0.5)],
          { ctrl: random() > 0.8, shift: random() > 0.8, height: random() > 0.5 ? 10 : null },
        );
        const what = Math.floor(random() * 8);
        if (what === 0) paper.pen!.down(at);
        else if (what === 1) paper.pen!.move([at]);
        else if (what === 2) paper.pen!.up(at);
        else if (what === 3) paper.pen!.cancel();
        else if (what === 4) paper.pen!.hover?.(random() > 0.5 ? at : null);
        else if (what === 5) paper.pen!.double?.(at);
        else press(["Enter", "Escape", "Delete", "Backspace", "5", "ArrowUp", "s"][Math.floor(random() * 7)]!);
      }
      paper.pen!.cancel();
      assert.equal(tools.busy.value, false, `${step} ${offer.id}`);
    }
    await frame();
  }
  await settled();
  assert.ok(toolActions(studio).every((action) => action.title !== ""));
  assert.ok(!studio.message.value || studio.message.value.kind !== "error", studio.message.value?.text);
});
