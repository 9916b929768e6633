import assert from "node:assert/strict";
import { test } from "node:test";
import { actionFor, allActions, registerActions, runAction } from "./registry";

const press = (key: string, ctrlKey = false) => ({ key, ctrlKey, metaKey: false, shiftKey: false, altKey: false });

test("an action is run by its name and found by its keys, the latest first, if it is possible", () => {
  const ran: string[] = [];
  let possible = true;
  const first = registerActions(
    [{ id: "a.one", title: "One", group: "Edit", keys: ["F"], run: () => ran.push("one") }],
  );
  const second = registerActions([
    { id: "a.two", title: "Two", group: "Edit", keys: ["F"], when: () => possible, run: () => ran.push("two") },
  ]);
  assert.equal(actionFor(press("f"), false)!.id, "a.two");
  possible = false;
  assert.equal(actionFor(press("f"), false)!.id, "a.one");
  assert.ok(runAction("a.one"));
  assert.ok(!runAction("a.two"));
  assert.ok(!runAction("a.three"));
  assert.deepEqual(ran, ["one"]);
  second();
  first();
  assert.equal(allActions.value.length, 0);
});

test("while one types, letters are letters and Ctrl+Z is the field's", () => {
  const end = registerActions([
    { id: "a", title: "", group: "", keys: ["F"], run: () => undefined },
    { id: "b", title: "", group: "", keys: ["Ctrl+S"], run: () => undefined },
    { id: "c", title: "", group: "", keys: ["Ctrl+Z"], run: () => undefined },
  ]);
  assert.equal(actionFor(press("f"), true), undefined);
  assert.equal(actionFor(press("s", true), true)!.id, "b");
  assert.equal(actionFor(press("z", true), true), undefined);
  assert.equal(actionFor(press("z", true), false)!.id, "c");
  end();
});
