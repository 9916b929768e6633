import assert from "node:assert/strict";
import { test } from "node:test";
import { Pace } from "./pace";

test("slow machines draw moving views more coarsely, and finer again when they are fast", () => {
  const pace = new Pace(true);
  assert.equal(pace.quickSize, 0.6);
  for (let i = 0; i < 10; ++i) pace.took(200, false);
  assert.equal(pace.quickSize, 0.45);
  for (let i = 0; i < 30; ++i) pace.took(5, false);
  assert.equal(pace.quickSize, 1);
});

test("fine pictures that take too long are left out for a while", () => {
  const pace = new Pace(true);
  assert.ok(pace.mayBeFine());
  assert.equal(pace.samples(8), 4);
  pace.took(3000, true);
  assert.equal(pace.samples(8), 1);
  let left = 0;
  while (!pace.mayBeFine()) ++left;
  assert.ok(left > 3 && left < 12);
  assert.equal(new Pace(false).samples(8), 8);
});
