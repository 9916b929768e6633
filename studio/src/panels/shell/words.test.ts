import assert from "node:assert/strict";
import { test } from "node:test";
import { themeOf } from "./theme";
import { bytesText, durationText, freeId, numberText, operatorTitle } from "./words";

test("sizes, times, numbers and names", () => {
  assert.deepEqual(
    [bytesText(12), bytesText(2100), bytesText(9.96e6), bytesText(999_600)],
    ["12 bytes", "2.1 kB", "10.0 MB", "1.0 MB"],
  );
  assert.deepEqual(
    [durationText(0.2), durationText(12), durationText(61), durationText(3900)], ["1 s", "10 s", "1 min", "1 h 5 min"],
  );
  assert.deepEqual([numberText(-12345.6), numberText(0.04, 1), numberText(-0.04, 1)], ["−12\u2009346", "0.0", "0.0"]);
  assert.equal(operatorTitle("terrain.sea_floor"), "Sea floor");
  assert.equal(freeId("import", ["import", "import_2"]), "import_3");
});

test("the theme follows the system until it is chosen", () => {
  assert.deepEqual(
    [themeOf("system", true), themeOf("system", false), themeOf("light", false)], ["light", "dark", "light"],
  );
});
