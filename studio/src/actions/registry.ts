// Everything that can be done, in one list: menus, bars, the palette, the sheet of shortcuts and the keyboard read it.
import { computed, signal } from "@preact/signals";
import type { LucideIcon } from "lucide-preact";
import type { FunctionComponent } from "preact";
import { isTyping, matches } from "./keys";
import type { KeyPress } from "./keys";

/** One of lucide's, or an own drawing in its manner (24 x 24, strokes). */
export type IconType = LucideIcon | FunctionComponent<{ "aria-hidden"?: boolean }>;

export interface Action {
  /** "file.save"; what stands before the dot is no part of its name. */
  id: string;
  /** "Save". */
  title: string;
  /** Heading in the sheet of shortcuts: "File", "Edit", "View", "Tools". */
  group: string;
  icon?: IconType;
  /** The first one is shown. */
  keys?: readonly string[];
  /** Whether one of the keys counts at the moment; left out: all do. */
  keysWhen?: (keys: string) => boolean;
  /** Left out: always. Read when the action is shown or its keys are pressed. */
  when?: () => boolean;
  /** Of switches: on or off. */
  checked?: () => boolean;
  /** Words that the palette also finds it by. */
  words?: string;
  /** Also while something is typed; keys with Ctrl need not say so, unless they are the field's own (Ctrl+Z). */
  typing?: boolean;
  run: () => void;
}

/** A list, or what makes one of the signals that it reads. */
type ActionSource = readonly Action[] | (() => readonly Action[]);

const sources = signal<readonly ActionSource[]>([]);

/** In the order in which they were registered. */
export const allActions = computed(
  () => sources.value.flatMap((source) => (typeof source === "function" ? source() : source)),
);

/** Returns what takes them out again. */
export function registerActions(actions: ActionSource): () => void {
  sources.value = [...sources.value, actions];
  return () => (sources.value = sources.value.filter((source) => source !== actions));
}

export function findAction(id: string): Action | undefined {
  return allActions.value.find((action) => action.id === id);
}

export function isPossible(action: Action): boolean {
  return action.when?.() ?? true;
}

/** False: there is none, or it is not possible now. */
export function runAction(id: string): boolean {
  const action = findAction(id);
  if (!action || !isPossible(action)) return false;
  action.run();
  return true;
}

const kFieldsOwn = ["Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+A", "Ctrl+C", "Ctrl+X", "Ctrl+V"];

function isMeant(action: Action, press: KeyPress, typing: boolean): boolean {
  return (action.keys ?? []).some((keys) => {
    if (!matches(press, keys) || action.keysWhen?.(keys) === false) return false;
    const isLetter = !/^(Ctrl\+|Alt\+|F\d)/.test(keys);
    return !typing || action.typing === true || (!isLetter && !kFieldsOwn.includes(keys));
  });
}

/** The action that a key is for; what was registered last comes first, so that an open panel can have a key. */
export function actionFor(press: KeyPress, typing: boolean): Action | undefined {
  const meant = allActions.value.filter((action) => isMeant(action, press, typing) && isPossible(action));
  return meant[meant.length - 1];
}

/** Keys of the whole page. While a dialog is open only its own keys count; while the view is moved by a held button
 * letters fly it. `first` is asked before the actions, while nothing is typed: true, it was its key. */
export function listenToKeys(target: Document, first: (event: KeyboardEvent) => boolean): () => void {
  let held = 0;
  const pointer = (event: PointerEvent): void => {
    held = event.buttons & 6;
  };
  const listen = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.isComposing || target.querySelector("dialog[open]")) return;
    if (held !== 0 && event.key.length === 1 && !event.ctrlKey) return;
    const typing = isTyping(event.composedPath()[0] ?? event.target);
    if (!typing && first(event)) {
      event.preventDefault();
      return;
    }
    const action = actionFor(event, typing);
    if (!action) return;
    event.preventDefault();
    if (!event.repeat || action.group === "Edit") action.run();
  };
  const pointers = ["pointerdown", "pointerup", "pointercancel"] as const;
  for (const name of pointers) target.addEventListener(name, pointer, true);
  target.addEventListener("keydown", listen);
  return () => {
    for (const name of pointers) target.removeEventListener(name, pointer, true);
    target.removeEventListener("keydown", listen);
  };
}
