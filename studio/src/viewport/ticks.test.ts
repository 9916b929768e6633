import assert from "node:assert/strict";
import { test } from "node:test";
import {
  contourInterval, gridStep, heightText, lengthText, multiples, roundDownNice, roundUpNice, scaleBarLength,
} from "./ticks";

test("round numbers are 1, 2, 5 times a power of ten", () => {
  assert.equal(roundDownNice(7), 5);
  assert.equal(roundDownNice(0.21), 0.2);
  assert.equal(roundDownNice(1000), 1000);
  assert.equal(roundUpNice(11), 20);
  assert.equal(roundUpNice(21), 50);
  assert.equal(roundUpNice(51), 100);
  assert.equal(roundUpNice(50), 50);
});

test("the scale bar is the longest round length that fits", () => {
  assert.equal(scaleBarLength(10, 130), 1000);
  assert.equal(scaleBarLength(100, 130), 10000);
});

test("contours thin out as one zooms out and on steeper ground", () => {
  assert.ok(contourInterval(100, 0.3) > contourInterval(10, 0.3));
  assert.ok(contourInterval(10, 0.8) > contourInterval(10, 0.1));
  assert.equal(contourInterval(0.001, 0.1), 1);
});

test("grid lines lie on multiples inside the range", () => {
  assert.deepEqual(multiples(-2.5, 5, 2.5), [-2.5, 0, 2.5, 5]);
  assert.equal(gridStep(10), 1000);
});

test("lengths and heights as people write them", () => {
  assert.equal(lengthText(1500), "1.5\u202fkm");
  assert.equal(lengthText(250), "250\u202fm");
  assert.equal(heightText(-12345.4), "\u221212\u2009345\u202fm");
  assert.equal(heightText(12.34), "12.3\u202fm");
});
