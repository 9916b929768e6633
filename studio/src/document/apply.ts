// The document changed without being changed: edits and the server's changes give a new recipe that shares with the old
// one what stayed the same. The same rules as src/seamount/recipe/edit.cpp, but for what an edit of a step's
// connections means in shorthand: there this is a guess until the server's own changes arrive.
import type { Change, Edit, Json, Recipe } from "../api/types";
import { indexIn, isObject, NoSuchPlace, pointerTokens } from "./pointer";
import type { JsonObject } from "./pointer";
import { removeStep, renameStep } from "./references";

/** Gives back a container with one member or item replaced, put in or taken out. */
type Turn = (container: Json, token: string) => Json;

function withMember(object: JsonObject, name: string, value: Json): JsonObject {
  return { ...object, [name]: value };
}

function withoutMember(object: JsonObject, name: string): JsonObject {
  const { [name]: _gone, ...rest } = object;
  return rest;
}

/** Members keep the order in which they are written: the new one stands at `index`. */
function putMember(object: JsonObject, name: string, index: number, value: Json): JsonObject {
  const entries = Object.entries(object).filter(([key]) => key !== name);
  entries.splice(Math.min(index, entries.length), 0, [name, value]);
  return Object.fromEntries(entries);
}

function withItem(list: readonly Json[], index: number, value: Json): Json[] {
  const next = [...list];
  next[index] = value;
  return next;
}

function withoutItem(list: readonly Json[], index: number): Json[] {
  return list.filter((_item, i) => i !== index);
}

function insertItem(list: readonly Json[], index: number, value: Json): Json[] {
  return [...list.slice(0, index), value, ...list.slice(index)];
}

/** Rebuilds the containers on the way to a place; `missing` makes objects that are not there. */
function turnAt(value: Json | undefined, tokens: readonly string[], turn: Turn, missing: boolean): Json {
  const [token, ...rest] = tokens;
  if (token === undefined) throw new NoSuchPlace("the document itself");
  if (value === undefined && missing) value = {};
  if (rest.length === 0) {
    if (value === undefined) throw new NoSuchPlace(`there is no '${token}'`);
    return turn(value, token);
  }
  if (Array.isArray(value)) {
    const index = indexIn(value, token);
    if (index < 0) throw new NoSuchPlace(`there is no '${token}' in the list`);
    return withItem(value, index, turnAt(value[index], rest, turn, missing));
  }
  if (!isObject(value)) throw new NoSuchPlace(`'${token}' leads into a plain value`);
  if (!missing && !(token in value)) throw new NoSuchPlace(`there is no '${token}'`);
  return withMember(value, token, turnAt(value[token], rest, turn, missing));
}

function itemIndex(list: readonly Json[], token: string): number {
  const index = indexIn(list, token);
  if (index < 0) throw new NoSuchPlace(`there is no '${token}' in the list`);
  return index;
}

function asList(value: Json): readonly Json[] {
  if (!Array.isArray(value)) throw new NoSuchPlace("is no list");
  return value;
}

function setValue(root: Json, pointer: string, value: Json): Json {
  const tokens = pointerTokens(pointer);
  if (tokens.length === 0) return value;
  return turnAt(root, tokens, (container, token) => {
    if (Array.isArray(container)) return withItem(container, itemIndex(container, token), value);
    if (!isObject(container)) throw new NoSuchPlace(`'${token}' leads into a plain value`);
    return withMember(container, token, value);
  }, true);
}

function takeOut(root: Json, pointer: string): Json {
  try {
    return turnAt(root, pointerTokens(pointer), (container, token) => {
      if (Array.isArray(container)) return withoutItem(container, itemIndex(container, token));
      if (!isObject(container)) throw new NoSuchPlace(`'${token}' leads into a plain value`);
      return withoutMember(container, token);
    }, false);
  } catch (error) {
    if (error instanceof NoSuchPlace) return root;  // it has its default already
    throw error;
  }
}

function insertValue(root: Json, pointer: string, index: number | undefined, value: Json): Json {
  return turnAt(root, pointerTokens(pointer), (container, token) => {
    const at = Array.isArray(container) ? container[itemIndex(container, token)] : (container as JsonObject)[token];
    const list = at === undefined ? [value] : insertItem(asList(at), index ?? asList(at).length, value);
    if (Array.isArray(container)) return withItem(container, itemIndex(container, token), list);
    return withMember(container as JsonObject, token, list);
  }, true);
}

function moveItem(root: Json, pointer: string, index: number): Json {
  return turnAt(root, pointerTokens(pointer), (container, token) => {
    const list = asList(container);
    const from = itemIndex(list, token);
    return insertItem(withoutItem(list, from), index, list[from]!);
  }, false);
}

function applyEdit(root: Json, edit: Edit): Json {
  switch (edit.do) {
    case "set":
      return edit.value === undefined ? takeOut(root, edit.pointer) : setValue(root, edit.pointer, edit.value);
    case "insert":
      return insertValue(root, edit.list, edit.index, edit.value);
    case "remove":
      return takeOut(root, edit.item);
    case "move":
      return moveItem(root, edit.item, edit.index);
    case "rename":
      return renameStep(root as unknown as Recipe, edit.id, edit.new_id) as unknown as Json;
    case "remove_step":
      return removeStep(root as unknown as Recipe, edit.id) as unknown as Json;
  }
}

/** Throws NoSuchPlace where an edit leads nowhere. */
export function applyEdits(recipe: Recipe, edits: readonly Edit[]): Recipe {
  return edits.reduce<Json>((root, edit) => applyEdit(root, edit), recipe as unknown as Json) as unknown as Recipe;
}

/** A change at `pointer`: `from` is there and gives way to `to`; one of them may be absent. */
function turnChange(root: Json, change: Change, from: Json | undefined, to: Json | undefined): Json {
  const tokens = pointerTokens(change.pointer);
  if (tokens.length === 0) return to ?? root;
  return turnAt(root, tokens, (container, token) => {
    if (Array.isArray(container)) {
      if (to === undefined) return withoutItem(container, change.index);
      return from === undefined ? insertItem(container, change.index, to) : withItem(container, change.index, to);
    }
    if (!isObject(container)) throw new NoSuchPlace(change.pointer);
    if (to === undefined) return withoutMember(container, token);
    return from === undefined ? putMember(container, token, change.index, to) : withMember(container, token, to);
  }, false);
}

/** What the server did, done here. REQUIRES: the recipe is as it was there before. */
export function applyChanges(recipe: Recipe, changes: readonly Change[]): Recipe {
  return changes.reduce<Json>(
    (root, change) => turnChange(root, change, change.before, change.after), recipe as unknown as Json,
  ) as unknown as Recipe;
}

/** Takes changes back, the last one first. */
export function takeBackChanges(recipe: Recipe, changes: readonly Change[]): Recipe {
  return changes.reduceRight<Json>(
    (root, change) => turnChange(root, change, change.after, change.before), recipe as unknown as Json,
  ) as unknown as Recipe;
}
