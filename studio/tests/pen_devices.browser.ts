// Fingers, clicks and typed heights over the map of the real page; what they leave in the recipe is asked of the
// server.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, CDPSession, Page } from "playwright-core";
import type { Json, Recipe } from "../src/api/types";
import { openBrowser, openPage, Server, until } from "./harness";

type Place = readonly [number, number];

const recipe: Recipe = {
  seamount: 1,
  domain: { width_m: 24000, height_m: 24000, cell_m: 240 },
  seed: 7,
  steps: [
    { id: "isle", op: "island.build", params: { peak_m: 1100 } },
    { id: "wind", op: "island.wind", in: "isle" },
    { id: "reef", op: "island.coral", in: "wind", params: { subsidence: 0.2 } },
  ],
  outputs: [{ from: "reef.terrain", path: "height.tif" }],
};

let browser: Browser;
let server: Server;
let page: Page;
let pen: CDPSession;
let toScreen: (place: Place) => Place;

/** Where places of the ground are on the screen, from what the status line says of two places of the map. */
async function measureMap(): Promise<(place: Place) => Place> {
  const box = (await page.getByRole("region", { name: "Map" }).boundingBox())!;
  const read = async (x: number, y: number) => {
    await page.mouse.move(x, y);
    return until("the place under the pointer is said", async () => {
      const words = /x\s*([^\n]+)\s+y\s*([^\n]+)/.exec(await page.locator(".status-place").innerText());
      const number = (text: string) => Number(text.replace("−", "-").replace(/[^\d.-]/g, ""));
      return words ? { x, y, ground: [number(words[1]!), number(words[2]!)] as const } : null;
    });
  };
  const a = await read(box.x + 0.3 * box.width, box.y + 0.3 * box.height);
  const b = await read(box.x + 0.6 * box.width, box.y + 0.55 * box.height);
  assert.notEqual(a.ground[0], b.ground[0]);
  return ([x, y]) => [
    a.x + ((x - a.ground[0]) * (b.x - a.x)) / (b.ground[0] - a.ground[0]),
    a.y + ((y - a.ground[1]) * (b.y - a.y)) / (b.ground[1] - a.ground[1]),
  ];
}

before(async () => {
  [browser, server] = await Promise.all([openBrowser(), Server.start(recipe)]);
  ({ page } = await openPage(browser, server.address, { touch: true }));
  pen = await page.context().newCDPSession(page);
  await until("a result is drawn", () => page.locator("[data-key]").count().then((count) => count > 0));
  await page.keyboard.press("Escape");
  await page.keyboard.press("v");
  await until(
    "the map is large", async () => ((await page.getByRole("region", { name: "Map" }).boundingBox())?.width ?? 0) > 400,
  );
  toScreen = await measureMap();
});
after(async () => {
  await browser?.close();
  await server?.end();
});

const params = async (id: string) => (
  (await server.document()).recipe.steps.find((step) => step.id === id)?.params ?? {}
) as { [name: string]: Json };
const items = async (id: string, list: string) => ((await params(id))[list] ?? []) as { [name: string]: Json }[];
const select = (id: string) => page.locator(".step-select").filter({ hasText: id }).first().click();
const done = async () => {
  const { history, done: count } = await server.document();
  return history.slice(0, count).map((entry) => entry.label);
};
const wave = (y: number): Place[] => Array.from(
  { length: 18 }, (_, i) => [-7000 + 800 * i, y + 1200 * Math.sin(i / 3)],
);

async function drag(places: readonly Place[]): Promise<void> {
  await page.mouse.move(...toScreen(places[0]!));
  await page.mouse.down();
  for (const place of places.slice(1)) await page.mouse.move(...toScreen(place), { steps: 2 });
  await page.mouse.up();
}

async function fingers(places: readonly Place[], second?: Place): Promise<void> {
  const points = (all: readonly Place[]) => all.map(
    (place, id) => ({ x: toScreen(place)[0], y: toScreen(place)[1], id }),
  );
  await pen.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: points([places[0]!]) });
  for (const place of places.slice(1)) await pen.send(
    "Input.dispatchTouchEvent", { type: "touchMove", touchPoints: points([place]) },
  );
  if (second) await pen.send(
    "Input.dispatchTouchEvent", { type: "touchStart", touchPoints: points([places[places.length - 1]!, second]) },
  );
  await pen.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}

test("a finger draws wind, and a second finger takes it back", async () => {
  await select("wind");
  await page.keyboard.press("w");
  await fingers(wave(-3000));
  await until("the stroke is in the recipe", async () => (await items("wind", "strokes")).length === 1);
  await fingers(wave(4000), [0, 0]);
  await until("the second stroke is gone", async () => (await done()).length === 1);
  assert.equal((await items("wind", "strokes")).length, 1);
});

test("a summit is set by a click, its height by digits", async () => {
  await select("isle");
  await page.keyboard.press("h");
  await page.mouse.click(...toScreen([-1500, 900]));
  for (const key of ["8", "1", "2", "Enter"]) await page.keyboard.press(key);
  await until("the summit has its height", async () => (await items("isle", "summits"))[0]?.["height_m"] === 812);
});

test("an area is drawn around, and a corner moved", async () => {
  await page.keyboard.press("o");
  for (
    const place of [[-6000, -5000], [6000, -5000], [5000, 6000], [-6000, 5000]] as const
  ) await page.mouse.click(...toScreen(place));
  await page.keyboard.press("Enter");
  const corners = async () => ((await params("isle"))["areas"] as Place[][] | undefined)?.[0] ?? [];
  await until("the coast is in the recipe", async () => (await corners()).length === 4);
  await page.keyboard.press("q");
  await drag([[-6000, 5000], [-7000, 5500], [-8000, 6000]]);
  await until("the corner has moved", async () => (await corners()).some(([x]) => x < -7500));
});
