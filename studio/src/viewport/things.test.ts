import assert from "node:assert/strict";
import { test } from "node:test";
import { chooseThings, readThings, type ThingsView } from "./things";

const corner = [0, 0, 2, 0, 0, 1, 0.2, 0.4, 0.1];
const triangles = Buffer.from(new Float32Array([...corner, ...corner, ...corner]).buffer).toString("base64");
const answer = {
  models: [{ name: "palm", triangles }, { name: "fern", triangles }],
  instances: [
    { model: "palm", x: 10, y: 0, z: 1, angle_deg: 90, scale: 2 },
    { model: 1, x: 0, y: 500, z: 1, angle_deg: 0, scale: 1 },
    { model: "palm", x: 100, y: 0, z: 1, angle_deg: 0, scale: 1 }, { model: "unknown", x: 0, y: 0, z: 0 },
  ],
};
const view: ThingsView = { eye: [0, 0, 2], planes: [], exaggeration: 1, pixel: 0.001, budget: 1000 };

test("things are read by the name or the number of their model", () => {
  const things = readThings(answer);
  assert.equal(things.models[0]!.radius, 2);
  assert.deepEqual([...things.instances[0]!].slice(0, 5), [10, 0, 1, Math.PI / 2, 2]);
  assert.equal(things.instances[1]!.length, 5);
  assert.deepEqual(readThings(null), { models: [], instances: [] });
});

test("what looks largest goes first, what is outside or tiny is left out", () => {
  const things = readThings(answer);
  assert.deepEqual(chooseThings(things, view).map((c) => [...c]), [[0, 1], [0]]);
  assert.deepEqual(chooseThings(things, { ...view, budget: 1 }).map((c) => [...c]), [[0], []]);
  assert.deepEqual(chooseThings(things, { ...view, pixel: 0.01 }).map((c) => [...c]), [[0, 1], []]);
  assert.deepEqual(chooseThings(things, { ...view, planes: [-1, 0, 0, 50] }).map((c) => [...c]), [[0], [0]]);
});
