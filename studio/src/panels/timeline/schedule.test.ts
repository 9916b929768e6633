import assert from "node:assert/strict";
import { test } from "node:test";
import { draggedSpan, isEndless, marks, nextTime, shownEnd } from "./schedule";

test("dragging a span", () => {
  const span = { start: 10, end: 20 };
  assert.deepEqual(draggedSpan(span, "both", 5.4, 1), { start: 15, end: 25 });
  assert.deepEqual(draggedSpan(span, "both", -50, 1), { start: 0, end: 10 });
  assert.deepEqual(draggedSpan(span, "start", 50, 1), { start: 19, end: 20 });
  assert.deepEqual(draggedSpan(span, "end", -50, 1), { start: 10, end: 11 });
  const endless = { start: 0, end: 1e9 };
  assert.ok(isEndless(endless));
  assert.deepEqual(draggedSpan(endless, "both", 3, 1), { start: 3, end: 1e9 });
});

test("what is shown and played", () => {
  assert.equal(shownEnd([{ start: 0, end: 1e9 }], 30), 40);
  assert.equal(shownEnd([], 0), 1.5);
  assert.deepEqual(marks(40, 5), [0, 10, 20, 30, 40]);
  assert.ok(marks(1.5, 6).length <= 9);
  assert.equal(nextTime(29, 30, 1), 30);
  assert.equal(nextTime(30, 30, 1), 0);
});
