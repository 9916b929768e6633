// Four whole sessions as docs/guide/studio.md tells them: from the first screen to a terrain, by pen and panels alone.
// With PICTURES=FOLDER in the environment the pictures of the guide are made.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { Desk } from "./desk";
import { openBrowser, until } from "./harness";

let browser: Browser;

before(async () => {
  browser = await openBrowser();
});
after(async () => {
  await browser?.close();
});

async function picture(desk: Desk, name: string): Promise<void> {
  const folder = process.env["PICTURES"];
  if (!folder) return;
  await desk.rest();
  await desk.page.screenshot({ path: join(folder, `studio_${name}.png`) });
}

const size = process.env["PICTURES"] ? { width: 1440, height: 900 } : {};
const begin = async (name: RegExp, group?: RegExp): Promise<Desk> => {
  const desk = await Desk.open(browser, null, size);
  await picture(desk, "first_screen");
  const key = await desk.key(), screen = desk.page.getByRole("dialog");
  await (group ? screen.getByRole("region", { name: group }) : screen).getByRole("button", { name }).first().click();
  await until("another terrain is seen", async () => (await desk.key()) !== key, 60);
  return desk;
};

/** A ring of places around the middle of the map, as shares of its sides, on a map that is `wide` times as wide as
 * high. */
function ring(wide: number): [number, number][] {
  return Array.from({ length: 37 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 36, radius = 0.25 + 0.035 * Math.sin(3 * angle) + 0.025 * Math.cos(5 * angle + 1);
    return [0.5 + (radius * Math.cos(angle)) / wide, 0.5 - radius * Math.sin(angle)];
  });
}

test("a volcanic island becomes an atoll", async () => {
  const desk = await begin(/Draw a coast/);
  const box = await until("the map is big", async () => {
    const at = await desk.page.getByRole("region", { name: "Map" }).boundingBox();
    return at && at.width > 500 && at;
  });
  await desk.changes("the coast", () => desk.drag(...ring(box.width / box.height)));
  await picture(desk, "coast");
  const reef = await desk.add("island.coral");
  await desk.changes("the age", () => desk.type(reef, /subsidence/i, "0.15"));
  await desk.page.keyboard.press("v");
  await picture(desk, "reef");
  await desk.changes("the atoll", () => desk.type(reef, /subsidence/i, "0.7"));
  await picture(desk, "atoll");
  const { recipe } = await desk.server.document();
  assert.deepEqual(recipe.steps.map((step) => step.op), ["island.build", "island.coral"]);
  await desk.close();
});

test("a mountain range from four strokes", async () => {
  const desk = await begin(/Mountains from strokes/);
  const strokes: [number, number][][] = [
    [[0.3, 0.3], [0.4, 0.42], [0.5, 0.5]], [[0.5, 0.5], [0.62, 0.46], [0.72, 0.52]],
    [[0.4, 0.42], [0.37, 0.6], [0.42, 0.72]], [[0.62, 0.46], [0.66, 0.32], [0.63, 0.22]],
  ];
  for (const stroke of strokes) await desk.changes("a ridge", () => desk.drag(...stroke));
  await picture(desk, "strokes");
  await desk.page.keyboard.press("v");
  await picture(desk, "range");
  const [step] = (await desk.server.document()).recipe.steps;
  assert.equal((step!.params!["ridges"] as unknown[]).length, 4);
  await desk.close();
});

test("a canyon from contours", async () => {
  const desk = await begin(/Canyon/i, /contours/i);
  assert.ok((await desk.server.document()).recipe.steps.some((step) => step.op === "contour.grow"));
  await picture(desk, "canyon");
  await desk.close();
});

test("a reef with life on it", async () => {
  const desk = await begin(/Coral reef island/i);
  assert.ok((await desk.server.document()).recipe.steps.some((step) => step.op === "ecosystem.grow"));
  await picture(desk, "life");
  await desk.close();
});
