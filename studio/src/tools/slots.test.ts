import assert from "node:assert/strict";
import { test } from "node:test";
import { operatorNamed } from "./testing/schema";
import { slotsOf } from "./slots";

const ids = (op: string) => slotsOf(operatorNamed(op)).map((slot) => `${slot.id} ${slot.geometry}`).sort();

test("each kind of parameter that holds geometry is a slot", () => {
  assert.deepEqual(ids("island.build"), ["areas ring", "centre place", "outlines polar", "summits place"]);
  assert.deepEqual(ids("island.wind"), ["centre place", "strokes line"]);
  assert.deepEqual(ids("contour.grow"), ["outlines ring", "rivers line"]);
  assert.deepEqual(ids("learned.sketch"), ["heights place", "ridges line", "rivers line"]);
  assert.deepEqual(ids("reef.grow"), ["starts/line line", "starts/points place"]);
  assert.deepEqual(ids("terrain.mask"), ["criteria:area ring", "criteria:line line"]);
  assert.deepEqual(ids("terrain.compose"), ["places place"]);
  assert.deepEqual(ids("terrain.crop"), ["x_m place"]);
  assert.deepEqual(ids("terrain.noise"), []);
});

test("lists of tools give a slot a tool", () => {
  const edit = [
    "edits:copy ring", "edits:cut ring", "edits:delete ring", "edits:fill ring", "edits:fractalize ring",
    "edits:paste place", "edits:slope line", "edits:smooth ring", "edits:warp line",
  ];
  assert.deepEqual(ids("contour.edit"), edit);
  const scene = [
    "edits:add line", "edits:bend vector", "edits:delete place", "edits:hold place", "edits:move vector",
    "timeline:current line", "timeline:ground place", "timeline:storm place", "window/centre place",
  ];
  assert.deepEqual(ids("ecosystem.grow"), scene);
  assert.deepEqual(ids("erosion.run"), ["lithology/faults line", "lithology/top_x_m place"]);
});

test("a click in place of a ring selects by place", () => {
  const slot = slotsOf(operatorNamed("contour.edit")).find((s) => s.tool === "delete")!;
  assert.deepEqual(slot.parts[0]!.path, ["select", "within"]);
  assert.deepEqual(slot.click!.path, ["select", "at"]);
  const fill = slotsOf(operatorNamed("contour.edit")).find((s) => s.tool === "fill")!;
  assert.deepEqual(fill.parts[0]!.path, ["within"]);
});

test("what an object's edit is about goes along with its place", () => {
  const scene = slotsOf(operatorNamed("ecosystem.grow"));
  const bend = scene.find((s) => s.tool === "bend")!;
  assert.deepEqual([bend.parts[0]!.path, bend.by, bend.also], [["at"], ["by"], [["object", "near"]]]);
  const move = scene.find((s) => s.tool === "move")!;
  assert.deepEqual([move.parts[0]!.path, move.also], [["object", "near"], []]);
});

test("brushes are strokes of a list of tools with a radius", () => {
  for (const op of ["terrain.sculpt", "classify.paint", "terrain.paint"]) {
    for (const slot of slotsOf(operatorNamed(op))) assert.equal(slot.brush, slot.tool !== "area", slot.id);
  }
  assert.ok(!slotsOf(operatorNamed("contour.edit")).some((slot) => slot.brush));
});

test("members are what else an item says", () => {
  const names =
    (op: string, id: string) => slotsOf(operatorNamed(op)).find((s) => s.id === id)!.members.map((m) => m.name);
  assert.deepEqual(names("island.wind", "strokes"), ["width_m", "strength_m"]);
  assert.deepEqual(names("learned.sketch", "heights"), ["height_m"]);
  assert.ok(!names("terrain.sculpt", "strokes:raise").includes("pressure"));
});
