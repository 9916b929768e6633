// Which part of a large raster is fetched finely, and how finely: near what is looked at. Pure.
import type { Frame } from "../api/types";
import { frameOfLevel } from "../document/results";
import type { Rectangle } from "./map_camera";

/** A raster as it is computed, of which the views have every 2^level-th cell. */
export interface Source {
  key: string;
  frame: Frame;
  level: number;
}

/** Of a raster that is there coarsely, and the frame that it is computed in. */
export function sourceOf(shown: { key: string; frame: Frame }, frame: Frame): Source {
  return { key: shown.key, frame, level: Math.round(Math.log2(shown.frame.cell_m / frame.cell_m)) };
}

/** A part of a level of the raster, in cells of that level. */
export interface Window {
  level: number;
  x: number;
  y: number;
  columns: number;
  rows: number;
}

export function sameWindow(a: Window, b: Window | null): boolean {
  return b !== null && a.level === b.level && a.x === b.x && a.y === b.y && a.columns === b.columns &&
    a.rows === b.rows;
}

/** A place that is looked at, and the size of a pixel there. */
export interface Seen {
  x: number;
  y: number;
  pixel_m: number;
}

/** Fine ground goes over into the coarse one within so many cells of that, at the window's border. */
const fadeCells = 10;
/** Windows begin and end at multiples of so many cells. */
const lattice = 64;
/** Of what is seen, on each side. */
const margins = [0.3, 0.12, 0.03];
/** A window stays as long as it shows nearly as much as the best one. */
const goodEnough = 0.8;
/** Less than this (levels gained, mean over the picture) is not worth a window. */
const leastGain = 0.02;

/** Of the border within which a window goes over into the coarse ground, in cells of its level. */
export function fadeOf(source: Source, level: number): number {
  return fadeCells * 2 ** (source.level - level);
}

export function cellOf(source: Source, level: number): number {
  return source.frame.cell_m * 2 ** level;
}

function sizeAt(source: Source, level: number): [number, number] {
  const { columns, rows } = source.frame;
  return [Math.max(1, Math.ceil(columns / 2 ** level)), Math.max(1, Math.ceil(rows / 2 ** level))];
}

export function frameOfWindow(source: Source, w: Window): Frame {
  const whole = frameOfLevel(source.frame, w.level, w.columns, w.rows);
  return { ...whole, west: whole.west + w.x * whole.cell_m, north: whole.north - w.y * whole.cell_m };
}

/** Which sides of a window are those of the raster: west, north, east, south. */
export function atEdge(source: Source, w: Window): [boolean, boolean, boolean, boolean] {
  const [columns, rows] = sizeAt(source, w.level);
  return [w.x === 0, w.y === 0, w.x + w.columns >= columns, w.y + w.rows >= rows];
}

/** Where a window alone is seen, not on the way to the coarse ground. */
export function innerRectangle(source: Source, w: Window): Rectangle {
  const { west, north, cell_m } = frameOfWindow(source, w), fade = fadeOf(source, w.level) * cell_m;
  const [left, top, right, bottom] = atEdge(source, w);
  return {
    west: left ? -Infinity : west + fade, north: top ? Infinity : north - fade,
    east: right ? Infinity : west + w.columns * cell_m - fade,
    south: bottom ? -Infinity : north - w.rows * cell_m + fade,
  };
}

export function covers(outer: Rectangle, inner: Rectangle): boolean {
  return outer.west <= inner.west && outer.east >= inner.east && outer.south <= inner.south &&
    outer.north >= inner.north;
}

/** The smallest window that shows a rectangle; null: that lies beside the raster. */
export function windowAround(source: Source, level: number, r: Rectangle): Window | null {
  const { west, north, cell_m } = frameOfLevel(source.frame, level, 1, 1), fade = fadeOf(source, level);
  const [columns, rows] = sizeAt(source, level);
  const within = (cells: number, size: number): number => Math.max(0, Math.min(size, cells));
  const low = (cells: number, size: number): number => within(lattice * Math.floor((cells - fade) / lattice), size);
  const high = (cells: number, size: number): number => within(lattice * Math.ceil((cells + fade) / lattice), size);
  const x = low((r.west - west) / cell_m, columns), y = low((north - r.north) / cell_m, rows);
  const across = high((r.east - west) / cell_m, columns) - x, down = high((north - r.south) / cell_m, rows) - y;
  return across < 2 || down < 2 ? null : { level, x, y, columns: across, rows: down };
}

/** What the map needs at `pixel_m` metres a pixel, of at most `most` x `most` cells; `now`, where that will do. */
export function windowOfMap(
  source: Source, view: Rectangle, pixel_m: number, most: number, now: Window | null,
): Window | null {
  if (source.level === 0 || pixel_m >= cellOf(source, source.level)) return null;
  const wanted = Math.max(0, Math.min(source.level - 1, Math.floor(Math.log2(pixel_m / source.frame.cell_m) + 1e-9)));
  for (let level = wanted; level < source.level; ++level) {
    if (now !== null && now.level <= level && now.level >= level - 1 && covers(innerRectangle(source, now), view)) {
      return now;
    }
    for (const margin of margins) {
      const across = margin * (view.east - view.west), down = margin * (view.north - view.south);
      const grown = {
        west: view.west - across, east: view.east + across, south: view.south - down, north: view.north + down,
      };
      const window = windowAround(source, level, grown);
      if (window === null) return null;
      if (window.columns * window.rows <= most * most) return window;
    }
  }
  return null;
}

/** Levels that a window makes finer what is seen, mean over the picture. */
export function gain(source: Source, w: Window, seen: readonly Seen[]): number {
  const inner = innerRectangle(source, w), cell = cellOf(source, w.level), coarse = cellOf(source, source.level);
  let sum = 0;
  for (const { x, y, pixel_m } of seen) {
    if (x < inner.west || x > inner.east || y < inner.south || y > inner.north) continue;
    sum += Math.max(0, Math.log2(coarse / Math.max(cell, pixel_m)));
  }
  return sum / Math.max(1, seen.length);
}

/** What shows most of the ground before an eye more finely, of at most `most` x `most` cells; `now`, where that will
 * do. */
export function windowOfWorld(source: Source, seen: readonly Seen[], most: number, now: Window | null): Window | null {
  const near = seen.filter((s) => s.pixel_m < cellOf(source, source.level) && insideOf(source, s));
  if (source.level === 0 || near.length === 0) return null;
  const first = near.reduce((a, b) => (b.pixel_m < a.pixel_m ? b : a));
  let best: Window | null = null, bestGain = leastGain;
  for (let level = 0; level < source.level; ++level) {
    const reach = 0.5 * (most - 2 * fadeOf(source, level) - lattice) * cellOf(source, level);
    const window = windowAround(source, level, boxOf(near, first, reach));
    if (window === null) continue;
    const gained = gain(source, window, seen);
    if (gained <= 1.02 * bestGain) continue;
    [best, bestGain] = [window, gained];
  }
  return now !== null && best !== null && gain(source, now, seen) >= goodEnough * bestGain ? now : best;
}

function insideOf(source: Source, { x, y }: Seen): boolean {
  const { west, north, columns, rows, cell_m } = source.frame;
  return x >= west && x <= west + columns * cell_m && y <= north && y >= north - rows * cell_m;
}

/** Around all that is near, or, where that is too wide, from what is nearest towards the rest. */
function boxOf(near: readonly Seen[], first: Seen, reach: number): Rectangle {
  const span = (of: (s: Seen) => number): [number, number] => {
    const low = Math.min(...near.map(of)), high = Math.max(...near.map(of)), spare = 0.1 * (high - low);
    if (high - low + 2 * spare <= 2 * reach) return [low - spare, high + spare];
    const mean = near.reduce((sum, s) => sum + of(s), 0) / near.length;
    const middle = of(first) + Math.min(0.8 * reach, Math.max(-0.8 * reach, mean - of(first)));
    return [middle - reach, middle + reach];
  };
  const [west, east] = span((s) => s.x), [south, north] = span((s) => s.y);
  return { west, east, south, north };
}
