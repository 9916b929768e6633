import assert from "node:assert/strict";
import { test } from "node:test";
import { ranked } from "./rank";

test("what begins so comes first; every word must be found", () => {
  const items = [{ title: "Swap views" }, { title: "Save as…" }, { title: "Open…", words: "load" }, { title: "Save" }];
  assert.deepEqual(ranked(items, "sa").map(({ title }) => title), ["Save as…", "Save"]);
  assert.deepEqual(ranked(items, "v").map(({ title }) => title), ["Swap views", "Save as…", "Save"]);
  assert.deepEqual(ranked(items, "load").map(({ title }) => title), ["Open…"]);
  assert.deepEqual(ranked(items, "save x"), []);
  assert.equal(ranked(items, "").length, 4);
});
