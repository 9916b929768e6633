// Ground below the sea that no sea reaches is land, in both views; the lagoon of an atoll is water.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { Recipe } from "../src/api/types";
import { Desk } from "./desk";
import { openBrowser, Server, until } from "./harness";

const cells = 192, cell_m = 50;
const recipe: Recipe = {
  seamount: 1, domain: { width_m: cells * cell_m, height_m: cells * cell_m, cell_m }, seed: 1,
  steps: [{ id: "low", op: "terrain.smooth", in: { terrain: { file: "low.asc" } } }],
};

/** A sea in the east with an atoll, land in the west with a valley that lies as low as the lagoon. */
function heights(): string {
  const row = (y: number): string => Array.from({ length: cells }, (_, x) => {
    const valley = Math.hypot((x - 45) / 24, (y - 96) / 60), reef = Math.hypot(x - 145, y - 70);
    if (valley < 1) return -40;
    if (reef < 24) return reef < 20 ? -40 : 2;
    return x < 96 ? 120 : -200;
  }).join(" ");
  return `ncols ${cells}\nnrows ${cells}\nxllcorner 0\nyllcorner 0\ncellsize ${cell_m}\n` +
    Array.from({ length: cells }, (_, y) => row(y)).join("\n");
}

let browser: Browser;
let desk: Desk;

before(async () => {
  browser = await openBrowser();
  const server = await Server.start(null);
  writeFileSync(join(server.folder, "work/low.asc"), heights());
  writeFileSync(join(server.folder, "work/test.json"), JSON.stringify(recipe));
  await server.kill();
  await server.run();
  desk = await Desk.on(browser, server);
  await desk.rest();
});
after(async () => {
  await browser?.close();
  await desk?.server.end();
});

type Colour = readonly [number, number, number];

/** Of a view's pixels. */
async function colours(name: "Map" | "3D view", places: readonly (readonly [number, number])[]): Promise<Colour[]> {
  const view = desk.page.getByRole("region", { name, exact: true }), box = (await view.boundingBox())!;
  const png = await view.screenshot();
  return desk.page.evaluate(async ([bytes, at, width]) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
    const to = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
    to.drawImage(bitmap, 0, 0);
    const scale = bitmap.width / width;
    return at.map(([x, y]) => {
      const [r, g, b] = to.getImageData(Math.round(x * scale), Math.round(y * scale), 1, 1).data;
      return [r!, g!, b!] as const;
    });
  }, [[...png], places, box.width] as const);
}

/** Where the map shows cells. */
async function mapPlaces(wanted: readonly (readonly [number, number])[]): Promise<[number, number][]> {
  const box = (await desk.page.getByRole("region", { name: "Map", exact: true }).boundingBox())!;
  const side = Math.min(box.width, box.height) - 56;
  return wanted.map(([x, y]) => [
    box.width / 2 + (x / cells - 0.5) * side, box.height / 2 + (y / cells - 0.5) * side,
  ]);
}

const isWater = ([r, , b]: Colour): boolean => b > r + 15;
const valley = [45, 96] as const, lagoon = [145, 70] as const, sea = [120, 120] as const, hill = [85, 20] as const;

test("the map tints a valley below the sea as land, a lagoon as water", async () => {
  const seen = await colours("Map", await mapPlaces([valley, lagoon, sea, hill]));
  assert.deepEqual(seen.map(isWater), [false, true, true, false], JSON.stringify(seen));
});

test("the height under the pointer is that of the valley's floor", async () => {
  const box = (await desk.page.getByRole("region", { name: "Map", exact: true }).boundingBox())!;
  const [[x, y]] = (await mapPlaces([valley])) as [[number, number]];
  await desk.page.mouse.move(box.x + x, box.y + y);
  await until("the height is shown", async () => {
    const texts = await desk.page.locator(".status-place .status-number").allInnerTexts();
    return texts.some((text) => /[-\u2212]40/.test(text));
  });
});

test("from above, the 3D view shows land there, and water in the lagoon", async () => {
  await desk.page.keyboard.press("v");
  await desk.rest();
  const view = desk.page.getByRole("region", { name: "3D view", exact: true }), box = (await view.boundingBox())!;
  // What is seen where: the page says which place is under the pointer.
  const found = new Map<string, [number, number]>();
  for (let row = 1; row < 24; ++row) {
    for (let column = 1; column < 24; ++column) {
      const at: [number, number] = [(column / 24) * box.width, (row / 24) * box.height];
      await desk.page.mouse.move(box.x + at[0], box.y + at[1]);
      const texts = await desk.page.locator(".status-place .status-number").allInnerTexts();
      const [x, y] = texts.map((text) => Number(text.replace("\u2212", "-").replace(/[^-\d.]/g, "")));
      for (const [name, [u, v], near] of [["valley", valley, 14], ["lagoon", lagoon, 12]] as const) {
        const [px, py] = [(x ?? 0) / cell_m, cells - (y ?? 0) / cell_m];
        if (texts.length > 1 && Math.hypot(px - u, py - v) < near) found.set(name, at);
      }
    }
  }
  assert.deepEqual([...found.keys()].sort(), ["lagoon", "valley"]);
  const seen = await colours("3D view", [found.get("valley")!, found.get("lagoon")!]);
  assert.deepEqual(seen.map(isWater), [false, true], JSON.stringify(seen));
});

test("nothing went wrong on the page", () => assert.deepEqual(desk.errors, []));
