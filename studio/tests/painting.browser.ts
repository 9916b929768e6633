// What is painted rather than typed: how much ground lies at each height, where growth runs ahead, where a step works,
// and regions of an island.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { Json, Recipe, Step } from "../src/api/types";
import { Desk } from "./desk";
import { openBrowser, until } from "./harness";

let browser: Browser;

before(async () => {
  browser = await openBrowser();
});
after(async () => {
  await browser?.close();
});

const domain = { width_m: 12000, height_m: 12000, cell_m: 60 };
const ring = [[-4000, -3500], [3500, -4200], [4600, 1000], [1500, 4500], [-3800, 3000]];
const range: Recipe = {
  seamount: 1, domain, seed: 5,
  steps: [
    { id: "grown", op: "contour.grow", params: { particles: 6000, outlines: [{ name: "land", height_m: 0, ring }] as Json } },
    { id: "high", op: "contour.heights", params: { max_m: 1800 } },
    { id: "land", op: "contour.reconstruct", in: { tin: "high.tin" } },
  ],
};
const isle: Step = { id: "isle", op: "island.build", params: { areas: [ring] as Json, peak_m: 800 } };

const stepOf = (recipe: Recipe, id: string): Step => recipe.steps.find((step) => step.id === id)!;

/** The step that a tool of the menu has added, and the source that it is for its reader. */
async function more(desk: Desk, name: RegExp): Promise<void> {
  await desk.tool("More tools");
  await desk.page.getByRole("menuitem", { name }).click();
}

test("a distribution of heights is painted as bars", async () => {
  const desk = await Desk.open(browser, range);
  await desk.select("high");
  await desk.page.getByRole("button", { name: /^Paint histogram/ }).click();
  const bars = desk.page.locator(".histogram-bars");
  await bars.waitFor();
  await bars.scrollIntoViewIfNeeded();
  const box = (await bars.boundingBox())!;
  const painted = await desk.changes("a plateau", async () => {
    const { mouse } = desk.page;
    await mouse.move(box.x + 4, box.y + 0.9 * box.height);
    await mouse.down();
    await mouse.move(box.x + 0.6 * box.width, box.y + 0.9 * box.height, { steps: 10 });
    await mouse.move(box.x + 0.8 * box.width, box.y + 0.1 * box.height, { steps: 5 });
    await mouse.move(box.x + box.width - 4, box.y + 0.1 * box.height, { steps: 5 });
    await mouse.up();
  });
  const heights = stepOf(painted, "high").params!["histogram"] as number[];
  assert.equal(heights.length, 16);
  assert.ok(heights[2]! < 0.3 && heights.at(-1)! > 0.7, String(heights));
  await desk.look("histogram");
  await desk.close();
});

test("where growth runs ahead is painted, in a step before the network", async () => {
  const desk = await Desk.open(browser, range);
  await desk.select("grown");
  await more(desk, /Paint the probability/);
  const painted = await desk.changes("a valley", () => desk.drag([0.3, 0.7], [0.45, 0.55], [0.6, 0.4]));
  const paint = painted.steps.find(({ op }) => op === "terrain.paint")!;
  assert.equal((stepOf(painted, "grown").in as { [port: string]: Json })["probability"], `${paint.id}.values`);
  assert.equal(paint.params!["base"], 0.5, "elsewhere it is even");
  await desk.look("probability");
  await desk.close();
});

test("a mask is painted for a step, goes on in the same step, and is erased", async () => {
  const desk = await Desk.open(browser, {
    seamount: 1, domain, seed: 3,
    steps: [isle, { id: "worn", op: "erosion.run", in: { terrain: "isle.terrain" }, params: { years: 2000 } }],
  });
  await desk.select("worn");
  await more(desk, /Paint the mask/);
  const first = await desk.changes("a mask", () => desk.drag([0.45, 0.5], [0.55, 0.45]), false);
  const paint = first.steps.find(({ op }) => op === "terrain.paint")!;
  assert.equal((stepOf(first, "worn").in as { [port: string]: Json })["mask"], `${paint.id}.values`);
  await desk.select(paint.id);
  await desk.tool(/^Paint$|^Paint \(/);
  await desk.page.keyboard.down("Control");
  const { revision } = await desk.server.document();
  await desk.drag([0.5, 0.42], [0.5, 0.55]);
  await desk.page.keyboard.up("Control");
  await until("it is erased", async () => (await desk.server.document()).revision > revision);
  const strokes = (await desk.params(paint.id))["strokes"] as { tool: string }[];
  assert.deepEqual(strokes.map(({ tool }) => tool), ["brush", "erase"]);
  await desk.look("mask");
  await desk.close();
});

test("a region is painted with the brush and by its outline; its colour is chosen by a key", async () => {
  const desk = await Desk.open(browser, { seamount: 1, domain, seed: 3, steps: [isle, { id: "reef", op: "island.coral" }] });
  await desk.select("reef");
  await more(desk, /Paint regions/);
  const bar = desk.page.getByRole("toolbar", { name: /^Options/ });
  await bar.getByRole("radio", { name: /lagoon/i }).click();
  const painted = await desk.changes("a lagoon", () => desk.drag([0.45, 0.5], [0.55, 0.5]), false);
  const paint = painted.steps.find(({ op }) => op === "classify.paint")!;
  assert.equal((paint.params!["strokes"] as { region: string }[])[0]!.region, "lagoon");
  await desk.select(paint.id);
  await desk.tool(/Region by its outline/);
  await desk.page.keyboard.press("1");
  await until("the mountain is chosen", async () => (await bar.getByRole("radio", { name: /mountain/i }).getAttribute("aria-checked")) === "true");
  const area = await (async () => {
    const { revision } = await desk.server.document();
    await desk.drag([0.46, 0.46], [0.54, 0.46], [0.54, 0.53], [0.46, 0.53], [0.46, 0.465]);
    return until("an area", async () => {
      const now = await desk.server.document();
      return now.revision > revision && now.recipe;
    });
  })();
  const strokes = stepOf(area, paint.id).params!["strokes"] as { tool: string; region?: string }[];
  assert.equal(strokes.at(-1)!.tool, "area");
  assert.equal(strokes.at(-1)!.region ?? "mountain", "mountain");
  await desk.look("regions");
  await desk.close();
});
