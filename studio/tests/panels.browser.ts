// What could once be set in the recipe's text alone: variables and classes; the wheel over numbers and over heights; the
// picture of a step; files on their way; dialogs that keep all else out of reach.
import assert from "node:assert/strict";
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
const domain = { width_m: 10240, height_m: 10240, cell_m: 40 };
const coast = [[-3000, -2000], [2500, -2600], [3000, 1500], [0, 3000], [-2800, 1800]];
const isle: Step = { id: "isle", op: "island.build", params: { areas: [coast] as Json, peak_m: 800 } };
const recipe = (...steps: Step[]): Recipe => ({ seamount: 1, domain, seed: 3, steps });

test("a parameter becomes a variable, which others take; its value is changed for all, and one is let go", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "two", op: "island.build", params: { peak_m: 500 } }));
  await desk.select("isle");
  const bound = await desk.changes("a variable", async () => {
    await desk.page.getByRole("combobox", { name: "Variable for Peak" }).selectOption({ label: "New variable $peak_m" });
  }, false);
  assert.deepEqual(bound.variables, { peak_m: 800 });
  assert.equal(bound.steps[0]!.params!["peak_m"], "$peak_m");
  await desk.look("variable");
  await desk.select("two");
  await desk.page.getByRole("combobox", { name: "Variable for Peak" }).selectOption("peak_m");
  await until("the other step has it too", async () => (await desk.params("two"))["peak_m"] === "$peak_m");
  const changed = await desk.changes("its value", async () => {
    await desk.page.getByRole("spinbutton", { name: "Peak, variable peak_m" }).focus();
    await desk.page.keyboard.press("Enter");
    await desk.page.keyboard.type("640");
    await desk.page.keyboard.press("Enter");
  });
  assert.deepEqual(changed.variables, { peak_m: 640 });
  await desk.page.getByRole("button", { name: "Give Peak a value of its own" }).click();
  await until("it is a number again", async () => (await desk.params("two"))["peak_m"] === 640);
  assert.equal((await desk.params("isle"))["peak_m"], "$peak_m");
  await desk.close();
});

test("classes of the catalogue are chosen in the panel", async () => {
  const { recipe: scene, files } = repositoryRecipe("ecosystem/competition.json");
  const steps = scene.steps.filter(({ op }) => !op.startsWith("render."));
  steps.find(({ id }) => id === "reef")!.params!["iterations"] = 8;
  const desk = await Desk.open(browser, { ...scene, steps, outputs: [] }, {}, files);
  await desk.select("reef");
  const classes = desk.page.getByRole("group", { name: "Classes" });
  const only = await desk.changes("only one class grows", () => classes.getByRole("button", { name: "coral c" }).click(), false);
  assert.deepEqual(only.steps.find(({ id }) => id === "reef")!.params!["classes"], ["coral_c"]);
  await desk.page.getByRole("button", { name: /^add/ }).first().click();
  await desk.page.getByRole("combobox", { name: "Class", exact: true }).last().selectOption("coral_b");
  await until("the edit names it", async () => ((await desk.params("reef"))["edits"] as Members[])[0]!["class"] === "coral_b");
  await desk.look("classes");
  await desk.close();
});

test("the wheel steps a number that has the focus, and with Alt the height under the pen", async () => {
  const desk = await Desk.open(browser, recipe(isle));
  await desk.select("isle");
  const field = desk.page.getByRole("spinbutton", { name: "Peak", exact: true });
  await field.hover();
  await desk.page.mouse.wheel(0, -100);
  assert.equal((await desk.params("isle"))["peak_m"], 800, "without the focus it scrolls");
  await field.focus();
  await field.hover();
  const wheeled = await desk.changes("the wheel", async () => {
    for (let i = 0; i < 3; ++i) await desk.page.mouse.wheel(0, -100);
  });
  assert.ok(Number(wheeled.steps[0]!.params!["peak_m"]) > 800);

  await desk.tool(/summit/i);
  await desk.changes("a summit", async () => desk.page.mouse.click(...(await desk.place(0.5, 0.5))));
  const summits = async () => (await desk.params("isle"))["summits"] as Members[];
  const height = async () => Number(Object.entries((await summits())[0]!).find(([name]) => /height|peak/.test(name))?.[1] ?? 0);
  const before = await height();
  await desk.page.mouse.move(...(await desk.place(0.501, 0.5)));
  await desk.page.keyboard.down("Alt");
  const { done } = await desk.server.document();
  for (let i = 0; i < 4; ++i) await desk.page.mouse.wheel(0, -100);
  await desk.look("wheel");
  await until("the summit is higher", async () => (await height()) > before);
  await desk.page.keyboard.up("Alt");
  assert.equal((await desk.server.document()).done, done + 1, "turns in a row are one entry");
  await desk.close();
});

test("the picture of a step is seen, and the ground again", async () => {
  const desk = await Desk.open(browser, recipe(isle, { id: "sheet", op: "render.map", in: { terrain: "isle.terrain" }, params: { width_px: 600 } }));
  await desk.select("sheet");
  const picture = desk.page.getByRole("img", { name: "Picture of sheet" });
  await picture.waitFor();
  const width = await picture.evaluate((image: HTMLImageElement) => image.decode().then(() => image.naturalWidth));
  assert.ok(width > 100);
  await desk.look("picture");
  await desk.page.getByRole("button", { name: "Show the ground" }).click();
  assert.equal(await picture.count(), 0);
  await desk.page.getByRole("button", { name: "Show the picture" }).click();
  await picture.waitFor();
  await desk.select("isle");
  await until("with another step it goes", async () => (await picture.count()) === 0);
  await desk.close();
});

test("a dialog keeps all else out of reach", async () => {
  const desk = await Desk.open(browser, recipe(isle));
  await desk.page.keyboard.press("Control+o");
  await desk.page.getByRole("dialog", { name: "Open a recipe" }).waitFor();
  const reachable = await desk.page.evaluate(() => [...document.querySelectorAll<HTMLElement>(".tool-column button, .top-bar button")]
    .filter((button) => !button.closest("[inert]") || (button.focus(), document.activeElement === button)).length);
  assert.equal(reachable, 0);
  await desk.page.keyboard.press("Escape");
  await desk.tool(/Measure a distance/);
  await desk.close();
});

test("a file on its way shows how much of it is there, and is called back", async () => {
  const desk = await Desk.open(browser, recipe(isle));
  const devtools = await desk.page.context().newCDPSession(desk.page);
  await devtools.send("Network.enable");
  const slow = { offline: false, latency: 20, downloadThroughput: -1, uploadThroughput: 200_000 };
  await devtools.send("Network.emulateNetworkConditions", slow);
  await desk.page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array(6_000_000)], "big.tif"));
    dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  const card = desk.page.getByRole("status").filter({ hasText: "big.tif" });
  await card.waitFor();
  await until("a part of it is sent", async () => {
    const text = (await card.innerText().catch(() => "")) || "";
    return /\b([1-9]|[1-9]\d) %/.test(text);
  });
  await desk.page.getByRole("button", { name: "Cancel the upload" }).click();
  await until("the card goes", async () => (await card.count()) === 0);
  await devtools.send("Network.emulateNetworkConditions", { ...slow, latency: 0, uploadThroughput: -1 });
  assert.equal(await desk.page.getByRole("alert").count(), 0, "nothing is said of it");
  assert.equal((await desk.server.document()).recipe.steps.length, 1);
  await desk.close();
});
