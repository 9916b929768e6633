import assert from "node:assert/strict";
import { test } from "node:test";
import {
  cellOf, covers, frameOfWindow, gain, innerRectangle, sourceOf, windowOfMap, windowOfWorld, type Seen, type Source,
  type Window,
} from "./detail_window";
import type { Rectangle } from "./map_camera";

const source: Source = {
  key: "k", frame: { columns: 8192, rows: 8000, cell_m: 10, west: 0, north: 80000, crs: "" }, level: 2,
};
const most = 1280;

/** What a map of 600 by 500 pixels shows. */
function seen(x: number, y: number, pixel_m: number): Rectangle {
  return { west: x - 300 * pixel_m, east: x + 300 * pixel_m, south: y - 250 * pixel_m, north: y + 250 * pixel_m };
}

function mapAt(x: number, y: number, pixel_m: number, now: Window | null = null): Window | null {
  return windowOfMap(source, seen(x, y, pixel_m), pixel_m, most, now);
}

test("a source knows the level that is shown of it", () => {
  const shown = { key: "k", frame: { ...source.frame, columns: 2048, rows: 2000, cell_m: 40 } };
  assert.deepEqual(sourceOf(shown, source.frame), source);
});

test("the map needs no detail where its pixels are no finer than the cells that it has", () => {
  assert.equal(mapAt(40000, 40000, 40), null);
  assert.equal(windowOfMap({ ...source, level: 0 }, seen(40000, 40000, 1), 1, most, null), null);
  assert.equal(mapAt(-50000, 40000, 15), null, "beside the terrain");
});

test("cells of the map's detail are no larger than pixels where that can be had", () => {
  for (const [pixel_m, level] of [[28, 1], [20, 1], [19, 0], [10, 0], [0.3, 0]] as const) {
    const window = mapAt(40000, 40000, pixel_m)!;
    assert.equal(window.level, level, String(pixel_m));
    assert.ok(window.columns * window.rows <= most * most);
    assert.ok(covers(innerRectangle(source, window), seen(40000, 40000, pixel_m)));
  }
});

test("a large map has the finest level that fits", () => {
  const view = { west: 20000, east: 20000 + 1600 * 12, south: 20000, north: 20000 + 1000 * 12 };
  assert.equal(windowOfMap(source, view, 12, most, null)!.level, 1);
});

test("small moves keep the window, larger ones and finer pixels fetch another", () => {
  const first = mapAt(40000, 40000, 12)!;
  assert.equal(mapAt(40000 + 100 * 12, 40000 - 80 * 12, 12, first), first);
  assert.equal(mapAt(40000, 40000, 6, first), first);
  const aside = mapAt(40000 + 400 * 12, 40000, 12, first)!;
  assert.notEqual(aside, first);
  const coarser = mapAt(40000, 40000, 24)!;
  assert.equal(mapAt(40000, 40000, 12, coarser)!.level, 0);
  assert.equal(coarser.level, 1);
});

test("windows begin on a lattice, and nearby views have the same", () => {
  const a = mapAt(40000, 40000, 12)!, b = mapAt(40020, 40030, 12)!;
  assert.deepEqual(a, b);
  for (const cells of [a.x, a.y, a.columns, a.rows]) assert.equal(cells % 64, 0);
});

test("windows end with the terrain, and do not go over into coarse ground there", () => {
  const corner = mapAt(0, 80000, 5)!;
  assert.deepEqual([corner.x, corner.y], [0, 0]);
  assert.ok(covers(innerRectangle(source, corner), seen(0, 80000, 5)));
  const other = mapAt(81900, 20, 5)!;
  assert.deepEqual([other.x + other.columns, other.y + other.rows], [8192, 8000]);
});

test("the middle of a window's first cell is where the raster has it", () => {
  const frame = frameOfWindow(source, { level: 1, x: 64, y: 128, columns: 128, rows: 64 });
  assert.equal(frame.cell_m, 20);
  assert.equal(frame.west + 10, 64 * 20 + 5);
  assert.equal(frame.north - 10, 80000 - 128 * 20 - 5);
});

/** Ground before an eye at (x, y) that looks north: rows ever farther away. */
function before(x: number, y: number, near: number, far: number): Seen[] {
  const result: Seen[] = [];
  for (let row = 0; row < 12; ++row) {
    const distance = near * (far / near) ** (row / 11);
    for (let column = -3; column <= 3; ++column) {
      result.push({ x: x + 0.1 * column * distance, y: y + distance, pixel_m: 0.0012 * distance });
    }
  }
  return result;
}

test("the 3D view has detail where its ground is near, and none where it is far", () => {
  assert.equal(windowOfWorld(source, before(40000, -60000, 70000, 200000), most, null), null);
  const close = windowOfWorld(source, before(40000, 20000, 500, 3000), most, null)!;
  assert.equal(close.level, 0);
  const wide = windowOfWorld(source, before(40000, 5000, 17000, 32000), most, null)!;
  assert.equal(wide.level, 1);
  for (const { columns, rows } of [close, wide]) assert.ok(columns <= most && rows <= most);
});

test("where not all near ground fits, what is nearest is in the window", () => {
  const looked = before(40000, 20000, 300, 60000), window = windowOfWorld(source, looked, most, null)!;
  const inner = innerRectangle(source, window);
  assert.ok(looked[0]!.y > inner.south && looked[0]!.y < inner.north);
  assert.ok(cellOf(source, window.level) < 40 && gain(source, window, looked) > 0.3);
});

test("an eye that moves a little keeps its window", () => {
  const window = windowOfWorld(source, before(40000, 20000, 500, 3000), most, null)!;
  assert.equal(windowOfWorld(source, before(40200, 20100, 450, 3100), most, window), window);
  assert.notEqual(windowOfWorld(source, before(60000, 50000, 500, 3000), most, window), window);
});
