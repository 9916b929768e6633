import assert from "node:assert/strict";
import { test } from "node:test";
import { layOut } from "./layout";

const nodes = (ids: string) => ids.split(" ").map((id) => ({ id, width: 100, height: 40 }));
const wires = (text: string) => text.split(" ").filter(Boolean).map((pair) => {
  const [from = "", to = ""] = pair.split(">");
  return { from, to };
});
const options = { columnGap: 50, rowGap: 20 };

test("a chain lies on a line", () => {
  const { places, width, height } = layOut(nodes("a b c"), wires("a>b b>c"), options);
  assert.deepEqual([...places.values()].map(({ x, y }) => [x, y]), [[0, 0], [150, 0], [300, 0]]);
  assert.equal(width, 400);
  assert.equal(height, 40);
});

test("readers lie right of what they read, and nothing overlaps", () => {
  const graph = "a>b a>c b>d c>d a>d d>e c>f g>f";
  const { places } = layOut(nodes("a b c d e f g"), wires(graph), options);
  for (const { from, to } of wires(graph)) assert.ok(places.get(from)!.x < places.get(to)!.x, `${from} ${to}`);
  const all = [...places.values()];
  for (const [i, a] of all.entries())
    for (const b of all.slice(i + 1)) assert.ok(a.x !== b.x || Math.abs(a.y - b.y) >= 60);
});

test("a source lies just before its reader", () => {
  const { places } = layOut(nodes("a b c mask d"), wires("a>b b>c c>d mask>d"), options);
  assert.equal(places.get("mask")!.layer, 2);
});

test("wires do not cross where they need not", () => {
  const { places } = layOut(nodes("a b x y"), wires("a>y b>x"), options);
  assert.equal(places.get("a")!.y < places.get("b")!.y, places.get("y")!.y < places.get("x")!.y);
});

test("nothing, and what is no recipe", () => {
  assert.deepEqual(layOut([], [], options), { places: new Map(), crossings: new Map(), width: 0, height: 0 });
  assert.equal(layOut(nodes("a b"), wires("a>b b>a a>a q>a"), options).places.size, 2);
});

test("a long wire passes beside what lies between", () => {
  const { places, crossings } = layOut(nodes("a b c"), wires("a>b b>c a>c"), options);
  assert.equal(places.size, 3);
  const [crossing] = crossings.get("a>c")!;
  const { x, y } = places.get("b")!;
  assert.deepEqual([crossing!.left, crossing!.right], [x, x + 100]);
  assert.ok(crossing!.y < y || crossing!.y > y + 40);
});
