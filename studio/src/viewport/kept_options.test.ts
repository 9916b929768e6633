import assert from "node:assert/strict";
import { test } from "node:test";
import { signal } from "@preact/signals";
import { keepOptions, keptOptions } from "./kept_options";
import { defaultOptions } from "./options";

class Kept {
  text: string | null = null;
  getItem(): string | null {
    return this.text;
  }
  setItem(_key: string, text: string): void {
    this.text = text;
  }
}

test("view options are kept as they were set, but for the exaggeration", () => {
  const storage = new Kept(), options = signal(defaultOptions);
  const stop = keepOptions(storage, options);
  const chosen = {
    ...defaultOptions, climate: "arid", water: false, grid: true, ground: "contours", navigation: "gaea",
    sun: { azimuth_deg: 12, elevation_deg: 70 },
  } as const;
  options.value = { ...chosen, exaggeration: 3 };
  assert.deepEqual(keptOptions(storage), chosen);
  stop();
  options.value = defaultOptions;
  assert.deepEqual(keptOptions(storage), chosen);
});

test("what nobody could have set is left out", () => {
  const storage = new Kept();
  for (const text of ["", "{", "7", "null", "[]", '{"sun": 4}']) {
    storage.text = text;
    assert.deepEqual(keptOptions(storage), defaultOptions, text);
  }
  storage.text = '{"climate": "lunar", "ground": 3, "water": "no", "sun": {"azimuth_deg": 1e9, "elevation_deg": 20}}';
  assert.deepEqual(keptOptions(storage), { ...defaultOptions, sun: { ...defaultOptions.sun, elevation_deg: 20 } });
  assert.deepEqual(keptOptions(null), defaultOptions);
});
