// What somebody sees who opens the studio for the first time: soon, without errors, a picture, an example to begin
// with.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { openBrowser, openPage, Server, until } from "./harness";

let browser: Browser;
let server: Server;

before(async () => {
  [browser, server] = await Promise.all([openBrowser(), Server.start(null)]);
});
after(async () => {
  await browser?.close();
  await server?.end();
});

/** How different the brightness of a view's pixels is: 0 for one colour. */
async function variety(page: Page, name: string): Promise<number> {
  const png = await page.getByRole("region", { name }).screenshot();
  return page.evaluate(async (bytes) => {
    const picture = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
    const canvas = new OffscreenCanvas(picture.width, picture.height), to = canvas.getContext("2d")!;
    to.drawImage(picture, 0, 0);
    const { data } = to.getImageData(0, 0, picture.width, picture.height);
    let sum = 0, squares = 0;
    for (let i = 0; i < data.length; i += 4) {
      sum += data[i + 1]!;
      squares += data[i + 1]! ** 2;
    }
    const count = data.length / 4;
    return Math.sqrt(squares / count - (sum / count) ** 2);
  }, [...png]);
}

test("the page is small", () => {
  const folder = resolve(process.cwd(), "dist/page");
  const bytes = readdirSync(folder).filter((name) => name.endsWith(".br"))
    .reduce((sum, name) => sum + readFileSync(join(folder, name)).length, 0);
  console.log(`bundle: ${Math.round(bytes / 1024)} KiB compressed`);
  assert.ok(bytes < 1 << 20);
});

test("the first screen is there soon, an island behind it, and examples open", async () => {
  const { page, errors } = await openPage(browser, server.address);
  const gallery = page.getByRole("dialog", { name: /begin|Seamount|start/i }).first();
  await gallery.waitFor();
  const painted = () => page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? 0);
  const paint = await until("something is painted", painted);
  console.log(`first paint: ${Math.round(paint)} ms`);
  assert.ok(paint > 0 && paint < 3000);
  await page.keyboard.press("Escape");
  await gallery.waitFor({ state: "hidden" });
  await until("an island is drawn", () => page.locator("[data-key]").count().then((count) => count > 0));
  await until("the island is seen", async () => (await variety(page, "3D view")) > 12, 10);
  assert.ok((await variety(page, "Map")) > 12);
  assert.equal((await server.document()).recipe.steps.at(-1)?.op, "island.coral");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a window without the key says what is wrong", async () => {
  const { page } = await openPage(browser, server.address.split("#")[0]!);
  await page.getByRole("alert").getByText("address").waitFor();
  await page.context().close();
});

for (const dark of [true, false]) {
  test(`what is on the page can be read and used by everybody (${dark ? "dark" : "light"})`, async () => {
    const { page, errors } = await openPage(browser, server.address, { dark });
    await page.getByRole("dialog").first().waitFor();
    const axe = readFileSync(resolve(process.cwd(), "node_modules/axe-core/axe.min.js"), "utf8");
    const check = async (what: string) => {
      const found = await page.evaluate(async (source) => {
        if (!("axe" in window)) new Function(source).call(window);
        interface Found {
          violations: { id: string; impact: string; nodes: { html: string }[] }[];
        }
        const { run } = (window as unknown as { axe: { run(options: unknown): Promise<Found> } }).axe;
        return (await run({ resultTypes: ["violations"] })).violations
          .filter((violation) => violation.impact === "serious" || violation.impact === "critical")
          .map((violation) => `${violation.id}: ${violation.nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`);
      }, axe);
      assert.deepEqual(found, [], what);
    };
    await page.context().addInitScript(() => undefined);
    await check("first screen");
    await page.keyboard.press("Escape");
    await page.locator("[data-key]").first().waitFor();
    await page.getByRole("list", { name: "Steps" }).getByText("isle").first().click();
    await check("parameters");
    await page.keyboard.press("?");
    await page.getByRole("dialog").first().waitFor();
    await check("keys");
    assert.deepEqual(errors, []);
    await page.context().close();
  });
}
