// A terrain of more cells than a page is sent as a whole: near what is looked at it has all of them.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { Recipe } from "../src/api/types";
import { Desk } from "./desk";
import { openBrowser, until } from "./harness";

const cells = 4096, cell_m = 10;
const recipe: Recipe = {
  seamount: 1, domain: { width_m: cells * cell_m, height_m: cells * cell_m, cell_m }, seed: 4,
  steps: [
    { id: "hills", op: "terrain.noise",
      params: { kind: "ridged", height_m: 1600, wavelength_m: 12000, octaves: 12, gain: 0.6, base_m: -500 } },
    { id: "shape", op: "terrain.sculpt" },
    { id: "stripes", op: "terrain.mask", params: { criteria: [{ tool: "noise", wavelength_m: 400 }] } },
  ],
};

let browser: Browser;
let desk: Desk;
/** Windows that were asked for. */
let asked: string[] = [];
let refused = false;

before(async () => {
  browser = await openBrowser();
  desk = await Desk.open(browser, recipe);
  await desk.page.route(/raster\?level=\d+&x=/, (route) => {
    asked.push(route.request().url());
    return refused ? route.abort() : route.continue();
  });
  await desk.select("shape");
  await desk.rest();
});
after(async () => {
  await browser?.close();
  await desk?.server.end();
});

const view = (name: "Map" | "3D view") => desk.page.getByRole("region", { name, exact: true });
const detailOf = (name: "Map" | "3D view") => view(name).getAttribute("data-detail-cell");

async function zoomIn(times: number, at: [number, number]): Promise<void> {
  await desk.page.mouse.move(...at);
  for (let i = 0; i < times; ++i) await desk.page.mouse.wheel(0, -240);
}

async function pan(right_px: number): Promise<void> {
  const [x, y] = await desk.place(0.5, 0.5), { mouse } = desk.page;
  await mouse.move(x, y);
  await mouse.down({ button: "middle" });
  await mouse.move(x + right_px, y, { steps: 4 });
  await mouse.up({ button: "middle" });
}

interface Look { colours: number[]; contrast: number }

/** Mean colours of 6 x 6 parts of the middle of the map, and how much neighbouring pixels differ. */
async function look(): Promise<Look> {
  const png = await view("Map").screenshot();
  return desk.page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
    const read = (size: number): Uint8ClampedArray => {
      const to = new OffscreenCanvas(size, size).getContext("2d")!;
      to.imageSmoothingQuality = "high";
      to.drawImage(bitmap, 120, 80, 360, 360, 0, 0, size, size);
      return to.getImageData(0, 0, size, size).data;
    };
    const fine = read(360);
    let contrast = 0;
    for (let i = 4; i + 4 < fine.length; i += 4) contrast += Math.abs(2 * fine[i + 1]! - fine[i - 3]! - fine[i + 5]!);
    return { colours: [...read(6)], contrast: contrast / (fine.length / 4) };
  }, [...png]);
}

/** Heights that the status line shows at places of the map, beside the true ones: mean difference. */
async function heightError(): Promise<number> {
  const key = (await desk.key())!;
  let sum = 0;
  for (let k = 0; k < 10; ++k) {
    await desk.page.mouse.move(...(await desk.place(0.2 + 0.05 * k, 0.3 + 0.03 * k)));
    const texts = await desk.page.locator(".status-place .status-number").allInnerTexts();
    const number = (text: string): number => Number(text.replace("\u2212", "-").replace(/[^-\d.]/g, ""));
    const [x, y, height] = texts.slice(0, 3).map(number) as [number, number, number];
    const u = x / cell_m + cells / 2 - 0.5, v = cells / 2 - y / cell_m - 0.5;  // the terrain lies around (0, 0)
    const part = `x=${Math.floor(u)}&y=${Math.floor(v)}&columns=2&rows=2`;
    const answer = await desk.server.request("GET", `/api/values/${key}/raster?${part}`);
    const [a, b, c, d] = new Float32Array(await answer.arrayBuffer()) as unknown as [number, number, number, number];
    const s = u - Math.floor(u), t = v - Math.floor(v);
    sum += Math.abs(height - ((1 - t) * (a + s * (b - a)) + t * (c + s * (d - c))));
  }
  return sum / 10;
}

test("zoomed in, the map has all cells: finer forms in the same colours, and their heights", async () => {
  assert.equal(await detailOf("Map"), null, "the whole is shown coarsely");
  refused = true;
  await zoomIn(7, await desk.place(0.45, 0.45));
  await desk.rest();
  assert.ok(asked.length > 0, "a window is asked for");
  const [coarse, coarseError] = [await look(), await heightError()];
  refused = false;
  await pan(1);
  await until("detail is drawn", async () => (await detailOf("Map")) === String(cell_m));
  await desk.rest();
  const [fine, fineError] = [await look(), await heightError()];
  const contrasts = `contrast ${coarse.contrast.toFixed(2)} -> ${fine.contrast.toFixed(2)}`;
  console.log(`${contrasts}, error of heights ${coarseError.toFixed(2)} -> ${fineError.toFixed(2)} m`);
  assert.ok(fine.contrast > 1.15 * coarse.contrast);
  assert.ok(Math.max(...fine.colours.map((c, i) => Math.abs(c - coarse.colours[i]!))) < 14);
  assert.ok(fineError < 0.5 * coarseError && fineError < 0.5);
});

test("a small move fetches nothing, a large one what comes into view, and a view at rest nothing", async () => {
  asked = [];
  await pan(-40);
  await desk.rest();
  assert.deepEqual(asked, []);
  await pan(-500);
  await until("more is fetched", async () => asked.length > 0);
  await desk.rest();
  assert.equal(await detailOf("Map"), String(cell_m));
  const count = asked.length;
  await desk.page.waitForTimeout(1500);
  assert.equal(asked.length, count);
});

test("detail follows a stroke once it is drawn", async () => {
  const key = await desk.key();
  await desk.tool(/raise/i);
  const { mouse } = desk.page;
  await mouse.move(...(await desk.place(0.45, 0.45)));
  await mouse.down();
  asked = [];
  for (let i = 0; i < 8; ++i) {
    await mouse.move(...(await desk.place(0.45 + 0.01 * i, 0.45)));
    await desk.page.waitForTimeout(120);
  }
  assert.deepEqual(asked, [], "nothing is fetched while the stroke is drawn");
  await mouse.up();
  await until("another terrain is seen", async () => {
    return (await desk.key()) !== key && (await view("Map").getAttribute("data-coarse")) === "false";
  });
  await until("its detail is drawn", async () => asked.length > 0 && (await detailOf("Map")) === String(cell_m));
  await desk.rest();
  const newest = (await view("Map").getAttribute("data-key"))!;
  assert.equal(await detailOf("Map"), String(cell_m));
  assert.ok((asked as string[]).at(-1)!.includes(newest), "of the newest result");
});

test("the 3D view has all cells near the eye, none far away", async () => {
  await desk.page.keyboard.press("v");
  await desk.page.waitForTimeout(300);
  assert.equal(await detailOf("3D view"), null);
  const box = (await view("3D view").boundingBox())!;
  await zoomIn(14, [box.x + 0.5 * box.width, box.y + 0.6 * box.height]);
  await until("detail is drawn", async () => (await detailOf("3D view")) === String(cell_m));
  await view("3D view").focus();
  await desk.page.keyboard.press("Home");
  await until("none is any more", async () => (await detailOf("3D view")) === null);
});

test("detail is there again after the graphics processor has lost what it held", async () => {
  await desk.page.addInitScript(() => {
    const before = OffscreenCanvas.prototype.getContext as (...all: unknown[]) => RenderingContext | null;
    OffscreenCanvas.prototype.getContext = function (this: OffscreenCanvas, ...all: unknown[]) {
      const context = before.apply(this, all);
      if (String(all[0]).startsWith("webgl")) (window as unknown as { drawing: unknown }).drawing = context;
      return context;
    } as typeof OffscreenCanvas.prototype.getContext;
  });
  await desk.page.reload();
  await desk.page.locator("[data-key]").first().waitFor();
  await desk.page.keyboard.press("v");
  await desk.rest();
  await zoomIn(7, await desk.place(0.45, 0.45));
  await until("detail is drawn", async () => (await detailOf("Map")) === String(cell_m));
  await desk.rest();
  const first = await look();
  await desk.page.evaluate(async () => {
    const lost = (window as unknown as { drawing: WebGL2RenderingContext }).drawing.getExtension("WEBGL_lose_context")!;
    lost.loseContext();
    await new Promise((done) => setTimeout(done, 300));
    lost.restoreContext();
  });
  await desk.rest();
  await pan(1);
  await desk.rest();
  const again = await look();
  assert.equal(await detailOf("Map"), String(cell_m));
  assert.ok(Math.abs(again.contrast - first.contrast) < 0.1 * first.contrast);
  assert.ok(Math.max(...again.colours.map((c, i) => Math.abs(c - first.colours[i]!))) < 6);
});

test("a mask that is laid over the ground is as fine as the ground", async () => {
  const overlayOf = () => view("Map").getAttribute("data-overlay-cell");
  assert.equal(await overlayOf(), null);
  refused = true;  // of the mask, too: the ground's window is there
  await desk.select("stripes");
  await until("the mask is seen", async () => (await desk.page.locator(".view-legend").count()) > 0);
  await desk.rest();
  const coarse = await look();
  refused = false;
  await pan(-500);
  await until("it is fine", async () => (await overlayOf()) === String(cell_m));
  await pan(500);
  await desk.rest();
  const fine = await look();
  if (process.env["LOOKS"]) await desk.page.screenshot({ path: `${process.env["LOOKS"]}/fine_mask.png` });
  assert.ok(Math.max(...fine.colours.map((c, i) => Math.abs(c - coarse.colours[i]!))) < 20);
  assert.ok(fine.contrast > coarse.contrast, `${coarse.contrast} -> ${fine.contrast}`);
});

test("nothing went wrong on the page", () => assert.deepEqual(desk.errors, []));
