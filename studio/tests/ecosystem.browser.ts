// Scenes that grow, as a person works on them: what lives is seen in both views, objects are placed, moved, bent, held
// and taken away, a mask says where they may be, and events lie on the line of time, which plays.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { Json, Recipe, Step } from "../src/api/types";
import { Desk } from "./desk";
import { openBrowser, repositoryRecipe, until } from "./harness";

let browser: Browser;

before(async () => {
  browser = await openBrowser();
});
after(async () => {
  await browser?.close();
});

type Members = { [name: string]: Json };

/** A document of the repository that grows for less long, with its step of life in the hand and its pictures left
 * out. */
async function open(
  name: string, iterations: number, change: (recipe: Recipe) => void = () => undefined,
): Promise<Desk> {
  const { recipe, files } = repositoryRecipe(`ecosystem/${name}.json`);
  const steps = recipe.steps.filter(({ op }) => !op.startsWith("render."));
  const life = steps.find(({ op }) => op === "ecosystem.grow")!;
  life.id = "life";
  life.params = { ...life.params, iterations };
  const document: Recipe = { ...recipe, steps, outputs: [] };
  change(document);
  const desk = await Desk.open(browser, document, {}, files);
  await desk.select("life");
  await counts(desk);
  return desk;
}

/** How many objects of each class are on the map. */
async function counts(desk: Desk): Promise<{ [name: string]: number }> {
  const rows = desk.page.getByRole("list", { name: "Objects" }).getByRole("listitem");
  await rows.first().waitFor();
  const texts = await rows.allInnerTexts();
  return Object.fromEntries(texts.map((text) => {
    const [name, count] = text.split("\n");
    return [name!.replace(/ /g, "_"), Number(count)];
  }));
}

const lifeOf = (recipe: Recipe): Step => recipe.steps.find(({ id }) => id === "life")!;
const listOf = (recipe: Recipe, name: string): Members[] => (lifeOf(recipe).params![name] ?? []) as Members[];

/** Mean difference of a view's colours between now and after something is done, 0 to 255. */
async function difference(desk: Desk, view: string, act: () => Promise<void>): Promise<number> {
  const shot = async (): Promise<number[]> => [
    ...(await desk.page.getByRole("region", { name: view, exact: true }).screenshot()),
  ];
  await desk.rest();
  const first = await shot();
  await act();
  await desk.rest();
  const second = await shot();
  return desk.page.evaluate(async (both) => {
    const pixels = await Promise.all(both.map(async (bytes) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
      const to = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
      to.drawImage(bitmap, 0, 0);
      return to.getImageData(0, 0, bitmap.width, bitmap.height).data;
    }));
    let sum = 0;
    for (let i = 0; i < pixels[0]!.length; ++i) sum += Math.abs(pixels[0]![i]! - pixels[1]![i]!);
    return sum / pixels[0]!.length;
  }, [first, second]);
}

test("what lives is seen on the map and in the 3D view, with the names of its classes", async () => {
  const desk = await open("coral_reef_island", 5);
  const seen = await counts(desk);
  assert.ok((seen["tree"] ?? 0) > 50 && (seen["island"] ?? 0) === 1, JSON.stringify(seen));
  const toggle = async (): Promise<void> => {
    await desk.page.getByRole("button", { name: "How the ground is shown" }).click();
    await desk.page.getByRole("checkbox", { name: "Life" }).click();
    await desk.page.keyboard.press("Escape");
  };
  await desk.look("life_map");
  await desk.page.keyboard.press("v");
  await desk.look("life_world");
  const without = await difference(desk, "3D view", toggle);
  assert.ok(without > 0.05, `things stand in the 3D view: ${without}`);
  assert.equal(await desk.page.getByRole("list", { name: "Objects" }).count(), 0);
  await toggle();
  await desk.page.keyboard.press("v");
  await counts(desk);
  await desk.close();
});

test("a catalogue that another program writes is seen when the window is come back to", async () => {
  const desk = await open("competition", 6);
  const mark = desk.page.getByRole("list", { name: "Objects" }).getByRole("listitem").first();
  const colour = (): Promise<string> =>
    mark.locator(".class-mark").evaluate((one) => getComputedStyle(one).backgroundColor);
  const name = (await mark.innerText()).split("\n")[0]!.replace(/ /g, "_");
  const file = join(desk.server.folder, "work/competition.json");
  const catalogue = JSON.parse(readFileSync(file, "utf8")) as { classes: Members[] };
  assert.notEqual(await colour(), "rgb(18, 52, 254)");
  for (const one of catalogue.classes) if (one["name"] === name) one["colour"] = "#1234fe";
  writeFileSync(file, JSON.stringify(catalogue));
  await desk.page.evaluate(() => window.dispatchEvent(new Event("focus")));
  await until("the class has its new colour", async () => (await colour()) === "rgb(18, 52, 254)");
  await desk.close();
});

test("objects are placed: a class is chosen, a click and a line make them", async () => {
  const desk = await open("competition", 12);
  await desk.tool(/Add an object/);
  await desk.page.getByRole("toolbar", { name: /^Options/ }).getByRole("combobox").selectOption("coral_b");
  const before = await counts(desk);
  const placed = await desk.changes("an object", async () => {
    await desk.page.mouse.click(...(await desk.place(0.5, 0.72)));
  });
  const added = listOf(placed, "edits").at(-1)!;
  assert.equal(added["tool"], "add");
  assert.equal(added["class"], "coral_b");
  assert.equal((added["points"] as Json[]).length, 1);
  assert.equal(listOf(placed, "edits").length, 4);
  await desk.look("placed");
  await until("the map has more of it", async () => ((await counts(desk))["coral_b"] ?? 0) > before["coral_b"]!);
  await desk.close();
});

test("an object is dragged away, locked and taken out", async () => {
  const desk = await open("competition", 12);
  await desk.tool(/Move an object/);
  const moved = await desk.changes("a move", () => desk.drag([0.5, 0.24], [0.55, 0.3], [0.6, 0.5]));
  const move = listOf(moved, "edits").at(-1)!, object = move["object"] as Members;
  assert.equal(move["tool"], "move");
  assert.equal(object["class"], "coral_a", "the class of what was under the pen");
  assert.ok((move["by"] as number[])[0]! > 5 && (move["by"] as number[])[1]! < -10);
  assert.equal(move["after"], 11, "done at the end of growth");
  await desk.tool(/Lock an object/);
  const held = await desk.changes("a lock", async () => desk.page.mouse.click(...(await desk.place(0.5, 0.26))));
  assert.equal(listOf(held, "edits").at(-1)!["tool"], "hold");
  await desk.tool(/Delete an object/);
  const gone = await desk.changes("a deletion", async () => desk.page.mouse.click(...(await desk.place(0.5, 0.26))));
  assert.equal((listOf(gone, "edits").at(-1)!["object"] as Members)["class"], "coral_a");
  await desk.tool(/Select and move/);
  await desk.page.mouse.click(...(await desk.place(0.5, 0.26)));
  const back = await desk.changes("the edit itself is taken out", () => desk.page.keyboard.press("Delete"));
  assert.equal(listOf(back, "edits").length, listOf(gone, "edits").length - 1);
  await desk.close();
});

test("a curve is bent by a handle", async () => {
  const desk = await open("canyon", 4);
  await desk.tool(/Bend an object/);
  const bent = await desk.changes("a bend", () => desk.drag([0.486, 0.366], [0.4, 0.36], [0.34, 0.36]));
  const bend = listOf(bent, "edits").at(-1)!;
  assert.equal((bend["object"] as Members)["class"], "canyon");
  assert.ok((bend["by"] as number[])[0]! < -20);
  assert.ok(Array.isArray(bend["at"]));
  await desk.look("bent");
  await desk.close();
});

test("a painted mask says where anything may be born", async () => {
  const desk = await open("competition", 12, (recipe) => {
    delete (lifeOf(recipe).in as { focus?: Json }).focus;
    recipe.steps = recipe.steps.filter(({ id }) => id !== "ring");
  });
  const before = await counts(desk);
  await desk.tool("More tools");
  await desk.page.getByRole("menuitem", { name: /Paint the focus/ }).click();
  const painted = await desk.changes("the focus", () => desk.drag([0.45, 0.25], [0.5, 0.24], [0.55, 0.25]));
  const mask = painted.steps.find(({ op }) => op === "terrain.paint")!;
  assert.equal((lifeOf(painted).in as Members)["focus"], `${mask.id}.values`);
  await desk.select("life");
  const all = (seen: { [name: string]: number }) => Object.values(seen).reduce((sum, count) => sum + count, 0);
  await desk.look("focus");
  await until("less is born", async () => all(await counts(desk)) < 0.7 * all(before));
  await desk.close();
});

test("a current is drawn, a storm placed; both lie on the line of time, are dragged there, and it plays", async () => {
  const desk = await open("competition", 12);
  await desk.tool(/^Current/);
  const drawn = await desk.changes("a current", () => desk.drag([0.2, 0.6], [0.5, 0.55], [0.8, 0.6]));
  const current = listOf(drawn, "timeline").at(-1)!;
  assert.equal(current["tool"], "current");
  assert.ok((current["points"] as Json[]).length >= 2);
  await desk.tool(/^Storm/);
  const stormy = await desk.changes("a storm", async () => desk.page.mouse.click(...(await desk.place(0.5, 0.5))));
  assert.equal(listOf(stormy, "timeline").at(-1)!["tool"], "storm");

  await desk.page.getByRole("button", { name: "Timeline", exact: true }).click();
  const panel = desk.page.locator(".timeline-panel");
  const bar = panel.getByRole("button", { name: /^storm, from 0 to 10/ });
  await bar.waitFor();
  const box = (await bar.boundingBox())!, track = (await panel.locator(".timeline-rows").boundingBox())!;
  const dragged = await desk.changes("the storm comes later", async () => {
    const { mouse } = desk.page;
    await mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await mouse.down();
    await mouse.move(box.x + box.width / 2 + (2.2 * track.width) / 12, box.y + box.height / 2, { steps: 6 });
    await mouse.up();
  });
  const storm = listOf(dragged, "timeline").at(-1)!;
  assert.ok(Number(storm["start"]) >= 2 && Number(storm["end"]) === Number(storm["start"]) + 10, JSON.stringify(storm));

  await desk.look("time");
  const start = await desk.server.document();
  await panel.getByRole("button", { name: "Play" }).click();
  const times = new Set<number>();
  await until("three times are played", async () => {
    times.add(Number((await desk.params("life"))["iterations"]));
    return times.size >= 4;
  }, 40);
  await panel.getByRole("button", { name: "Pause" }).click();
  await desk.rest();
  const paused = await desk.params("life");
  await desk.page.waitForTimeout(800);
  assert.deepEqual(await desk.params("life"), paused, "it stands still");
  assert.equal((await desk.server.document()).done, start.done + 1, "playing is one entry of the history");
  await desk.page.keyboard.press("Control+z");
  await until("and is undone as one", async () => (await desk.server.document()).done === start.done);
  assert.equal((await desk.params("life"))["iterations"], 12);
  await desk.close();
});
