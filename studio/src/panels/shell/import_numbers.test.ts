import assert from "node:assert/strict";
import { test } from "node:test";
import { importNumbers, numbersText, sidecarsOf } from "./import_numbers";

test("the numbers of an engine's side-car", () => {
  const sidecar = {
    file: "u.r16", target: "unreal", import: { "Scale X": "100", "Scale Z": "136.9", note: "centimetres" },
  };
  const numbers = importNumbers(sidecar)!;
  assert.deepEqual(numbers.rows, [["Scale X", "100"], ["Scale Z", "136.9"]]);
  assert.equal(
    numbersText([numbers], ["mind the gap"]), "u.r16\n  Scale X: 100\n  Scale Z: 136.9\n  (centimetres)\nmind the gap",
  );
  assert.equal(importNumbers({ file: "height.tif" }), null);
});

test("side-cars lie beside what they describe", () => {
  assert.deepEqual(sidecarsOf(["a/u.r16", "a/u.r16.json", "a/tiles.json"]), ["a/u.r16.json"]);
});
