// Where steps are named in a recipe, and what becomes of these places when a step is renamed or taken out.
import type { Json, Recipe } from "../api/types";
import { isObject, NoSuchPlace } from "./pointer";
import type { JsonObject } from "./pointer";

const kNamingMembers = ["labels", "from", "rivers", "lake"];

/** The port that a source takes of this step: "" for the step as a whole; null: another step, or a file. */
function portOf(source: Json | undefined, id: string): string | null {
  if (source === id) return "";
  return typeof source === "string" && source.startsWith(`${id}.`) ? source.slice(id.length + 1) : null;
}

/** New value for each source that names the step; undefined takes it out. */
type Replace = (port: string) => Json | undefined;

function replaceInputs(inputs: Json, id: string, replace: Replace): Json | undefined {
  const port = portOf(inputs, id);
  if (port !== null) return replace(port);
  if (Array.isArray(inputs)) {
    return inputs.map((item) => replaceInputs(item, id, replace)).filter((item): item is Json => item !== undefined);
  }
  if (!isObject(inputs)) return inputs;
  const entries = Object.entries(inputs).map(([name, source]) => [name, replaceInputs(source, id, replace)] as const);
  return Object.fromEntries(entries.filter((entry): entry is [string, Json] => entry[1] !== undefined));
}

function replaceIn(item: Json, id: string, replace: Replace): Json {
  if (!isObject(item)) return item;
  const next: JsonObject = {};
  for (const [name, value] of Object.entries(item)) {
    const port = kNamingMembers.includes(name) ? portOf(value, id) : null;
    const after = port !== null ? replace(port) : name === "in" ? replaceInputs(value, id, replace) : value;
    if (after !== undefined) next[name] = after;
  }
  return next;
}

function replaceEverywhere(recipe: Recipe, id: string, replace: Replace): Recipe {
  const root = recipe as unknown as JsonObject;
  const lists: JsonObject = {};
  for (const name of ["steps", "outputs"]) {
    const items = root[name];
    if (Array.isArray(items)) lists[name] = items.map((item) => replaceIn(item, id, replace));
  }
  return { ...root, ...lists } as unknown as Recipe;
}

export function renameStep(recipe: Recipe, id: string, newId: string): Recipe {
  if (!recipe.steps.some((step) => step.id === id)) throw new NoSuchPlace(`there is no step '${id}'`);
  const renamed = replaceEverywhere(recipe, id, (port) => (port === "" ? newId : `${newId}.${port}`));
  return { ...renamed, steps: renamed.steps.map((step) => (step.id === id ? { ...step, id: newId } : step)) };
}

/** What read from the step reads what it read, as far as ports of the same name tell; the server knows better. */
export function removeStep(recipe: Recipe, id: string): Recipe {
  const gone = recipe.steps.find((step) => step.id === id);
  if (!gone) throw new NoSuchPlace(`there is no step '${id}'`);
  const inputs = gone.in as Json | undefined;
  const passedOn: Replace = (port) => {
    if (typeof inputs === "string") return port === "" || inputs.includes(".") ? inputs : `${inputs}.${port}`;
    return isObject(inputs) ? inputs[port === "" ? "terrain" : port] : undefined;
  };
  const outputs = recipe.outputs?.filter((output) => {
    const port = portOf(output.from as Json | undefined, id);
    return port === null || typeof passedOn(port) === "string";
  });
  const left = { ...recipe, steps: recipe.steps.filter((step) => step !== gone), ...(outputs ? { outputs } : {}) };
  return replaceEverywhere(left, id, passedOn);
}
