import assert from "node:assert/strict";
import { test } from "node:test";
import { differences } from "./text_diff";

function applied(text: string, after: string): string {
  let result = text;
  for (const { from, to, insert } of differences(text, after).reverse()) result = result.slice(0, from) + insert
    + result.slice(to);
  return result;
}

test("two numbers that changed are two small replacements", () => {
  const before = '{\n  "a": 1,\n  "b": 2,\n  "c": 3\n}\n';
  assert.deepEqual(differences(before, before.replace("1", "15").replace("3", "4")), [
    { from: 10, to: 10, insert: "5" },
    { from: 29, to: 30, insert: "4" },
  ]);
  assert.deepEqual(differences(before, before), []);
});

test("a text that is changed by its differences is the other text", () => {
  let random = 7;
  const next = (n: number) => (random = (random * 48271) % 2147483647) % n;
  for (let i = 0; i < 300; ++i) {
    const make = () => Array.from({ length: next(12) }, () => "abc".slice(next(3)) + (next(5) ? "\n" : "")).join("");
    const before = make(), after = make();
    assert.equal(applied(before, after), after);
  }
});
