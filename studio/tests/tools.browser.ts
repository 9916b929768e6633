// Pens as a person uses them: what is drawn on the map is in the recipe, the terrain is another, undo takes it back.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, CDPSession } from "playwright-core";
import type { Json, Recipe, Step } from "../src/api/types";
import { Desk } from "./desk";
import { openBrowser, openPage, until } from "./harness";

let browser: Browser;

before(async () => {
  browser = await openBrowser();
});
after(async () => {
  await browser?.close();
});

const domain = { width_m: 10240, height_m: 10240, cell_m: 40 };
const coast = [[-3000, -2000], [2500, -2600], [3000, 1500], [0, 3000], [-2800, 1800]];

/** An island with everything that draws behind it. */
function recipe(...steps: Step[]): Recipe {
  return { seamount: 1, domain, seed: 3, steps };
}
const isle: Step = { id: "isle", op: "island.build", params: { areas: [coast] as Json, peak_m: 800 } };

const stepOf = (document: Recipe, id: string): Step => document.steps.find((step) => step.id === id)!;

test("wind is drawn as a stroke", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "wind", op: "island.wind" }));
  await desk.select("wind");
  await desk.tool(/wind/i);
  const after = await desk.changes("wind", () => desk.drag([0.3, 0.4], [0.5, 0.5], [0.7, 0.45]));
  const [stroke] = stepOf(after, "wind").params!["strokes"] as { points: [number, number][] }[];
  assert.ok(stroke!.points.length >= 3 && stroke!.points.length <= 60);
  assert.ok(stroke!.points[0]![0] < stroke!.points.at(-1)![0]);
  await desk.close();
});

test("ridges and rivers are drawn into a sketch", async () => {
  const desk = await Desk.open(browser, recipe({ id: "sketch", op: "learned.sketch",
    params: { ridges: [{ points: [[-3000, 0], [3000, 500]] }], heights: [{ x_m: 0, y_m: 200, height_m: 1500 }] } }));
  await desk.select("sketch");
  await desk.tool(/ridge/i);
  const ridges = await desk.changes("ridge", () => desk.drag([0.4, 0.3], [0.5, 0.4], [0.6, 0.3]));
  assert.equal((stepOf(ridges, "sketch").params!["ridges"] as Json[]).length, 2);
  await desk.tool(/river/i);
  const rivers = await desk.changes("river", () => desk.drag([0.4, 0.7], [0.6, 0.75]));
  assert.equal((stepOf(rivers, "sketch").params!["rivers"] as Json[]).length, 1);
  await desk.close();
});

test("ground is raised with a brush, in a step that comes for it", async () => {
  const desk = await Desk.open(browser, recipe(isle));
  await desk.select("isle");
  await desk.tool("More tools");
  await desk.page.getByRole("menuitem", { name: /sculpt/i }).first().click();
  const after = await desk.changes("sculpting", () => desk.drag([0.45, 0.5], [0.55, 0.5]));
  const added = after.steps.at(-1)!;
  assert.equal(added.op, "terrain.sculpt");
  const [stroke] = added.params!["strokes"] as { tool: string; points: Json[] }[];
  assert.equal(stroke!.tool, "raise");
  await desk.close();
});

test("a pen's pressure is in its stroke", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "shape", op: "terrain.sculpt" }));
  await desk.select("shape");
  await desk.tool(/raise/i);
  const devtools: CDPSession = await desk.page.context().newCDPSession(desk.page);
  const send = async (type: string, x: number, y: number, force: number) => {
    const [px, py] = await desk.place(x, y);
    await devtools.send("Input.dispatchMouseEvent", {
      type: type as "mousePressed", x: px, y: py, button: "left", buttons: type === "mouseReleased" ? 0 : 1,
      pointerType: "pen", force, clickCount: 1,
    });
  };
  const after = await desk.changes("a pen stroke", async () => {
    await send("mousePressed", 0.4, 0.5, 0.1);
    for (let i = 1; i <= 20; ++i) await send("mouseMoved", 0.4 + 0.01 * i, 0.5 + 0.004 * Math.sin(i), 0.1 + 0.04 * i);
    await send("mouseReleased", 0.6, 0.5, 0);
  });
  const [stroke] = stepOf(after, "shape").params!["strokes"] as { pressure?: number[]; points: Json[] }[];
  assert.equal(stroke!.pressure?.length, stroke!.points.length);
  assert.ok(stroke!.pressure![0]! < 0.3 && stroke!.pressure!.at(-1)! > 0.6, String(stroke!.pressure));
  await desk.close();
});

test("a coast's point is dragged, a summit is placed", async () => {
  const desk = await Desk.open(browser, recipe(isle));
  await desk.select("isle");
  await desk.tool(/summit/i);
  const after = await desk.changes("a summit", async () => {
    await desk.page.mouse.click(...(await desk.place(0.5, 0.5)));
  });
  assert.equal((stepOf(after, "isle").params!["summits"] as Json[]).length, 1);
  await desk.close();
});

test("Escape leaves nothing of a stroke", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "wind", op: "island.wind" }));
  await desk.select("wind");
  await desk.tool(/wind/i);
  const before = await desk.server.document();
  const { mouse } = desk.page;
  await mouse.move(...(await desk.place(0.3, 0.4)));
  await mouse.down();
  await mouse.move(...(await desk.place(0.6, 0.5)), { steps: 10 });
  await desk.page.keyboard.press("Escape");
  await mouse.up();
  await desk.page.waitForTimeout(500);
  const after = await desk.server.document();
  assert.deepEqual(after.recipe, before.recipe);
  assert.equal(after.done, before.done);
  await desk.close();
});

test("a slider is dragged: coarse results follow, the full one comes last, the history has one entry", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "reef", op: "island.coral" }));
  await desk.select("reef");
  const slider = desk.page.getByRole("spinbutton", { name: /subsidence/i }).first();
  const box = (await slider.boundingBox())!;
  await desk.changes("the slider", async () => {
    await desk.page.mouse.move(box.x + 20, box.y + box.height / 2);
    await desk.page.mouse.down();
    await desk.page.mouse.move(box.x + 70, box.y + box.height / 2, { steps: 15 });
    await desk.page.mouse.up();
  });
  assert.ok(Number((await desk.params("reef"))["subsidence"]) > 0);
  await desk.close();
});

test("two windows stay in step", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "reef", op: "island.coral" }));
  const other = await openPage(browser, desk.server.address);
  await other.page.locator("[data-key]").first().waitFor();
  const key = await other.page.locator("[data-key]").first().getAttribute("data-key");
  await desk.select("reef");
  const field = desk.page.getByRole("spinbutton", { name: /subsidence/i }).first();
  await field.focus();
  await desk.page.keyboard.press("Enter");
  await desk.page.keyboard.type("0.5");
  await desk.page.keyboard.press("Enter");
  await until(
    "the other window sees it",
    async () => (await other.page.locator("[data-key]").first().getAttribute("data-key")) !== key,
  );
  assert.deepEqual(other.errors, []);
  await other.page.context().close();
  await desk.close();
});

test("after a kill the window finds its way back", async () => {
  const desk = await Desk.open(browser, recipe(isle));
  await desk.select("isle");
  await desk.server.kill();
  await desk.page.getByText(/server|connection|studio/i).first().waitFor();
  await desk.page.context().close();
  await desk.server.run();
  const again = await openPage(browser, desk.server.address);
  await again.page.locator("[data-key]").first().waitFor();
  await again.page.context().close();
  await desk.server.end();
});
