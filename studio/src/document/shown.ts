// What the views show of the document: the terrain that follows from what is pinned or selected, and what lies over it.
import type { Recipe, Schema } from "../api/types";
import { connectionsOf, operatorOf, stepOf } from "./connections";
import type { Shown } from "./studio";

/** Kinds that a view can lay over a terrain, the most telling first. */
const kOverlays = ["labels", "field", "current", "contours", "drawing", "tin", "objects", "things", "image"];

/** The first terrain that is met on the way up from a step, itself included; nearest first. The ground of a scene comes
 * before the ground that it grew on. */
function terrainAbove(recipe: Recipe, schema: Schema, id: string): string | null {
  const seen = new Set<string>();
  let level = [id];
  while (level.length > 0) {
    const above: string[] = [];
    for (const at of level) {
      if (seen.has(at)) continue;
      seen.add(at);
      const step = stepOf(recipe, at);
      if (!step) continue;
      const out = operatorOf(schema, step.op)?.out.find((port) => port.kind === "terrain");
      if (out) return `${at}.${out.name}`;
      const steps = (scene: boolean) => connectionsOf(recipe, schema, step)
        .flatMap(({ input, from }) => (from && "step" in from && (input.kind === "objects") === scene ? [from.step] : []));
      above.push(...steps(true), ...steps(false));
    }
    level = above;
  }
  return null;
}

/** The first terrain that is made of what a step makes: what a network or a plan becomes. */
function terrainBelow(recipe: Recipe, schema: Schema, id: string): string | null {
  const reached = new Set([id]);
  let grown = true;
  while (grown) {
    grown = false;
    for (const step of recipe.steps) {
      if (reached.has(step.id)) continue;
      const reads = connectionsOf(recipe, schema, step).some(({ from }) => from && "step" in from && reached.has(from.step));
      if (!reads) continue;
      const out = operatorOf(schema, step.op)?.out.find((port) => port.kind === "terrain");
      if (out) return `${step.id}.${out.name}`;
      reached.add(step.id);
      grown = true;
    }
  }
  return null;
}

/** The ground that a step without a terrain of its own is about. */
function terrainAround(recipe: Recipe, schema: Schema, id: string): string | null {
  return terrainAbove(recipe, schema, id) ?? terrainBelow(recipe, schema, id);
}

type Ground = Pick<Shown, "terrain" | "overlay">;

function shownOfSource(recipe: Recipe, schema: Schema, id: string, port: string | null): Ground {
  const step = stepOf(recipe, id);
  const outputs = (step && operatorOf(schema, step.op)?.out) ?? [];
  if (port === null) {
    const terrain = outputs.find((output) => output.kind === "terrain");
    if (terrain) return { terrain: `${id}.${terrain.name}`, overlay: null };
    const overlay = kOverlays.flatMap((kind) => outputs.filter((output) => output.kind === kind))[0];
    return { terrain: terrainAround(recipe, schema, id), overlay: overlay ? `${id}.${overlay.name}` : null };
  }
  const kind = outputs.find((output) => output.name === port)?.kind;
  if (kind === "terrain") return { terrain: `${id}.${port}`, overlay: null };
  return { terrain: terrainAround(recipe, schema, id), overlay: kind ? `${id}.${port}` : null };
}

/** With nothing selected: the last step that makes a terrain. */
function groundOf(recipe: Recipe, schema: Schema, selected: string | null, pinned: string | null): Ground {
  const [id, port] = (pinned ?? "").split(".");
  if (id && stepOf(recipe, id)) return shownOfSource(recipe, schema, id, port ?? null);
  if (selected && stepOf(recipe, selected)) {
    const shown = shownOfSource(recipe, schema, selected, null);
    if (shown.terrain || shown.overlay) return shown;
  }
  for (let i = recipe.steps.length - 1; i >= 0; --i) {
    const step = recipe.steps[i]!;
    const out = operatorOf(schema, step.op)?.out.find((output) => output.kind === "terrain");
    if (out) return { terrain: `${step.id}.${out.name}`, overlay: null };
  }
  return { terrain: null, overlay: null };
}

/** Objects that are made together with a terrain; a scene. */
function objectsOf(recipe: Recipe, schema: Schema, terrain: string | null): string | null {
  const id = terrain?.split(".")[0] ?? "", step = stepOf(recipe, id);
  const out = (step && operatorOf(schema, step.op)?.out)?.find((port) => port.kind === "objects");
  return out ? `${id}.${out.name}` : null;
}

/** What these objects look like: the first step that makes things of them. */
function thingsOf(recipe: Recipe, schema: Schema, objects: string): string | null {
  for (const step of recipe.steps) {
    const out = operatorOf(schema, step.op)?.out.find((port) => port.kind === "things");
    if (!out || step.bypass) continue;
    const made = connectionsOf(recipe, schema, step).some(({ input, from }) =>
      input.kind === "objects" && from && "step" in from && `${from.step}.${from.port}` === objects);
    if (made) return `${step.id}.${out.name}`;
  }
  return null;
}

/** The ground, what is laid over it, and what lives on it. */
export function shownOf(recipe: Recipe, schema: Schema, selected: string | null, pinned: string | null): Shown {
  const ground = groundOf(recipe, schema, selected, pinned);
  const objects = objectsOf(recipe, schema, ground.terrain);
  const things = objects === null ? null : thingsOf(recipe, schema, objects);
  return { ...ground, objects, things };
}
