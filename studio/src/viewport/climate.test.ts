import assert from "node:assert/strict";
import { test } from "node:test";
import { climateOf, latitudeOf } from "./climate";

const frame = { columns: 100, rows: 100, cell_m: 100, west: 0, north: 5000, crs: "" };

test("zones of UTM tell the latitude", () => {
  assert.equal(latitudeOf(frame), null);
  assert.ok(Math.abs(latitudeOf({ ...frame, crs: "EPSG:32645", north: 3_100_000 })! - 28) < 0.3);
  assert.ok(Math.abs(latitudeOf({ ...frame, crs: "EPSG:32758", north: 8_000_000 })! + 18) < 0.3);
});

test("islands without a place are tropical, mountains temperate", () => {
  assert.equal(climateOf(frame, true).tropical, true);
  const inland = climateOf(frame, false);
  assert.ok(!inland.tropical && inland.snowLine > 2800 && inland.snowLine < 3200);
  assert.ok(climateOf({ ...frame, crs: "EPSG:32645", north: 3_100_000 }, false).snowLine > 5500);
});
