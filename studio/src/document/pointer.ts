// JSON pointers ("/steps/reef/params/subsidence"), in which an item of a list may be named by its id.
import type { Json } from "../api/types";

export type JsonObject = { [key: string]: Json };

export class NoSuchPlace extends Error {}

export function isObject(value: Json | undefined): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

export function pointerTokens(pointer: string): string[] {
  if (pointer === "") return [];
  if (!pointer.startsWith("/")) throw new NoSuchPlace(`'${pointer}' is no JSON pointer`);
  return pointer.slice(1).split("/").map((token) => token.replace(/~1/g, "/").replace(/~0/g, "~"));
}

export function pointerToken(name: string): string {
  return name.replace(/~/g, "~0").replace(/\//g, "~1");
}

/** The index that a token names in a list: that of the item with this id, or the number itself; -1: none. */
export function indexIn(list: readonly Json[], token: string): number {
  const named = list.findIndex((item) => isObject(item) && item["id"] === token);
  if (named >= 0) return named;
  return /^\d{1,8}$/.test(token) && Number(token) < list.length ? Number(token) : -1;
}

/** The value at a pointer; undefined where there is none. */
export function valueAt(root: Json, pointer: string): Json | undefined {
  let value: Json | undefined = root;
  for (const token of pointerTokens(pointer)) {
    if (Array.isArray(value)) {
      value = value[indexIn(value, token)];
    } else if (isObject(value) && Object.prototype.hasOwnProperty.call(value, token)) {
      value = value[token];
    } else {
      return undefined;
    }
  }
  return value;
}

export function equalJson(a: Json | undefined, b: Json | undefined): boolean {
  if (a === b) return true;
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
  if (Array.isArray(a) || Array.isArray(b)) {
    if (!Array.isArray(a) || !Array.isArray(b) || a.length !== b.length) return false;
    return a.every((item, i) => equalJson(item, b[i]));
  }
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => name in b && equalJson(a[name], b[name]));
}

/** Freezes what is not frozen yet: what is shared with a frozen document is not walked again. */
export function freeze<T extends Json>(value: T): T {
  if (typeof value !== "object" || value === null || Object.isFrozen(value)) return value;
  Object.freeze(value);
  for (const item of Object.values(value)) freeze(item);
  return value;
}
