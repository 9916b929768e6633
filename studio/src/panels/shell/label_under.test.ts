import assert from "node:assert/strict";
import { test } from "node:test";
import { labelAt } from "./label_under";

test("the label under a place, rows from the north", () => {
  const frame = { columns: 2, rows: 2, cell_m: 10, west: -10, north: 10, crs: "" };
  const raster = { key: "k", frame, values: Uint8Array.of(0, 1, 3, 255), coarse: false, min: 0, max: 4 };
  assert.equal(labelAt(raster, -5, 5), "mountain");
  assert.equal(labelAt(raster, 5, 5), "beach");
  assert.equal(labelAt(raster, -5, -5), "reef");
  assert.equal(labelAt(raster, 5, -5), null);
  assert.equal(labelAt(raster, 11, 0), null);
});
