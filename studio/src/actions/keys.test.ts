import assert from "node:assert/strict";
import { test } from "node:test";
import { isTyping, keysText, matches } from "./keys";

const press = (key: string, held = "") => ({
  key, ctrlKey: held.includes("c"), metaKey: held.includes("m"), shiftKey: held.includes("s"),
  altKey: held.includes("a"),
});

test("letters go by Shift, signs do not", () => {
  assert.ok(matches(press("Z", "cs"), "Ctrl+Shift+Z"));
  assert.ok(!matches(press("Z", "cs"), "Ctrl+Z"));
  assert.ok(matches(press("z", "m"), "Ctrl+Z"));
  assert.ok(matches(press("?", "s"), "?"));
  assert.ok(matches(press("?"), "?"));
  assert.ok(matches(press("+", "cs"), "Ctrl++"));
  assert.ok(!matches(press("f", "c"), "F"));
  assert.ok(matches(press(" "), "Space"));
  assert.ok(matches(press("F6", "s"), "Shift+F6"));
});

test("where one types", () => {
  assert.ok(isTyping({ tagName: "INPUT", type: "text" } as unknown as EventTarget));
  assert.ok(!isTyping({ tagName: "INPUT", type: "range" } as unknown as EventTarget));
  assert.ok(!isTyping({ tagName: "BUTTON" } as unknown as EventTarget));
  assert.ok(!isTyping(null));
});

test("on a Mac", () => assert.equal(keysText("Ctrl+Shift+Z", true), "⌘⇧Z"));
