// The views as a person uses them: they show the terrain, move with mouse, wheel and keys, and rest when nothing moves.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import type { Recipe } from "../src/api/types";
import { openBrowser, openPage, Server, until } from "./harness";

const recipe: Recipe = {
  seamount: 1, domain: { width_m: 12000, height_m: 12000, cell_m: 60 }, seed: 4,
  steps: [
    { id: "isle", op: "island.build", params: { peak_m: 900, floor_m: -800 } }, { id: "reef", op: "island.coral" },
  ],
};

let browser: Browser;
let server: Server;
let page: Page;
let errors: string[];

before(async () => {
  [browser, server] = await Promise.all([openBrowser(), Server.start(recipe)]);
  ({ page, errors } = await openPage(browser, server.address));
  await drawn();
});
after(async () => {
  await browser?.close();
  await server?.end();
});

async function drawn(): Promise<void> {
  await until(
    "both views are drawn", () => page.locator("[data-ground-view][data-key]").count().then((count) => count === 2), 60,
  );
  await atRest();
}

/** Counts pictures until there are no more for a while. */
async function atRest(): Promise<void> {
  await until("nothing is drawn any more", () => page.evaluate(async () => {
    let draws = 0;
    const before = CanvasRenderingContext2D.prototype.drawImage;
    CanvasRenderingContext2D.prototype.drawImage = function (this: CanvasRenderingContext2D, ...rest: unknown[]) {
      ++draws;
      return (before as (...all: unknown[]) => void).apply(this, rest);
    } as typeof before;
    await new Promise((done) => setTimeout(done, 900));
    CanvasRenderingContext2D.prototype.drawImage = before;
    return draws === 0;
  }), 60);
}

/** Mean colour of 8 x 8 parts of a view. */
async function picture(name: string): Promise<number[]> {
  await atRest();
  const png = await page.getByRole("region", { name, exact: true }).screenshot();
  return page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
    const to = new OffscreenCanvas(8, 8).getContext("2d")!;
    to.imageSmoothingQuality = "high";
    to.drawImage(bitmap, 0, 0, 8, 8);
    return [...to.getImageData(0, 0, 8, 8).data];
  }, [...png]);
}

function difference(a: number[], b: number[]): number {
  return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]!), 0) / a.length;
}

test("both views show the terrain", async () => {
  for (const name of ["3D view", "Map"]) {
    const colours = await picture(name);
    assert.ok(
      Math.max(...colours.filter((_, i) => i % 4 === 1)) - Math.min(...colours.filter((_, i) => i % 4 === 1)) > 20,
      name,
    );
  }
});

test("the middle button turns, the wheel comes nearer, Home shows all again", async () => {
  const view = page.getByRole("region", { name: "3D view", exact: true }), box = (await view.boundingBox())!;
  const first = await picture("3D view");
  await page.mouse.move(box.x + box.width * 0.45, box.y + box.height * 0.5);
  await page.mouse.down({ button: "middle" });
  await page.mouse.move(box.x + box.width * 0.7, box.y + box.height * 0.45, { steps: 5 });
  await page.mouse.up({ button: "middle" });
  const turned = await picture("3D view");
  assert.ok(difference(first, turned) > 0.8);
  await page.mouse.wheel(0, -700);
  assert.ok(difference(turned, await picture("3D view")) > 2);
  await page.keyboard.press("Home");
  assert.ok(difference(turned, await picture("3D view")) > 0.5);
});

test("keys alone move a view", async () => {
  const map = page.getByRole("region", { name: "Map", exact: true });
  const first = await picture("Map");
  await map.focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("+");
  assert.ok(difference(first, await picture("Map")) > 2);
});

async function choose(climate: string): Promise<number[]> {
  await page.getByRole("button", { name: "How the ground is shown" }).click();
  await page.getByLabel("Climate").selectOption(climate);
  if (process.env["LOOKS"]) await page.screenshot({ path: `${process.env["LOOKS"]}/climate_${climate}.png` });
  await page.keyboard.press("Escape");
  return picture("3D view");
}

test("a climate that is chosen colours the ground, and the place's own comes back", async () => {
  /** How much redder than green the ground is, where it is reddest. */
  const red = (colours: number[]): number =>
    Math.max(...colours.flatMap((r, i) => (i % 4 === 0 ? [r - colours[i + 1]!] : [])));
  const own = await picture("3D view"), arid = await choose("arid"), polar = await choose("polar");
  const tropical = await choose("tropical");
  assert.ok(red(arid) >= red(tropical) + 12, `${red(arid)} ${red(tropical)}`);
  assert.ok(difference(arid, polar) > 1 && difference(tropical, polar) > 1);
  assert.ok(difference(own, await choose("automatic")) < 0.3);
});

test("a climate that was chosen is there when the page is opened again", async () => {
  const again = async (): Promise<number[]> => {
    await page.reload();
    await drawn();
    return picture("3D view");
  };
  const own = await again(), arid = await choose("arid"), kept = await again();
  assert.ok(difference(own, kept) > 1, `${difference(own, kept)}`);
  assert.ok(difference(arid, kept) < 0.3, `${difference(arid, kept)}`);
  await choose("automatic");
});

test("without water one sees the sea's floor", async () => {
  const first = await picture("3D view");
  await page.getByRole("button", { name: "How the ground is shown" }).click();
  await page.getByRole("checkbox", { name: "Water" }).uncheck();
  await page.keyboard.press("Escape");
  assert.ok(difference(first, await picture("3D view")) > 5);
});

test("nothing went wrong on the page", () => assert.deepEqual(errors, []));
