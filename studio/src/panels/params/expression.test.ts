import assert from "node:assert/strict";
import { test } from "node:test";
import { readTyped } from "./expression";
import { readUnit, unitText } from "./units";

const value = (text: string, unit = ""): number => {
  const typed = readTyped(text, unit);
  if ("error" in typed) throw new Error(typed.error);
  return typed.value;
};
const error = (text: string, unit = ""): string => {
  const typed = readTyped(text, unit);
  return "error" in typed ? typed.error : "";
};

test("numbers and sums", () => {
  assert.equal(value("450"), 450);
  assert.equal(value(" -4.5e2 "), -450);
  assert.equal(value("2*450"), 900);
  assert.equal(value("2 + 3 * 4"), 14);
  assert.equal(value("(2 + 3) * 4 / 10"), 2);
  assert.equal(value("2^3^2"), 512);
  assert.equal(value("-2^2"), -4);
  assert.equal(value("1,5"), 1.5);
  assert.equal(value(".5"), 0.5);
  assert.equal(value("0.1 + 0.2"), 0.3);
});

test("units are converted to the field's", () => {
  assert.equal(value("1.2 km", "m"), 1200);
  assert.equal(value("2 * 1.2 km", "m"), 2400);
  assert.equal(value("1 km + 200", "m"), 1200);
  assert.equal(value("100 ft", "m"), 30.48);
  assert.equal(value("1 ha", "m2"), 10000);
  assert.equal(value("3 km²", "m2"), 3e6);
  assert.equal(value("2 km * 3 km", "km2"), 6);
  assert.equal(value("1 m/s", "m/s"), 1);
  assert.equal(value("36 km/h", "m/s"), 10);
  assert.equal(value("0.5 m / 1 kyr", "mm/yr"), 0.5);
  assert.equal(value("250 ka", "yr"), 250000);
  assert.equal(value("pi rad", "deg") > 0, true);
  assert.equal(value("45°", "deg"), 45);
  assert.equal(value("50%"), 0.5);
  assert.equal(value("50%", "%"), 50);
  assert.equal(value("(1 + 2) km", "m"), 3000);
  assert.equal(value("3", "1/sqrt(m yr)"), 3);
});

test("what is not understood is said", () => {
  assert.match(error("", "m"), /missing/);
  assert.match(error("12 parsec", "m"), /no unit/);
  assert.match(error("3 km", "deg"), /°/);
  assert.match(error("3 km"), /without unit/);
  assert.match(error("(3", "m"), /\)/);
  assert.match(error("1/0"), /zero/);
  assert.match(error("3 m + 2 yr", "m"), /different/);
  assert.match(error("3 4"), /not understood/);
  assert.match(error("alert(1)"), /no number/);
  assert.match(error("1 km", "1/sqrt(m yr)"), /plain/);
});

test("unit texts", () => {
  assert.equal(unitText("m2/yr"), "m²/yr");
  assert.equal(unitText("deg"), "°");
  assert.equal(readUnit("furlong"), null);
  assert.deepEqual(readUnit("1/km2")?.powers, [-2, 0, 0, 0]);
});
