import assert from "node:assert/strict";
import { test } from "node:test";
import { galleryOf } from "./gallery";

test("six lead, the others follow by group, and none is lost but the blank sheet", () => {
  const names = ["kauai", "blank", "contours/volcano", "contours/mesa", "guide/dem", "styles"];
  const examples = names.map((name) => ({
    name, title: name, about: "", group: name.includes("/") ? name.split("/")[0]! : "", picture: name !== "guide/dem",
  }));
  const gallery = galleryOf(examples);
  assert.deepEqual(gallery.map(({ title, examples: own }) => [title, own.map(({ name }) => name)]), [
    ["Examples to begin with", ["kauai", "contours/volcano"]],
    ["From contours", ["contours/mesa"]],
    ["From the guide", ["guide/dem"]],
    ["Islands", ["styles"]],
  ]);
});
