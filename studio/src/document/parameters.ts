// The value that a parameter has in effect: what the step states, else its preset's, else the default.
import type { Json, ParamInfo, Recipe, Schema, Step } from "../api/types";
import { operatorOf } from "./connections";
import { isObject } from "./pointer";

/** "$age" is the variable's value, "$$" a dollar. */
export function resolveVariables(recipe: Recipe, value: Json | undefined, depth = 0): Json | undefined {
  if (typeof value !== "string" || !value.startsWith("$")) return value;
  if (value.startsWith("$$")) return value.slice(1);
  if (depth > 16) return undefined;
  return resolveVariables(recipe, recipe.variables?.[value.slice(1)], depth + 1);
}

/** The description of a parameter by its path; items of lists are skipped ("rules/2/count" is "count" of "rules"). */
export function paramInfo(params: readonly ParamInfo[], path: string): ParamInfo | undefined {
  let known: readonly ParamInfo[] = params;
  let found: ParamInfo | undefined;
  for (const token of path.split("/")) {
    if (found && /^\d+$/.test(token)) continue;
    found = known.find((param) => param.name === token);
    if (!found) return undefined;
    known = found.tools?.find((tool) => tool.name === "")?.params ?? found.tools?.[0]?.params ?? [];
  }
  return found;
}

function valueByPath(recipe: Recipe, root: Json | undefined, path: string): Json | undefined {
  let value = resolveVariables(recipe, root);
  for (const token of path.split("/")) {
    if (Array.isArray(value)) value = value[Number(token)];
    else if (isObject(value)) value = value[token];
    else return undefined;
    value = resolveVariables(recipe, value);
  }
  return value;
}

/** A preset stands in a list of params and sets some of them, also members of groups ("widths.reef_m"). */
function presetValue(
  recipe: Recipe, params: readonly ParamInfo[], stated: Json | undefined, path: string,
): Json | undefined {
  const preset = params.find((param) => param.kind === "preset");
  if (!preset || preset.name === path) return undefined;
  const word = valueByPath(recipe, stated, preset.name);
  const values = preset.presets?.find((one) => one.name === word)?.values;
  if (!values) return undefined;
  return values[path.replace(/\//g, ".")] ?? values[path] ?? valueByPath(recipe, values, path);
}

export function parameterValue(recipe: Recipe, schema: Schema, step: Step, path: string): Json | undefined {
  const stated = valueByPath(recipe, step.params, path);
  if (stated !== undefined) return stated;
  const params = operatorOf(schema, step.op)?.params ?? [];
  const tokens = path.split("/");
  const outer = presetValue(recipe, params, step.params, path);
  if (outer !== undefined) return outer;
  if (tokens.length > 1) {  // a group's own preset
    const group = paramInfo(params, tokens[0]!)?.tools?.[0]?.params ?? [];
    const inner = presetValue(recipe, group, step.params?.[tokens[0]!], tokens.slice(1).join("/"));
    if (inner !== undefined) return inner;
  }
  return paramInfo(params, path)?.default;
}
