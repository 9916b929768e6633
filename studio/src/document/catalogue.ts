// The classes of the catalogue that a scene grows by: for choices of classes, and for the colours of objects.
import { effect, signal } from "@preact/signals";
import type { Json, ParamInfo, Recipe, Schema, ValueEvent } from "../api/types";
import { connectionsOf, stepOf } from "./connections";
import { filesLooked } from "./files_looked";
import { isObject } from "./pointer";
import type { DocumentState, Studio } from "./studio";

export interface CatalogueClass {
  name: string;
  about: string;
  skeleton: "point" | "curve" | "region";
  /** "#rrggbb"; "": none of its own. */
  colour: string;
}

const kSkeletons: readonly string[] = ["point", "curve", "region"];

/** Classes of a catalogue's text as JSON; none where it is no catalogue. */
export function classesOf(catalogue: Json): CatalogueClass[] {
  const classes = isObject(catalogue) ? catalogue["classes"] : null;
  if (!Array.isArray(classes)) return [];
  return classes.filter(isObject).flatMap((one): CatalogueClass[] => {
    const text = (name: string): string => (typeof one[name] === "string" ? one[name] : "");
    if (text("name") === "") return [];
    const skeleton = kSkeletons.includes(text("skeleton")) ? text("skeleton") as CatalogueClass["skeleton"] : "point";
    const colour = /^#[0-9a-f]{6}$/i.test(text("colour")) ? text("colour") : "";
    return [{ name: text("name"), about: text("about"), skeleton, colour }];
  });
}

/** The catalogue's file of a step, or of the step whose objects it goes on with; null: none is known. */
export function catalogueFile(recipe: Recipe, schema: Schema, id: string): string | null {
  const seen = new Set<string>();
  for (let at: string | null = id; at !== null && !seen.has(at);) {
    seen.add(at);
    const step = stepOf(recipe, at);
    if (!step) return null;
    const connections = connectionsOf(recipe, schema, step);
    const own = connections.find(({ input, from }) => input.kind === "catalogue" && from)?.from;
    if (own) return "file" in own ? own.file : null;
    const objects = connections.find(({ input, from }) => input.kind === "objects" && from)?.from;
    at = objects && "step" in objects ? objects.step : null;
  }
  return null;
}

/** A file as the document names it, from the studio's folder; null: it lies outside. */
export function fromFolder(document: Pick<DocumentState, "file">, file: string): string | null {
  if (file.startsWith("/")) return null;
  const parts = document.file.split("/").slice(0, -1);
  for (const part of file.split("/")) {
    if (part === "..") {
      if (parts.pop() === undefined) return null;
    } else if (part !== "" && part !== ".") parts.push(part);
  }
  return parts.join("/");
}

/** A file that a step's classes are of, and which results of that step there were when it was read last. */
interface Use {
  step: string;
  path: string;
  newest: string;
}

class CatalogueShelf {
  private readonly files = signal<ReadonlyMap<string, readonly CatalogueClass[]>>(new Map());
  private readonly uses = new Map<string, Use>();
  private looked = filesLooked.peek();

  constructor(private readonly studio: Studio) {
    effect(() => this.look(studio.values.value, filesLooked.value));
  }

  /** Reads signals; [] until they are known. */
  classes(step: string): readonly CatalogueClass[] {
    const document = this.studio.document.value;
    const file = catalogueFile(document.recipe, this.studio.schema, step);
    const path = file === null ? null : fromFolder(document, file);
    if (path === null) return [];
    const name = `${step} ${path}`;
    if (!this.uses.has(name)) {
      this.uses.set(name, { step, path, newest: newestOf(this.studio.values.peek(), step) });
      void this.fetch(path);
    }
    return this.files.value.get(path) ?? [];
  }

  /** Reads again what may be another by now: files were written, or a step has another result. */
  private look(values: Values, looked: number): void {
    const paths = new Set<string>();
    for (const use of this.uses.values()) {
      const newest = newestOf(values, use.step);
      if (looked !== this.looked || (newest !== "" && newest !== use.newest)) paths.add(use.path);
      if (newest !== "") use.newest = newest;
    }
    this.looked = looked;
    for (const path of paths) void this.fetch(path);
  }

  private async fetch(path: string): Promise<void> {
    let classes: readonly CatalogueClass[] = [];
    try {
      classes = classesOf(JSON.parse(await (await this.studio.api.download(path)).text()) as Json);
    } catch {
      // Not to be read from here: names are typed then.
    }
    const files = this.files.peek();
    if (JSON.stringify(files.get(path)) === JSON.stringify(classes)) return;
    this.files.value = new Map(files).set(path, classes);
  }
}

type Values = ReadonlyMap<string, ValueEvent>;

/** Keys of the full results of a step: another file makes others. */
function newestOf(values: Values, step: string): string {
  return [...values.values()].filter(({ source, coarse }) => !coarse && source.startsWith(`${step}.`))
    .map(({ source, key }) => `${source} ${key}`).sort().join("\n");
}

const shelves = new WeakMap<Studio, CatalogueShelf>();

/** Classes that may grow in a step; [] while they are not known. Reads signals. */
export function catalogueClasses(studio: Studio, step: string): readonly CatalogueClass[] {
  let shelf = shelves.get(studio);
  if (!shelf) shelves.set(studio, (shelf = new CatalogueShelf(studio)));
  return shelf.classes(step);
}

const kPalette = [
  "#f2b13c", "#e4577e", "#58c7a5", "#8d7bf0", "#f07f4f", "#57b4ea", "#b7d64c", "#d86fd6", "#5fd1dc", "#d9a37a",
];

/** A colour for each class: its own, where that is not too dark to be seen on the ground. */
export function classColour(classes: readonly CatalogueClass[], name: string): string {
  const index = classes.findIndex((one) => one.name === name);
  const own = classes[index]?.colour ?? "";
  if (own !== "") return own;
  const hash = index >= 0 ? index : [...name].reduce((sum, letter) => sum * 31 + letter.charCodeAt(0), 7);
  return kPalette[Math.abs(hash) % kPalette.length]!;
}

/** Parameters that name a class of the catalogue. */
export function namesClass(info: Pick<ParamInfo, "name" | "kind">): boolean {
  return (info.kind === "text" && info.name === "class") || (info.kind === "texts" && info.name === "classes");
}
