import assert from "node:assert/strict";
import { test } from "node:test";
import { climateNames, climateOf, latitudeOf, type Climate, type ClimateChoice } from "./climate";

const frame = { columns: 100, rows: 100, cell_m: 100, west: 0, north: 5000, crs: "" };

test("zones of UTM tell the latitude", () => {
  assert.equal(latitudeOf(frame), null);
  assert.ok(Math.abs(latitudeOf({ ...frame, crs: "EPSG:32645", north: 3_100_000 })! - 28) < 0.3);
  assert.ok(Math.abs(latitudeOf({ ...frame, crs: "EPSG:32758", north: 8_000_000 })! + 18) < 0.3);
});

test("islands without a place are tropical, mountains temperate", () => {
  const island = climateOf(frame, true), inland = climateOf(frame, false);
  assert.ok(island.basalt && island.seaLevel_c > 24 && island.rain_mm > 1800 && island.windFrom_deg === 115);
  assert.ok(!inland.basalt && inland.seaLevel_c === 11 && inland.snowLine > 2800 && inland.snowLine < 3200);
  assert.ok(climateOf({ ...frame, crs: "EPSG:32645", north: 3_100_000 }, false).snowLine > 5500);
});

test("a chosen climate is that of the renderer's preset, wherever the ground lies", () => {
  for (const crs of ["", "EPSG:32645"]) {
    const of = (choice: ClimateChoice): Climate => climateOf({ ...frame, crs }, true, choice);
    const tropical = of("tropical"), temperate = of("temperate"), arid = of("arid"), polar = of("polar");
    assert.equal(tropical.rain_mm, 5000);
    assert.ok(tropical.seaLevel_c > temperate.seaLevel_c && temperate.seaLevel_c > polar.seaLevel_c);
    assert.ok(arid.rain_mm < 250 && arid.seaLevel_c > 20);
    assert.ok(polar.snowLine < 400 && polar.treeLine === 1);
  }
  assert.equal(climateNames.length, 5);
});
