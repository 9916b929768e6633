import assert from "node:assert/strict";
import { test } from "node:test";
import type { Recipe, Schema, ValueEvent } from "../api/types";
import { signal } from "@preact/signals";
import { catalogueClasses, catalogueFile, classColour, classesOf, fromFolder } from "./catalogue";
import { lookOnReturn } from "./files_looked";
import type { Studio } from "./studio";

const port = (name: string, kind: string, required = false) => ({ name, kind, help: "", required });
const grow = {
  name: "ecosystem.grow", summary: "", source: "", stochastic: true, params: [],
  in: [port("terrain", "terrain", true), port("catalogue", "catalogue"), port("objects", "objects")],
  out: [port("objects", "objects"), port("terrain", "terrain")],
};
const schema: Schema = { version: "", formats: [], kinds: [], domain: [], operators: [grow] };

test("classes have names, skeletons and colours", () => {
  const classes = classesOf({ classes: [
    { name: "reef", skeleton: "curve", colour: "#ff8800", about: "lime" }, { name: "palm" }, { colour: "#000000" }, 3,
  ] });
  assert.deepEqual(classes, [
    { name: "reef", about: "lime", skeleton: "curve", colour: "#ff8800" },
    { name: "palm", about: "", skeleton: "point", colour: "" },
  ]);
  assert.equal(classColour(classes, "reef"), "#ff8800");
  assert.match(classColour(classes, "palm"), /^#[0-9a-f]{6}$/);
  assert.notEqual(classColour(classes, "palm"), classColour(classes, "other"));
  assert.deepEqual(classesOf([1, 2]), []);
});

test("a scene that goes on has the catalogue of the one before", () => {
  const recipe: Recipe = { seamount: 1, steps: [
    { id: "life", op: "ecosystem.grow", in: { terrain: "floor.terrain", catalogue: { file: "c.json" } } },
    { id: "close", op: "ecosystem.grow", in: { terrain: "floor.terrain", objects: "life.objects" } },
    { id: "loop", op: "ecosystem.grow", in: { objects: "loop.objects" } },
  ] };
  assert.equal(catalogueFile(recipe, schema, "close"), "c.json");
  assert.equal(catalogueFile(recipe, schema, "loop"), null);
  assert.equal(catalogueFile(recipe, schema, "none"), null);
});

test("files are named from the document's place, and never from above the folder", () => {
  assert.equal(fromFolder({ file: "ecosystem/a.json" }, "../data/c.json"), "data/c.json");
  assert.equal(fromFolder({ file: "" }, "./example-data/c.json"), "example-data/c.json");
  assert.equal(fromFolder({ file: "a.json" }, "../c.json"), null);
  assert.equal(fromFolder({ file: "a.json" }, "/etc/c.json"), null);
});

test("a catalogue is read again when the window is come back to or its step has another result", async () => {
  const step = { id: "life", op: "ecosystem.grow", in: { catalogue: { file: "c.json" } } };
  const recipe: Recipe = { seamount: 1, steps: [step] };
  const values = signal<ReadonlyMap<string, ValueEvent>>(new Map());
  let text = '{"classes": [{"name": "palm"}]}', reads = 0;
  const download = (): Promise<Blob> => {
    ++reads;
    return Promise.resolve(new Blob([text]));
  };
  const document = signal({ recipe, file: "a.json" });
  const studio = { schema, document, values, api: { download } } as unknown as Studio;
  const names = async (): Promise<string> => {
    for (let i = 0; i < 20; ++i) await Promise.resolve();
    await new Promise((done) => setTimeout(done, 5));
    return catalogueClasses(studio, "life").map(({ name }) => name).join(" ");
  };
  const made = (key: string, coarse: boolean): ValueEvent =>
    ({ event: "value", source: "life.objects", key, kind: "objects", revision: 1, coarse });
  await names();
  assert.equal(await names(), "palm");
  assert.equal(reads, 1, "it is kept");
  text = '{"classes": [{"name": "fern"}]}';
  values.value = new Map([["life.objects", made("a", true)]]);
  assert.equal(await names(), "palm", "coarse results come in a row");
  values.value = new Map([["life.objects", made("b", false)]]);
  assert.equal(await names(), "fern");
  text = "{}";
  const window = new EventTarget(), stop = lookOnReturn({ refresh: () => Promise.resolve() }, window);
  window.dispatchEvent(new Event("focus"));
  assert.equal(await names(), "");
  const before = reads;
  window.dispatchEvent(new Event("focus"));
  await names();
  assert.equal(reads, before, "not twice in a second");
  stop();
});
