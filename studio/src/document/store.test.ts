import assert from "node:assert/strict";
import { test } from "node:test";
import type { EditRequest } from "../api/types";
import { FakeServer } from "./fake";
import { openStudio } from "./open_studio";
import type { OpenedStudio } from "./open_studio";

async function until(holds: () => boolean): Promise<void> {
  for (let i = 0; i < 400; ++i) {
    if (holds()) return;
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  assert.fail("it did not come to hold within two seconds");
}

async function started(): Promise<{ server: FakeServer; studio: OpenedStudio }> {
  const server = new FakeServer();
  const studio = await openStudio(server, "me");
  await until(() => studio.connected.value);
  return { server, studio };
}

const peak = (value: number) => [{ do: "set" as const, pointer: "/steps/isle/params/peak_m", value }];
const sentEdits = (server: FakeServer): EditRequest[] => (
  server.requests.filter(({ what }) => what === "edits").map(({ body }) => body as EditRequest)
);

test("an edit is seen at once and confirmed later", async () => {
  const { server, studio } = await started();
  const taken = studio.edit(peak(1500), "isle: peak");
  assert.equal(studio.param("isle", "peak_m"), 1500);
  assert.equal(studio.busy.value, true);
  assert.equal(await taken, true);
  assert.equal(studio.busy.value, false);
  assert.equal(server.recipe.steps[0]!.params!["peak_m"], 1500);
  assert.deepEqual(studio.document.value.history, [{ label: "isle: peak", window: "me" }]);
  studio.close();
});

test("of a gesture's edits only the newest is sent; all are answered; one undo takes them back", async () => {
  const { server, studio } = await started();
  const all = [1, 2, 3, 4, 5, 6].map((i) => studio.edit(peak(1000 + i), "peak", "drag"));
  assert.deepEqual(await Promise.all(all), [true, true, true, true, true, true]);
  assert.deepEqual(sentEdits(server).map(({ edits }) => (edits[0] as { value: number }).value), [1001, 1006]);
  assert.equal(await studio.undo(), true);
  assert.equal(studio.param("isle", "peak_m"), 1100);
  assert.equal(await studio.redo(), true);
  assert.equal(studio.param("isle", "peak_m"), 1006);
  studio.close();
});

test("results of a gesture are overtaken once it has ended with another, and not while it goes on", async (t) => {
  const { server, studio } = await started();
  t.after(() => studio.close());
  const before = studio.document.value.revision;
  await studio.edit(peak(1500), "peak", "drag");
  assert.equal(studio.overtaken(before), false);
  const resting = studio.edit(peak(1500), "peak", "drag", true);  // on its way, and it changes nothing
  assert.equal(studio.overtaken(before), true);
  assert.equal(studio.overtaken(before + 1), false);
  await resting;
  assert.equal(studio.overtaken(before + 1), false);
  void studio.edit(peak(1600), "peak", "other drag");
  assert.equal(studio.overtaken(before), false);
  const last = studio.edit(peak(1700), "peak", "other drag", true);
  assert.equal(studio.overtaken(studio.document.value.revision), true);
  await last;
  const end = studio.document.value.revision;
  assert.equal(studio.overtaken(end - 1), true);
  assert.equal(studio.overtaken(end), false);
  await server.editFromElsewhere(peak(1800));
  await until(() => studio.document.value.revision > end);
  assert.equal(studio.overtaken(end), false, "another window's hand is followed");
});

test("what is confirmed as it was shown is the same state, and what is not has the same recipe", async (t) => {
  const { studio } = await started();
  t.after(() => studio.close());
  let states = 0;
  const stop = studio.document.subscribe(() => ++states);
  const recipe = studio.document.value.recipe;
  await studio.edit(peak(1500), "peak");
  const after = studio.document.value.recipe;
  assert.notEqual(after, recipe);
  assert.ok(states <= 3, `${states}`);  // as it is, edited, confirmed
  await studio.edit(peak(1500), "peak");
  assert.equal(studio.document.value.recipe, after);
  stop();
});

test("what the caller does with its lists afterwards is nothing to the document", async () => {
  const { studio } = await started();
  const points = [[0, 0]];
  const done = studio.edit([{ do: "set", pointer: "/steps/isle/params/centre", value: points }], "points", "stroke");
  points.push([1, 1]);
  await done;
  assert.deepEqual(studio.param("isle", "centre"), [[0, 0]]);
  studio.close();
});

test("a refused edit is taken back and said at its step", async () => {
  const { studio } = await started();
  const taken = studio.edit([{ do: "set", pointer: "/steps/reef/op", value: "island.coarl" }], "op");
  assert.equal(studio.step("reef")!.op, "island.coarl");
  assert.equal(await taken, false);
  assert.equal(studio.step("reef")!.op, "island.coral");
  assert.deepEqual(studio.message.value, { kind: "error", text: "unknown operator 'island.coarl'", step: "reef" });
  studio.close();
});

test("another window's edits are put under one's own", async () => {
  const { server, studio } = await started();
  const elsewhere = server.editFromElsewhere([{ do: "set", pointer: "/steps/reef/params/subsidence", value: 0.7 }]);
  const own = studio.edit(peak(1300), "peak");
  await elsewhere;
  assert.equal(await own, true);
  assert.equal(studio.param("reef", "subsidence"), 0.7);
  assert.equal(studio.param("isle", "peak_m"), 1300);
  assert.deepEqual(studio.document.value.recipe, server.recipe);
  studio.close();
});

test("a request whose answer is lost is carried out once", async () => {
  const { server, studio } = await started();
  server.loseAnswer = true;
  const insert = { do: "insert" as const, list: "/steps", value: { id: "new", op: "terrain.smooth" } };
  const taken = studio.edit([insert], "add");
  assert.equal(await taken, true);
  assert.equal(studio.document.value.recipe.steps.filter((step) => step.id === "new").length, 1);
  assert.deepEqual(studio.document.value.recipe, server.recipe);
  studio.close();
});

test("while the server is gone edits wait; they are sent when it is there again", async () => {
  const { server, studio } = await started();
  server.die();
  await until(() => !studio.connected.value);
  const taken = studio.edit(peak(1700), "peak");
  assert.equal(studio.param("isle", "peak_m"), 1700);
  server.gone = false;
  await until(() => studio.connected.value);
  assert.equal(await taken, true);
  assert.equal(server.recipe.steps[0]!.params!["peak_m"], 1700);
  studio.close();
});

test("what was missed while the server was gone is fetched", async () => {
  const { server, studio } = await started();
  server.die();
  server.gone = false;
  await server.editFromElsewhere(peak(1234));
  await until(() => studio.connected.value && studio.param("isle", "peak_m") === 1234);
  studio.close();
});

test("undo is not for what another window has just done", async () => {
  const { server, studio } = await started();
  await studio.edit(peak(1300), "mine");
  await Promise.all([server.editFromElsewhere(peak(1400)), studio.undo().then((taken) => assert.equal(taken, false))]);
  assert.equal(studio.param("isle", "peak_m"), 1400);
  studio.close();
});

test("results of what is shown come, also as every second cell", async () => {
  const { studio } = await started();
  assert.deepEqual(studio.shown.value, { terrain: "rougher.terrain", overlay: null, objects: null, things: null });
  await until(() => studio.values.value.has("rougher.terrain"));
  studio.selected.value = "heights";
  assert.deepEqual(
    studio.shown.value, { terrain: "reef.terrain", overlay: "heights.mask", objects: null, things: null },
  );
  await until(() => studio.values.value.has("heights.mask"));
  const whole = await studio.raster("reef.terrain"), half = await studio.raster("reef.terrain", 1);
  assert.equal(whole!.values.length, 256 * 256);
  assert.equal(half!.frame.columns, 128);
  assert.equal(half!.values[1], whole!.values[2]);
  assert.equal(await studio.raster("nothing.terrain"), null);
  studio.close();
});

test("three hundred random actions of two windows end alike", async () => {
  const server = new FakeServer(0);
  const [a, b] = await Promise.all([openStudio(server, "a"), openStudio(server, "b")]);
  await until(() => a.connected.value && b.connected.value);
  let random = 1;
  const next = (n: number) => (random = (random * 48271) % 2147483647) % n;
  const waiting: Promise<boolean>[] = [];
  for (let i = 0; i < 300; ++i) {
    const studio = next(2) ? a : b;
    const choice = next(6);
    if (choice === 0) waiting.push(studio.undo());
    else if (choice === 1) waiting.push(studio.redo());
    else if (choice === 2) waiting.push(
      studio.edit([{ do: "insert", list: "/steps/isle/params/summits", index: 0, value: i }], "put"),
    );
    else waiting.push(studio.edit(peak(i), "peak", `g${next(3)}`));
    if (next(4) === 0) await new Promise((resolve) => setTimeout(resolve, 1));
  }
  await Promise.all(waiting);
  await until(() => a.document.value.revision === server.revision && b.document.value.revision === server.revision);
  assert.deepEqual(a.document.value.recipe, server.recipe);
  assert.deepEqual(b.document.value.recipe, server.recipe);
  assert.deepEqual(a.document.value.history, server.history.map(({ label, window }) => ({ label, window })));
  a.close();
  b.close();
});

test("another document takes the place of this one, in every window, and edits made at once are kept", async () => {
  const server = new FakeServer();
  const [a, b] = await Promise.all([openStudio(server, "a"), openStudio(server, "b")]);
  await until(() => a.connected.value && b.connected.value);
  await a.open({ blank: true, width_m: 1000, height_m: 1000, cell_m: 10 });
  const taken = a.edit([{ do: "insert", list: "/steps", value: { id: "hills", op: "terrain.noise" } }], "add");
  a.selected.value = "hills";
  assert.equal(await taken, true);
  await until(() => b.document.value.recipe.steps.length === 1);
  assert.equal(a.selected.value, "hills");
  assert.deepEqual(a.document.value.recipe, server.recipe);
  a.close();
  b.close();
});
