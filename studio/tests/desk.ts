// What a person does in a window of the studio, for tests: choosing steps and tools, drawing on the map.
import assert from "node:assert/strict";
import type { Browser, Page } from "playwright-core";
import type { DocumentAnswer, Json, Recipe } from "../src/api/types";
import { openPage, Server, until } from "./harness";

/** A window of the studio on a server of its own, used as a person would. */
export class Desk {
  constructor(readonly server: Server, readonly page: Page, readonly errors: string[]) {}

  static async open(
    browser: Browser, document: Recipe | null, size: { width?: number; height?: number } = {},
    files: { [name: string]: string } = {},
  ): Promise<Desk> {
    return Desk.on(browser, await Server.start(document, files), size, document !== null);
  }

  /** On a server that runs. */
  static async on(
    browser: Browser, server: Server, size: { width?: number; height?: number } = {}, document = true,
  ): Promise<Desk> {
    const { page, errors } = await openPage(browser, server.address, size);
    const desk = new Desk(server, page, errors);
    await page.locator("[data-key]").first().waitFor();
    if (document) await page.keyboard.press("v"); // the map is the big view
    return desk;
  }

  async close(): Promise<void> {
    assert.deepEqual(this.errors, []);
    await this.page.context().close();
    await this.server.end();
  }

  select(step: string): Promise<void> {
    return this.page.getByRole("list", { name: "Steps" }).getByText(step, { exact: true }).first().click();
  }

  tool(name: string | RegExp): Promise<void> {
    return this.page.getByRole("toolbar", { name: "Tools" }).getByRole("button", { name }).first().click();
  }

  async params(step: string): Promise<{ [name: string]: Json }> {
    return (await this.server.document()).recipe.steps.find(({ id }) => id === step)?.params ?? {};
  }

  key(): Promise<string | null> {
    return this.page.locator("[data-key]").first().getAttribute("data-key");
  }

  /** A place of the map as shares of its width and height. */
  async place(x: number, y: number): Promise<[number, number]> {
    const box = (await this.page.getByRole("region", { name: "Map" }).boundingBox())!;
    return [box.x + x * box.width, box.y + y * box.height];
  }

  async drag(...places: [number, number][]): Promise<void> {
    const { mouse } = this.page;
    const [first, ...rest] = await Promise.all(places.map(([x, y]) => this.place(x, y)));
    await mouse.move(...first!);
    await mouse.down();
    for (const to of rest) await mouse.move(...to, { steps: 8 });
    await mouse.up();
  }

  /** Does something that changes the document and the terrain (unless it is what lies over it), and takes it back. */
  async changes(what: string, act: () => Promise<void>, terrain = true): Promise<Recipe> {
    const before = await this.server.document(), key = await this.key();
    await act();
    const after = await until(`${what}: the recipe changes`, async () => {
      const now = await this.server.document();
      return now.revision > before.revision && now;
    });
    if (terrain) {
      const other = until(`${what}: another terrain is seen`, async () => (await this.key()) !== key);
      await other.catch(async (error: unknown) => {
        if (process.env["LOOKS"]) await this.page.screenshot({ path: `${process.env["LOOKS"]}/failed.png` });
        throw error;
      });
    }
    await until(
      `${what}: and it is a full one`,
      async () => (await this.page.locator("[data-key]").first().getAttribute("data-coarse")) === "false",
    );
    assert.equal(after.done, before.done + 1, `${what} is one entry of the history`);
    const settled = (await this.sent()).recipe;
    await this.page.keyboard.press("Control+z");
    await until(`${what}: undo`, async () => (await this.server.document()).done === before.done);
    assert.deepEqual((await this.server.document()).recipe, before.recipe, `${what}: undone`);
    await this.page.keyboard.press("Control+Shift+z");
    await until(`${what}: redo`, async () => (await this.server.document()).done === before.done + 1);
    assert.deepEqual((await this.server.document()).recipe, settled, `${what}: made again`);
    return settled;
  }

  /** The document once no more edits come. */
  async sent(): Promise<DocumentAnswer> {
    let last = await this.server.document();
    await until("no more edits come", async () => {
      await this.page.waitForTimeout(300);
      const before = last.revision;
      last = await this.server.document();
      return last.revision === before;
    });
    return last;
  }

  /** Adds a step behind the selected one, by its operator's name: its id. */
  async add(op: string): Promise<string> {
    const before = (await this.server.document()).recipe.steps.length;
    await this.page.getByRole("button", { name: "Add step" }).first().click();
    await this.page.getByRole("combobox", { name: "Search operators" }).fill(op);
    await this.page.getByRole("option").filter({ hasText: op }).first().click();
    const { recipe } = await until(`${op} is added`, async () => {
      const now = await this.server.document();
      return now.recipe.steps.length > before && now;
    });
    return recipe.steps.find((step) => step.op === op)!.id;
  }

  /** Types a number into a field of a step's panel. */
  async type(step: string, field: RegExp, text: string): Promise<void> {
    await this.select(step);
    await this.page.getByRole("spinbutton", { name: field }).first().focus();
    await this.page.keyboard.press("Enter");
    await this.page.keyboard.type(text);
    await this.page.keyboard.press("Enter");
  }

  /** A picture of the window to look at, where LOOKS names a folder. */
  async look(name: string): Promise<void> {
    const folder = process.env["LOOKS"];
    if (!folder) return;
    await this.rest();
    await this.page.screenshot({ path: `${folder}/${name}.png` });
  }

  /** Waits until all that is wanted is computed and drawn. */
  async rest(): Promise<void> {
    let quiet = 0;
    await until("nothing is computed any more", async () => {
      const coarse = await this.page.locator("[data-coarse=true]").count();
      const working = coarse + (await this.page.locator(".engine-progress").count());
      quiet = working === 0 ? quiet + 1 : 0;
      return quiet > 60;
    }, 180);
    await this.page.waitForTimeout(1200);
  }
}
