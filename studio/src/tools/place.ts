// Where a value stands in the recipe. A value may be a variable ("$ridges"): then its place is the variable's, and
// drawing changes that.
import type { Json, Recipe } from "../api/types";

export interface Found {
  /** Where an edit of the value goes; a step is named by its id. */
  pointer: string;
  /** undefined: nothing is stated, there is a default. */
  value: Json | undefined;
}

export type Path = readonly (string | number)[];

export function token(member: string | number): string {
  return String(member).replace(/~/g, "~0").replace(/\//g, "~1");
}

function throughVariables(recipe: Recipe, found: Found): Found {
  let current = found;
  for (let hops = 0; hops < 16; ++hops) {
    const text = current.value;
    if (typeof text !== "string" || !/^\$[A-Za-z_]/.test(text)) break;
    const name = text.slice(1);
    current = { pointer: `/variables/${token(name)}`, value: recipe.variables?.[name] };
  }
  return current;
}

/** Member or item below a place. */
export function below(recipe: Recipe, from: Found, path: Path): Found {
  let found = throughVariables(recipe, from);
  for (const key of path) {
    const parent = found.value;
    let value: Json | undefined;
    if (Array.isArray(parent)) value = parent[Number(key)];
    else if (parent !== null && typeof parent === "object") value = parent[key];
    found = throughVariables(recipe, { pointer: `${found.pointer}/${token(key)}`, value });
  }
  return found;
}

export function paramPlace(recipe: Recipe, step: string, path: Path): Found {
  const stated = recipe.steps.find((s) => s.id === step)?.params;
  return below(recipe, { pointer: `/steps/${token(step)}/params`, value: stated as Json | undefined }, path);
}

/** A number that is stated, or stated as a variable. */
export function numberAt(recipe: Recipe, step: string, path: Path): number | undefined {
  const { value } = paramPlace(recipe, step, path);
  return typeof value === "number" ? value : undefined;
}

export interface Domain {
  width_m: number;
  height_m: number;
  cell_m: number;
  x_m: number;
  y_m: number;
}

/** The document's rectangle; what it leaves out is as the library's defaults. */
export function domainOf(recipe: Recipe): Domain {
  const root: Found = { pointer: "/domain", value: (recipe.domain ?? {}) as Json };
  const member = (name: string): number | undefined => {
    const { value } = below(recipe, root, [name]);
    return typeof value === "number" ? value : undefined;
  };
  const width_m = member("width_m") ?? 10240;
  const height_m = member("height_m") ?? width_m;
  const size = member("size");
  const cell_m = size ? Math.max(width_m, height_m) / size : (member("cell_m") ?? 10);
  return { width_m, height_m, cell_m, x_m: member("x_m") ?? 0, y_m: member("y_m") ?? 0 };
}
