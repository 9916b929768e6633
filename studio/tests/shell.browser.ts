// The window around the views, used as a person would: shortcuts, undo, the recipe's text, files in and out, two
// windows.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import type { Recipe } from "../src/api/types";
import { openBrowser, openPage, Server, until } from "./harness";

const recipe: Recipe = {
  seamount: 1,
  domain: { width_m: 8000, height_m: 8000, cell_m: 80 },
  seed: 3,
  steps: [
    { id: "isle", op: "island.build", params: { peak_m: 830 } },
    { id: "reef", op: "island.coral", in: "isle", params: { subsidence: 0.2 } },
  ],
  outputs: [],
};

let browser: Browser;
let server: Server;

before(async () => {
  [browser, server] = await Promise.all([openBrowser(), Server.start(recipe)]);
});
after(async () => {
  await browser?.close();
  await server?.end();
});

async function opened(): Promise<{ page: Page; errors: string[] }> {
  const found = await openPage(browser, server.address);
  await found.page.locator("[data-key]").first().waitFor();
  return found;
}

async function peak(): Promise<unknown> {
  return (await server.document()).recipe.steps[0]?.params?.["peak_m"];
}

/** Writes into the recipe's text: what stands there gives way to something else. */
async function retype(page: Page, before: string, after: string): Promise<void> {
  const editor = page.getByRole("textbox", { name: "Recipe" });
  await editor.click();
  const place = await editor.evaluate((content, text) => {
    const walker = document.createTreeWalker(content, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const at = node.textContent!.indexOf(text);
      if (at < 0) continue;
      const range = document.createRange();
      range.setStart(node, at);
      range.setEnd(node, at + text.length);
      const box = range.getBoundingClientRect();
      return { x: box.left + 2, y: box.top + box.height / 2 };
    }
    return null;
  }, before);
  assert.ok(place, `'${before}' stands in the text`);
  await page.mouse.dblclick(place.x, place.y);
  await page.keyboard.type(after);
}

test("an edit of another window is seen, listed as such, undone and made again by keys", async () => {
  const { page, errors } = await opened();
  const { revision } = await server.document();
  const edits = [{ do: "set", pointer: "/steps/isle/params/peak_m", value: 650 }];
  await server.request(
    "POST", "/api/edits", { window: "other", base: revision, gesture: "", label: "isle: peak 830 → 650", edits },
  );
  await page.keyboard.press("Alt+3");
  const row = page.getByRole("button", { name: /peak 830 → 650/ });
  await row.waitFor();
  assert.match(await row.innerText(), /another window/);
  assert.match(await page.locator(".document-name").innerText(), /Changes kept/);
  await page.keyboard.press("Control+z");
  await until("it is undone", async () => (await peak()) === 830);
  await page.keyboard.press("Control+Shift+z");
  await until("it is made again", async () => (await peak()) === 650);
  await page.getByRole("button", { name: "As it was opened" }).click();
  await until("the list leads back", async () => (await peak()) === 830);
  await page.keyboard.press("Alt+3");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("the recipe's text goes both ways", async () => {
  const { page } = await opened();
  await page.keyboard.press("Alt+2");
  await retype(page, "830", "720");
  await until("what is typed is in the document", async () => (await peak()) === 720);
  await page.getByText("As the document").waitFor();
  await retype(page, "island.coral", "nothing.here");
  await page.getByRole("button", { name: /unknown operator/ }).waitFor();
  assert.equal((await server.document()).recipe.steps[1]?.op, "island.coral");
  const { revision } = await server.document();
  const edits = [{ do: "set", pointer: "/seed", value: 41 }];
  await server.request("POST", "/api/edits", { window: "other", base: revision, gesture: "", label: "seed", edits });
  const editor = page.getByRole("textbox", { name: "Recipe" });
  await until("what changes elsewhere is in the text", async () => (await editor.innerText()).includes('"seed": 41'));
  assert.match(await editor.innerText(), /nothing/);
  await page.keyboard.press("Control+z");
  await page.context().close();
});

test("the palette finds, V swaps, the sheet shows what the registry knows", async () => {
  const { page, errors } = await opened();
  await page.keyboard.press("Control+k");
  await page.keyboard.type("go to reef");
  await page.keyboard.press("Enter");
  await page.getByRole("region", { name: "Parameters" }).getByText("Subsidence").waitFor();
  const map = page.getByRole("region", { name: "Map" });
  const width = async (): Promise<number> => (await map.boundingBox())!.width;
  const small = await width();
  await page.keyboard.press("v");
  await until("the map is big", async () => (await width()) > 2 * small);
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Keyboard and mouse" }).getByText("Save as").waitFor();
  await page.keyboard.press("Escape");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("saving, saving as and opening", async () => {
  const { page, errors } = await opened();
  await page.keyboard.press("Control+s");
  await page.getByText("Saved to test.json").waitFor();
  await page.keyboard.press("Control+Shift+s");
  await page.getByRole("dialog", { name: "Save as" }).getByRole("textbox").fill("other/copy");
  await page.keyboard.press("Enter");
  await until("the copy is written", async () => existsSync(join(server.folder, "work/other/copy.json")));
  await page.locator(".document-file").getByText("copy.json").waitFor();
  await page.keyboard.press("Control+o");
  await page.getByRole("button", { name: /test\.json/ }).click();
  await page.locator(".document-file").getByText("test.json").waitFor();
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("an export is written and can be taken along", async () => {
  const { page, errors } = await opened();
  await page.keyboard.press("Control+e");
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByLabel("Write GeoTIFF").check();
  await dialog.getByRole("button", { name: "Export 2 outputs" }).click();
  await dialog.getByText(/files were written/).waitFor();
  assert.ok(existsSync(join(server.folder, "work/export/height.tif")));
  const [download] = await Promise.all(
    [page.waitForEvent("download"), dialog.getByRole("button", { name: "Download" }).first().click()],
  );
  assert.ok(readFileSync(await download.path()).length > 1000);
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a file that is dropped on the window begins a step", async () => {
  const { page, errors } = await opened();
  const header = "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 90\n";
  const transfer = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "hill.asc"));
    return data;
  }, `${header}${"1 2 3 4\n".repeat(4)}`);
  await page.dispatchEvent(".views", "dragenter", { dataTransfer: transfer });
  await page.getByText("Drop to take it in").waitFor();
  await page.dispatchEvent(".views", "drop", { dataTransfer: transfer });
  await until("the step is there", async () => (await server.document()).recipe.steps[0]?.op === "terrain.import");
  assert.deepEqual(errors, []);
  await page.context().close();
});

test("a server that goes is missed, and a new one has its own key", async () => {
  const { page } = await opened();
  await server.kill();
  await page.getByRole("alert").getByText("does not answer").waitFor();
  await server.run();
  const again = await openPage(browser, server.address);
  await again.page.locator("[data-key]").first().waitFor();
  assert.equal((await server.document()).recipe.steps[0]?.op, "terrain.import");
  await again.page.context().close();
  await page.context().close();
});
