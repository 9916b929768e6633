// What the views show of the document: the terrain that follows from what is pinned or selected, and what lies over it.
import type { Recipe, Schema } from "../api/types";
import { connectionsOf, operatorOf, stepOf } from "./connections";
import type { Shown } from "./studio";

/** Kinds that a view can lay over a terrain, the most telling first. */
const kOverlays = ["labels", "field", "current", "contours", "drawing", "tin", "objects", "things", "image"];

/** The first terrain that is met on the way up from a step, itself included; nearest first. */
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
      for (const { from } of connectionsOf(recipe, schema, step)) if (from && "step" in from) above.push(from.step);
    }
    level = above;
  }
  return null;
}

function shownOfSource(recipe: Recipe, schema: Schema, id: string, port: string | null): Shown {
  const step = stepOf(recipe, id);
  const outputs = (step && operatorOf(schema, step.op)?.out) ?? [];
  if (port === null) {
    const terrain = outputs.find((output) => output.kind === "terrain");
    if (terrain) return { terrain: `${id}.${terrain.name}`, overlay: null };
    const overlay = kOverlays.flatMap((kind) => outputs.filter((output) => output.kind === kind))[0];
    return { terrain: terrainAbove(recipe, schema, id), overlay: overlay ? `${id}.${overlay.name}` : null };
  }
  const kind = outputs.find((output) => output.name === port)?.kind;
  if (kind === "terrain") return { terrain: `${id}.${port}`, overlay: null };
  return { terrain: terrainAbove(recipe, schema, id), overlay: kind ? `${id}.${port}` : null };
}

/** With nothing selected: the last step that makes a terrain. */
export function shownOf(recipe: Recipe, schema: Schema, selected: string | null, pinned: string | null): Shown {
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
