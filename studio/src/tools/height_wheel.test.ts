import assert from "node:assert/strict";
import { test } from "node:test";
import { turnedHeight } from "./height_wheel";

test("a height is turned in even steps that suit it, within its bounds", () => {
  assert.equal(turnedHeight(0, 1), 1);
  assert.equal(turnedHeight(1000, 1), 1020);
  assert.equal(turnedHeight(1013, 1), 1040);
  assert.equal(turnedHeight(1000, -2), 960);
  assert.equal(turnedHeight(8990, 1, -12000, 9000), 9000);
  assert.equal(turnedHeight(-200, -1), -205);
});
