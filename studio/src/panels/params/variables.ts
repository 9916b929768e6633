// Binding a parameter to a variable of the document, and letting it go: which variables fit, and the edits. Pure.
import type { Edit, Json, ParamInfo, Recipe } from "../../api/types";

export type Variables = { readonly [name: string]: Json };

const kBindable: readonly ParamInfo["kind"][] = [
  "number", "integer", "switch", "choice", "text", "file", "colour", "point", "curve", "numbers", "integers", "texts",
];

export function isBindable(info: Pick<ParamInfo, "kind">): boolean {
  return kBindable.includes(info.kind);
}

function sort(value: Json | undefined): string {
  return Array.isArray(value) ? "list" : value === null ? "null" : typeof value;
}

/** Whether a variable with this value may stand for the parameter. */
function fits(info: ParamInfo, value: Json): boolean {
  switch (info.kind) {
    case "number": return typeof value === "number";
    case "integer": return Number.isInteger(value);
    case "switch": return typeof value === "boolean";
    case "choice": return typeof value === "string" && (info.choices ?? []).includes(value);
    case "point": case "curve": case "numbers": case "integers": case "texts": return sort(value) === "list";
    default: return typeof value === "string";
  }
}

export function fittingVariables(info: ParamInfo, variables: Variables): string[] {
  return Object.keys(variables).filter((name) => fits(info, variables[name]!));
}

/** A name that is not taken: the parameter's, or with a number behind it. */
export function freshVariable(wanted: string, variables: Variables): string {
  const word = wanted.replace(/[^A-Za-z0-9_]/g, "_").replace(/^(?=[0-9])/, "_") || "value";
  for (let number = 1; ; ++number) {
    const name = number === 1 ? word : `${word}_${number}`;
    if (!(name in variables)) return name;
  }
}

export function bindEdits(pointer: string, name: string): Edit[] {
  return [{ do: "set", pointer, value: `$${name}` }];
}

/** A new variable with the parameter's value, which from then on is the variable's. */
export function bindNewEdits(pointer: string, name: string, value: Json): Edit[] {
  return [{ do: "set", pointer: `/variables/${name}`, value }, ...bindEdits(pointer, name)];
}

function count(value: Json, word: string): number {
  if (value === word) return 1;
  if (value === null || typeof value !== "object") return 0;
  return Object.values(value).reduce<number>((sum, item) => sum + count(item, word), 0);
}

/** In how many places a variable stands. */
export function usesOf(recipe: Recipe, name: string): number {
  return count(recipe as unknown as Json, `$${name}`);
}
