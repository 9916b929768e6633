// Parameters as they stand in a document: what is stated, what a preset says, what is left to the default; and the
// edits that change one. A scope is the members of one object: a step's params, a group, an item of a list.
import type { Json, ParamInfo } from "../../api/types";
import type { Studio } from "../../document/studio";
import { changeLabel, titleOf } from "./words";

export type Members = { readonly [name: string]: Json | undefined };

export interface Scope {
  studio: Studio;
  /** What the history calls it: the step's id. */
  owner: string;
  /** Id of the step; "": of the document or an output. */
  step: string;
  /** JSON pointer of the object with the members. */
  pointer: string;
  params: readonly ParamInfo[];
  stated: Members;
  /** What the chosen presets say, in place of defaults. */
  inherited: Members;
  parent: Scope | null;
  /** Named by its parent's member: taken out when its last member is. */
  group: boolean;
}

export type Standing = "stated" | "variable" | "preset" | "default" | "derived";

export interface Field {
  info: ParamInfo;
  scope: Scope;
  pointer: string;
  /** As it is written; undefined: left out. */
  stated: Json | undefined;
  /** What counts, variables resolved; null: derived. */
  value: Json;
  /** What it would be if it were not stated. */
  fallback: Json;
  standing: Standing;
  variable: string | null;
}

export function isMembers(value: Json | undefined): value is { [name: string]: Json } {
  return value !== null && typeof value === "object" && !Array.isArray(value);
}

export function escapeToken(token: string): string {
  return token.replace(/~/g, "~0").replace(/\//g, "~1");
}

/** The name of a variable in "$name"; "$$" begins a text. */
export function variableName(value: Json | undefined): string | null {
  return typeof value === "string" && /^\$[A-Za-z_]/.test(value) ? value.slice(1) : null;
}

/** A variable's value, which may be another's. */
export function resolved(value: Json | undefined, variables: Members | undefined): Json | undefined {
  let current = value;
  for (let depth = 0; depth < 8; ++depth) {
    const name = variableName(current);
    if (name === null || !variables || variables[name] === undefined) return current;
    current = variables[name];
  }
  return current;
}

/** A preset's values by nested names; they are given as "slopes.creep_m2_yr" or as groups. */
export function presetMembers(params: readonly ParamInfo[], stated: Members): Members {
  const info = params.find((param) => param.kind === "preset");
  const word = info && stated[info.name];
  const preset = info?.presets?.find((candidate) => candidate.name === word);
  const members: { [name: string]: Json } = {};
  for (const [path, value] of Object.entries(preset?.values ?? {})) {
    const tokens = path.split(/[./]/);
    const last = tokens.pop()!;
    let group = members;
    for (const token of tokens) group = (group[token] ??= {}) as { [name: string]: Json };
    const before = group[last];
    group[last] = isMembers(before) && isMembers(value) ? { ...before, ...value } : value;
  }
  return members;
}

export function scopeOf(studio: Studio, owner: string, step: string, pointer: string, params: readonly ParamInfo[],
                        stated: Json | undefined): Scope {
  const members = isMembers(stated) ? stated : {};
  return { studio, owner, step, pointer, params, stated: members, inherited: presetMembers(params, members),
    parent: null, group: false };
}

/** Of a group, or of an item of a list at `token`. */
export function innerScope(scope: Scope, token: string, params: readonly ParamInfo[], group: boolean,
  item?: Json): Scope {
  const written = item ?? resolved(scope.stated[token], scope.studio.document.value.recipe.variables);
  const stated = isMembers(written) ? written : {};
  const outer = scope.inherited[token];
  const inherited = { ...(group && isMembers(outer) ? outer : {}), ...presetMembers(params, stated) };
  return { ...scope, pointer: `${scope.pointer}/${escapeToken(token)}`, params, stated, inherited, parent: scope,
    group };
}

export function fieldOf(scope: Scope, info: ParamInfo): Field {
  const stated = scope.stated[info.name];
  const variables = scope.studio.document.value.recipe.variables;
  const fromPreset = scope.inherited[info.name];
  const usesPreset = fromPreset !== undefined && info.kind !== "group";
  const fallback = usesPreset ? fromPreset : info.default;
  const variable = variableName(stated);
  const value = stated === undefined ? fallback : resolved(stated, variables) ?? null;
  const standing: Standing = variable !== null ? "variable" : stated !== undefined && stated !== null ? "stated"
    : usesPreset ? "preset" : fallback === null ? "derived" : "default";
  return { info, scope, pointer: `${scope.pointer}/${escapeToken(info.name)}`, stated, value, fallback, standing,
    variable };
}

export function setField(field: Field, value: Json, gesture?: string, before: Json = field.value): void {
  const { scope, info, pointer } = field;
  void scope.studio.edit([{ do: "set", pointer, value }], changeLabel(scope.owner, info, before, value), gesture);
}

/** To the default again. A group whose last member goes, goes too. */
export function resetField(field: Field, gesture?: string): void {
  if (field.stated === undefined) return;
  let { scope, pointer } = field;
  while (scope.group && scope.parent && Object.keys(scope.stated).length <= 1) {
    pointer = scope.pointer;
    scope = scope.parent;
  }
  const label = `${scope.owner}: ${titleOf(field.info.name).toLowerCase()} as by default`;
  void scope.studio.edit([{ do: "set", pointer }], label, gesture);
}

/** Whether anything in it is stated: a group's members, a list's items. */
export function isChanged(field: Field): boolean {
  const { stated } = field;
  if (stated === undefined || stated === null) return false;
  if (Array.isArray(stated)) return true;
  return isMembers(stated) ? Object.keys(stated).length > 0 : true;
}

/** Whether a parameter or one within it fits the words of a search. */
export function matchesSearch(info: ParamInfo, words: string): boolean {
  const text = words.trim().toLowerCase();
  if (text === "") return true;
  if (`${info.name} ${titleOf(info.name)} ${info.help}`.toLowerCase().includes(text)) return true;
  return (info.tools ?? [])
    .some((tool) => tool.name.includes(text) || tool.params.some((inner) => matchesSearch(inner, text)));
}

let gestures = 0;
/** An id for edits that are undone as one. */
export function newGesture(): string {
  return `g${++gestures}-${Math.random().toString(36).slice(2, 8)}`;
}
