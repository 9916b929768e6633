// Step cards, parameters and graph as a person uses them, on the real server: what is done is in the recipe, each
// gesture as one entry of the history, and the panel of every operator can be opened.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Locator, Page } from "playwright-core";
import type { Recipe, Schema, Step } from "../src/api/types";
import { Server, openBrowser, openPage, until } from "./harness";

const recipe: Recipe = {
  seamount: 1,
  domain: { width_m: 12000, height_m: 12000, cell_m: 120 },
  seed: 7,
  steps: [
    { id: "isle", op: "island.build" },
    { id: "wind", op: "island.wind" },
    { id: "reef", op: "island.coral", in: "wind", params: { subsidence: 0.2 } },
    { id: "heights", op: "terrain.mask", in: "reef.terrain", params: { criteria: [{ tool: "height", low_m: 200 }] } },
    { id: "rougher", op: "terrain.smooth", in: { terrain: "reef", mask: "heights" } },
  ],
};

let server: Server;
let browser: Browser;
let page: Page;
let errors: string[];

before(async () => {
  server = await Server.start(recipe);
  browser = await openBrowser();
  ({ page, errors } = await openPage(browser, server.address, { width: 1440, height: 1000 }));
  await page.waitForSelector("[data-step=rougher]");
});
after(async () => {
  await browser?.close();
  await server?.end();
});

const step = async (id: string): Promise<Step | undefined> => (await server.document()).recipe.steps.find((one) =>
  one.id === id);
const order = async (): Promise<string[]> => (await server.document()).recipe.steps.map((one) => one.id);
const labels = async (): Promise<string[]> => {
  const { history, done } = await server.document();
  return history.slice(0, done).map((entry) => entry.label);
};
const card = (id: string): Locator => page.locator(`[data-step="${id}"] .step-select`);
const field = (name: string): Locator => page.locator(`.params [data-number-field][aria-label="${name}"]`).first();
const expect = (what: string, is: () => Promise<boolean>): Promise<boolean> => until(what, is);

/** Once it lies still. */
async function middle(locator: Locator): Promise<[number, number]> {
  let before = "";
  let still = 0;
  return until("it lies still", async () => {
    const box = (await locator.boundingBox())!;
    const place: [number, number] = [box.x + box.width / 2, box.y + box.height / 2];
    still = before === place.join() ? still + 1 : 0;
    before = place.join();
    return still >= 8 ? place : null;
  });
}

async function drag(from: [number, number], to: [number, number], steps = 8): Promise<void> {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps });
  await page.mouse.up();
}

test("a number is dragged, typed with units, stepped and reset", async () => {
  await card("reef").click();
  const before = (await labels()).length;
  const [x, y] = await middle(field("Subsidence"));
  await drag([x, y], [x + 40, y]);
  await expect("dragged", async () => Number((await step("reef"))?.params?.["subsidence"]) > 0.3);
  await expect("one entry", async () => (await labels()).length === before + 1);
  assert.match((await labels()).at(-1)!, /^reef: subsidence 0\.2 → 0\.\d+$/);

  await field("Pass width").dblclick();
  await page.keyboard.type("2 * 0.2 km");
  await page.keyboard.press("Tab");
  await expect("typed", async () => (await step("reef"))?.params?.["pass_width_m"] === 400);
  await page.keyboard.press("Escape");

  await page.locator('[data-param="/steps/reef/params/pass_width_m"]').hover();
  await page.keyboard.press("Backspace");
  await expect("reset", async () => (await step("reef"))?.params?.["pass_width_m"] === undefined);

  // The pointer stays there; the keyboard goes to another one, whose value it is then.
  await field("Subsidence").focus();
  await page.keyboard.press("Backspace");
  await expect("reset by the focus", async () => (await step("reef"))?.params?.["subsidence"] === undefined);
});

test("steps are renamed, moved, left out, copied and removed by keyboard", async () => {
  await card("reef").focus();
  await page.keyboard.press("F2");
  await page.keyboard.type("atoll");
  await page.keyboard.press("Enter");
  await expect("renamed", async () => (await order()).includes("atoll"));
  await card("heights").focus();
  await page.keyboard.press("Alt+ArrowDown");
  await expect("moved", async () => (await order()).join() === "isle,wind,atoll,rougher,heights");
  await card("heights").focus();
  await page.keyboard.press("Alt+ArrowUp");
  await expect("moved back", async () => (await order()).join() === "isle,wind,atoll,heights,rougher");
  await page.keyboard.press("Control+d");
  await expect("copied", async () => (await order()).includes("heights_2"));
  await card("heights_2").focus();
  await page.keyboard.press("Delete");
  await expect("removed", async () => !(await order()).includes("heights_2"));
});

test("a step is found, added after the selected one and connected", async () => {
  await card("atoll").click();
  await page.getByRole("button", { name: "Add step" }).first().click();
  await page.keyboard.type("hydraulic");
  await page.keyboard.press("Enter");
  await expect("added", async () => (await order()).join() === "isle,wind,atoll,erosion,heights,rougher");
  assert.equal((await step("erosion"))?.in, undefined);
  await expect("selected", async () => (await page.locator(".params-head h2").innerText()) === "erosion");
  assert.equal(await page.locator("[aria-label='Input terrain']").first().inputValue(), "atoll.terrain");
  await page.keyboard.press("Control+z");
  await expect("undone", async () => !(await order()).includes("erosion"));
  await card("erosion").waitFor({ state: "detached" });
});

test("a wire is drawn, taken off, and only what fits lights up", async () => {
  await page.keyboard.press("Alt+1");
  const port = (key: string) => page.locator(`[data-port="${key}"] .port-dot`);
  await port("heights/in/terrain").waitFor();
  const [from, to] = [await middle(port("isle/out/terrain")), await middle(port("heights/in/terrain"))];
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(to[0] - 20, to[1], { steps: 4 });
  await expect("what fits lights up", async () => (await page.locator(".port.fits").count()) >= 3);
  assert.equal(await page.locator(".port.fits.kind-labels").count(), 0);
  await page.mouse.move(...to);
  await page.mouse.up();
  await expect("connected", async () => JSON.stringify((await step("heights"))?.in).includes("isle"));
  const off = await middle(port("rougher/in/mask"));
  await drag(off, [off[0] - 30, off[1] + 110]);
  await expect("taken off", async () => !JSON.stringify((await step("rougher"))?.in ?? "").includes("heights"));
});

test("knots of a curve and events of a list", async () => {
  await card("wind").click();
  const knot = page.locator("[data-knot='2']");
  await knot.scrollIntoViewIfNeeded();
  const [x, y] = await middle(knot);
  await drag([x, y], [x, y - 30]);
  await expect("dragged", async () => Array.isArray((await step("wind"))?.params?.["resistance"]));
  await card("heights").click();
  await page.selectOption(".add-tool", "slope");
  await expect("added", async () => JSON.stringify((await step("heights"))?.params?.["criteria"])
    .includes('{"tool":"slope"}'));
});

test("the panel of every operator opens whole", async () => {
  const schema = (await (await server.request("GET", "/api/schema")).json()) as Schema;
  const { revision } = await server.document();
  const edits = schema.operators.map((op) =>
    ({ do: "insert", list: "/steps", value: { id: op.name.replace(".", "_"), op: op.name, bypass: true, in: {} } }));
  assert.equal((await server.request("POST", "/api/edits", { window: "test", base: revision, gesture: "", label: "all",
    edits })).status, 200);
  await card("render_map").waitFor();
  const opened = await page.evaluate(async (ids) => {
    const frame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
    const found: { id: string; text: string; rows: number }[] = [];
    for (const id of ids) {
      document.querySelector<HTMLElement>(`[data-step="${id}"] .step-select`)!.click();
      while (document.querySelector(".params-head h2")?.textContent !== id) await frame();
      document.querySelectorAll<HTMLElement>(".params .group-toggle[aria-expanded=false]")
        .forEach((fold) => fold.click());
      await frame();
      const panel = document.querySelector<HTMLElement>(".params")!;
      found.push({ id, text: panel.innerText, rows: panel.querySelectorAll(".param, .items, .input-row").length });
    }
    return found;
  }, schema.operators.map((op) => op.name.replace(".", "_")));
  for (const [i, op] of schema.operators.entries()) {
    assert.doesNotMatch(opened[i]!.text, /NaN|undefined|\[object/, op.name);
    assert.ok(opened[i]!.rows >= op.in.length + op.params.filter((param) => param.kind !== "group").length, op.name);
  }
});

test("nothing went wrong on the page", () => {
  // A result that was overtaken while it was asked for is answered with 404, which browsers put into the console.
  assert.deepEqual(errors.filter((error) => !/404/.test(error)), []);
});
