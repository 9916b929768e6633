import assert from "node:assert/strict";
import { test } from "node:test";
import type { Edit } from "../api/types";
import { enqueue, joinEdits } from "./queue";

const set = (pointer: string, value: number): Edit => ({ do: "set", pointer, value });

test("a value that is set again overtakes the one that waits", () => {
  assert.deepEqual(joinEdits([set("/a", 1), set("/b", 1)], [set("/a", 2)]), [set("/b", 1), set("/a", 2)]);
});

test("nothing is overtaken across what moves places", () => {
  const insert: Edit = { do: "insert", list: "/steps", index: 0, value: {} };
  assert.deepEqual(joinEdits([set("/steps/0/x", 1), insert], [set("/steps/0/x", 2)]),
    [set("/steps/0/x", 1), insert, set("/steps/0/x", 2)]);
});

test("only edits of the same gesture are joined", () => {
  const waiting = (gesture: string) => (
    { edits: [set("/a", 1)], label: "", gesture, ends: false, idle: false, settle: [] }
  );
  assert.equal(enqueue([waiting("g")], waiting("g")).length, 1);
  assert.equal(enqueue([waiting("g")], waiting("h")).length, 2);
  assert.equal(enqueue([waiting("")], waiting("")).length, 2);
});
