import assert from "node:assert/strict";
import { test } from "node:test";
import type { EngineState } from "../api/types";
import { FakeServer } from "./fake";
import { frameOfLevel, jsonBytes, Results } from "./results";

const state = (fraction: number, settled = false): EngineState => (
  { revision: 1, settled, coarse: false, fraction, steps: [] }
);

test("progress is shown now and then, the end at once", async () => {
  const results = new Results(new FakeServer(), "me");
  let shown = 0;
  const stop = results.engine.subscribe(() => (shown += 1));
  for (let i = 0; i <= 100; ++i) results.state(state(i / 100));
  assert.ok(shown <= 3);
  await new Promise((resolve) => setTimeout(resolve, 200));
  assert.equal(results.engine.value.fraction, 1);
  results.state(state(0.1));
  results.state(state(1, true));
  assert.equal(results.engine.value.settled, true);
  stop();
});

test("a coarser level has its first cell's middle where it was", () => {
  const frame = frameOfLevel({ columns: 8, rows: 8, cell_m: 10, west: -40, north: 40, crs: "" }, 2, 2, 2);
  assert.deepEqual(frame, { columns: 2, rows: 2, cell_m: 40, west: -55, north: 55, crs: "" });
  assert.equal(frame.west + frame.cell_m / 2, -35);
});

test("what is kept of scenes is counted by what is in it", () => {
  const object = { class: "palm", at: [1, 2] };
  const one = jsonBytes([object]), thousand = jsonBytes(Array.from({ length: 1000 }, () => object));
  assert.ok(one > 50 && thousand > 900 * (one - 40), `${one} ${thousand}`);
});
