import assert from "node:assert/strict";
import { test } from "node:test";
import { defaultOptions, readTaste, tasteOf, type ViewOptions } from "./options";

test("what was kept comes back", () => {
  const chosen: ViewOptions = {
    ...defaultOptions, climate: "polar", ground: "slope", sun: { azimuth_deg: 12, elevation_deg: 80 }, grid: true,
    navigation: "gaea", exaggeration: 4, wireframe: true, water: false,
  };
  const read = readTaste(JSON.parse(JSON.stringify(tasteOf(chosen))));
  assert.deepEqual(read, tasteOf(chosen));
  assert.deepEqual({ ...defaultOptions, ...read }, { ...chosen, exaggeration: 1, wireframe: false, water: true });
});

test("what was left there by somebody else is passed over, one by one", () => {
  assert.equal(readTaste(null), undefined);
  assert.equal(readTaste("polar"), undefined);
  const sun = { azimuth_deg: -1, elevation_deg: 40 };
  const odd = { climate: "lunar", ground: 3, sun, grid: "yes", navigation: null };
  assert.deepEqual(readTaste(odd), { ...tasteOf(defaultOptions), sun: { azimuth_deg: 300, elevation_deg: 40 } });
  assert.deepEqual(readTaste({ climate: "arid", sun: 5 }), { ...tasteOf(defaultOptions), climate: "arid" });
});
