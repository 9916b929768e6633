import assert from "node:assert/strict";
import { test } from "node:test";
import type { DocumentEvent } from "../api/types";
import { followHistory } from "./history";

const gestures = (...labels: string[]) => labels.map((label) => ({ label, window: "me" }));
const said = (label: string, done: number, undone: number): DocumentEvent => (
  { event: "document", revision: 2, window: "me", changes: [], label, done, undone, saved: false, missing: [] }
);

test("edits are put behind, a gesture that goes on keeps its place", () => {
  assert.deepEqual(
    followHistory({ history: gestures("a"), done: 1 }, said("b", 2, 0)), { history: gestures("a", "b"), done: 2 },
  );
  assert.deepEqual(
    followHistory({ history: gestures("a"), done: 1 }, said("a2", 1, 0)), { history: gestures("a2"), done: 1 },
  );
});

test("what was taken back stays listed until another edit", () => {
  const undone = followHistory({ history: gestures("a", "b"), done: 2 }, said("b", 1, 1));
  assert.deepEqual(undone, { history: gestures("a", "b"), done: 1 });
  assert.deepEqual(followHistory(undone!, said("b", 2, 0)), { history: gestures("a", "b"), done: 2 });
  assert.deepEqual(followHistory(undone!, said("c", 2, 0)), { history: gestures("a", "c"), done: 2 });
});

test("what does not follow is fetched", () => {
  assert.equal(followHistory({ history: gestures("a"), done: 1 }, said("x", 4, 0)), null);
});
