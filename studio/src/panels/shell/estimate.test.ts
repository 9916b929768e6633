import assert from "node:assert/strict";
import { test } from "node:test";
import { Estimate } from "./estimate";

test("an estimate waits until it knows something, and begins anew with the work", () => {
  const estimate = new Estimate();
  assert.equal(estimate.left_s(0, 0), null);
  assert.equal(estimate.left_s(0.01, 5000), null);
  assert.equal(estimate.left_s(0.25, 10_000), 30);
  assert.equal(estimate.left_s(0.1, 11_000), null);
  assert.equal(estimate.left_s(0.2, 13_000), 16);
});
