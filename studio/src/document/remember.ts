// Signals that this browser remembers: how the page is laid out and shows the ground, never anything of a document.
import { effect, signal } from "@preact/signals";
import type { Signal } from "@preact/signals";

function storage(): Storage | null {
  try {
    return typeof localStorage === "undefined" ? null : localStorage;
  } catch {
    return null;  // forbidden by the browser: nothing is remembered
  }
}

/** `read` gives undefined for what an earlier version, or somebody else, has left there. */
export function remembered<T>(name: string, initial: T, read: (value: unknown) => T | undefined): Signal<T> {
  const key = `seamount.${name}`;
  let known: T | undefined;
  try {
    known = read(JSON.parse(storage()?.getItem(key) ?? "null"));
  } catch {
    known = undefined;
  }
  const value = signal(known ?? initial);
  let first = true;
  effect(() => {
    const text = JSON.stringify(value.value);
    if (!first) storage()?.setItem(key, text);
    first = false;
  });
  return value;
}

export function numberWithin(low: number, high: number): (value: unknown) => number | undefined {
  return (value) => (typeof value === "number" && value >= low && value <= high ? value : undefined);
}

export function oneOf<T extends string>(...words: readonly T[]): (value: unknown) => T | undefined {
  return (value) => words.find((word) => word === value);
}
