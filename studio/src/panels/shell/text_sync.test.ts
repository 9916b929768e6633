import assert from "node:assert/strict";
import { test } from "node:test";
import { FakeServer } from "../../document/fake";
import { openStudio } from "../../document/open_studio";
import type { OpenedStudio } from "../../document/open_studio";
import { differences } from "./text_diff";
import { TextSync } from "./text_sync";

class PlainEditor {
  focused = true;
  marks = 0;
  constructor(public text: string) {}
  mark(diagnostics: readonly unknown[]): void {
    this.marks = diagnostics.length;
  }
  /** As the real one, where changes do not meet. */
  merge(before: string, after: string): void {
    const typed = differences(before, this.text);
    const shift = (at: number): number => typed.reduce(
      (sum, { from, to, insert }) => (to <= at ? sum + insert.length - (to - from) : sum), at,
    );
    for (const { from, to, insert } of differences(before, after).reverse()) {
      this.text = this.text.slice(0, shift(from)) + insert + this.text.slice(shift(to));
    }
  }
}

async function until(holds: () => boolean): Promise<void> {
  for (let i = 0; i < 400 && !holds(); ++i) await new Promise((resolve) => setTimeout(resolve, 5));
  assert.ok(holds(), "it did not come to hold within two seconds");
}

interface Started {
  server: FakeServer;
  studio: OpenedStudio;
  editor: PlainEditor;
  sync: TextSync;
  end: () => void;
}

async function started(): Promise<Started> {
  const server = new FakeServer();
  const studio = await openStudio(server, "me");
  await until(() => studio.connected.value);
  const { text, revision } = await server.document();
  const editor = new PlainEditor(text);
  const sync = new TextSync(studio, editor, text, revision, 5);
  const end = (): void => {
    sync.close();
    studio.close();
  };
  return { server, studio, editor, sync, end };
}

test("what is typed becomes the document's, and its own writing stays while one writes", async () => {
  const { server, studio, editor, sync, end } = await started();
  editor.text = editor.text.replace('"peak_m": 1100', '"peak_m":   1250');
  sync.typed();
  await until(() => sync.standing.value === "same");
  assert.equal(server.recipe.steps[0]!.params!["peak_m"], 1250);
  assert.equal(studio.param("isle", "peak_m"), 1250);
  assert.match(editor.text, /"peak_m": {3}1250/);
  editor.focused = false;
  sync.blurred();
  assert.match(editor.text, /"peak_m": 1250/);
  end();
});

test("a text that is no recipe stays here, with its errors; the document goes on under it", async () => {
  const { server, studio, editor, sync, end } = await started();
  editor.text = editor.text.replace('"op": "island.coral"', '"op": "island.coarl"');
  sync.typed();
  await until(() => sync.standing.value === "errors");
  assert.equal(editor.marks, 1);
  await studio.edit([{ do: "set", pointer: "/steps/isle/params/peak_m", value: 990 }], "peak");
  await until(() => editor.text.includes('"peak_m": 990'));
  assert.match(editor.text, /island\.coarl/);
  assert.equal(server.recipe.steps[2]!.op, "island.coral");
  editor.text = editor.text.replace("coarl", "coral");
  sync.typed();
  await until(() => sync.standing.value === "same");
  assert.equal(studio.param("isle", "peak_m"), 990);
  end();
});

test("a slider that moves while one types is not set back", async () => {
  const { server, studio, editor, sync, end } = await started();
  editor.text = editor.text.replace('"seed": 7', '"seed": 8');
  sync.typed();
  await studio.edit([{ do: "set", pointer: "/steps/isle/params/peak_m", value: 990 }], "peak");
  await until(() => server.recipe.seed === 8 && sync.standing.value === "same");
  assert.equal(server.recipe.steps[0]!.params!["peak_m"], 990);
  assert.deepEqual(studio.document.value.recipe, server.recipe);
  end();
});
