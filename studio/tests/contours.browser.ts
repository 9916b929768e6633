// Contours under a pen, on the real server: regions are drawn, lines warped, made steeper, smoothed, roughened, copied,
// cut, pasted, filled and deleted, each a change of the terrain that one step takes back.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { Json, Recipe } from "../src/api/types";
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
const document: Recipe = {
  seamount: 1, domain, seed: 5,
  steps: [
    { id: "grown", op: "contour.grow", params: { particles: 6000, outlines: [{ name: "land", height_m: 0, ring }] as Json } },
    { id: "high", op: "contour.heights", params: { max_m: 1800 } },
    { id: "lines", op: "contour.extract", params: { interval_m: 100 } },
    { id: "shaped", op: "contour.edit" },
    { id: "land", op: "contour.reconstruct", in: { contours: "shaped.contours" } },
  ],
};

type Members = { [name: string]: Json };
const edits = (recipe: Recipe): Members[] =>
  (recipe.steps.find(({ id }) => id === "shaped")!.params?.["edits"] ?? []) as Members[];
const square: [number, number][] = [[0.44, 0.44], [0.53, 0.44], [0.53, 0.55], [0.44, 0.55], [0.44, 0.445]];

async function open(step: string): Promise<Desk> {
  const desk = await Desk.open(browser, document);
  await desk.select(step);
  return desk;
}

/** Draws with a tool: the edit that has come. */
async function drawn(desk: Desk, tool: RegExp, name: string, act: () => Promise<void>): Promise<Members> {
  await desk.tool(tool);
  const made = edits(await desk.changes(name, act)).at(-1)!;
  assert.equal(made["tool"], name);
  return made;
}

test("contours are warped, made steeper, smoothed and roughened", async () => {
  const desk = await open("shaped");
  await desk.look("contours");
  const warp = await drawn(desk, /Warp contours/, "warp", () => desk.drag([0.5, 0.6], [0.55, 0.5], [0.62, 0.4]));
  assert.ok((warp["stroke"] as Json[]).length >= 2);
  await desk.look("warped");
  await drawn(desk, /Steeper, gentler/, "slope", () => desk.drag([0.4, 0.35], [0.5, 0.33]));
  await drawn(desk, /Smooth contours/, "smooth", () => desk.drag(...square));
  await drawn(desk, /Roughen contours/, "fractalize", () => desk.drag(...square));
  await desk.close();
});

test("a hill is copied and pasted, another cut out, a place filled and a contour deleted", async () => {
  const desk = await open("shaped");
  await desk.tool(/Copy contours/);
  const copied = edits(await desk.changes("copy", () => desk.drag(...square), false)).at(-1)!;
  assert.equal(copied["tool"], "copy");
  const paste = await drawn(desk, /Paste contours/, "paste", async () => desk.page.mouse.click(...(await desk.place(0.62, 0.62))));
  assert.equal((paste["at"] as Json[]).length, 2);
  await desk.look("pasted");
  await drawn(desk, /Fill with contours/, "fill", () => desk.drag(...square));
  await drawn(desk, /Cut contours/, "cut", () => desk.drag(...square));
  await drawn(desk, /Delete contours/, "delete", async () => desk.page.mouse.click(...(await desk.place(0.6, 0.4))));
  await desk.look("cut");
  await desk.tool(/Select and move/);
  const before = edits((await desk.server.document()).recipe).length;
  await desk.page.mouse.click(...(await desk.place(0.62, 0.62)));
  const left = edits(await desk.changes("the paste is taken out", () => desk.page.keyboard.press("Delete")));
  assert.equal(left.length, before - 1);
  await desk.close();
});

test("regions are drawn into a network, with a height", async () => {
  const desk = await open("grown");
  await desk.tool(/^Region/);
  const after = await desk.changes("a region", () => desk.drag([0.45, 0.4], [0.56, 0.4], [0.56, 0.52], [0.45, 0.52], [0.45, 0.405]));
  const outlines = after.steps[0]!.params!["outlines"] as Members[];
  assert.equal(outlines.length, 2);
  await desk.tool(/Select and move/);
  await desk.page.mouse.click(...(await desk.place(0.5, 0.4)));
  await desk.page.getByRole("toolbar", { name: /^Options/ }).getByRole("spinbutton", { name: /height/i }).focus();
  await desk.page.keyboard.press("Enter");
  await desk.page.keyboard.type("900");
  await desk.page.keyboard.press("Enter");
  await until("it has the height", async () => {
    const now = (await desk.params("grown"))["outlines"] as Members[];
    return now[1]?.["height_m"] === 900;
  });
  await desk.look("region");
  await desk.close();
});
