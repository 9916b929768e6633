// What the keyboard does to the tools, as a list that the page's registry of actions takes over.
import type { Studio } from "../document/studio";
import { activeTool, choose, chosenValue, isReach, ownReach, reach, selection, suitableReach } from "./active";
import { kRegions } from "./names";
import { kEraser, kMeasures, kSelect, type Offer } from "./offers";
import { domainOf } from "./place";
import { toolsOf, type ToolBox } from "./toolbox";

export interface ToolAction {
  id: string;
  title: string;
  /** "B", "Shift+R", "["; "" for none. */
  keys: string;
  icon: string;
  run(): void;
  /** False: it has no meaning now, and its key is free. */
  enabled(): boolean;
}

/** Finer below, coarser above: the numbers of a brush grow by a fifth. */
export function scaled(value: number, larger: boolean): number {
  const next = larger ? value * 1.25 : value / 1.25;
  return Number(next.toPrecision(2)) === Number(value.toPrecision(2)) ? next : Number(next.toPrecision(2));
}

function resize(tools: ToolBox, larger: boolean): void {
  const { slot } = tools.active.peek();
  const domain = domainOf(tools.studio.document.peek().recipe);
  const member = slot?.members.find(isReach);
  if (slot && member) {
    const value = chosenValue(slot, member, domain);
    const next = scaled(typeof value === "number" ? value : suitableReach(0, domain), larger);
    choose(slot, member.name, Math.min(member.max ?? Infinity, Math.max(member.min ?? 0, next)));
  } else reach.value = scaled(ownReach(slot?.geometry, domain), larger);
}

function harden(tools: ToolBox, by: number): void {
  const { slot } = tools.active.peek();
  const member = slot?.members.find((one) => one.name === "hardness");
  if (!slot || !member) return;
  const value = chosenValue(slot, member, domainOf(tools.studio.document.peek().recipe));
  choose(slot, "hardness", Number(Math.min(1, Math.max(0, (typeof value === "number" ? value : 0) + by)).toFixed(2)));
}

function takeByKey(tools: ToolBox, offer: Offer): ToolAction {
  return {
    id: `tool:${offer.id}`, title: offer.look.title, keys: offer.look.keys, icon: offer.look.icon,
    run: () => tools.take(offer.id), enabled: () => tools.offers.peek().rail.some((one) => one.id === offer.id),
  };
}

const kFixed = new Set([kSelect, kEraser, ...kMeasures].map((offer) => offer.id));

/** Actions that are always there. Those of the step's own tools follow in `offeredActions`. */
export function toolActions(studio: Studio): ToolAction[] {
  const tools = toolsOf(studio);
  const always = { enabled: () => true };
  return [
    takeByKey(tools, kSelect), takeByKey(tools, kEraser), ...kMeasures.map((offer) => takeByKey(tools, offer)),
    { id: "brush:smaller", title: "Smaller brush", keys: "[", icon: "brush", run: () => resize(tools, false), ...always },
    { id: "brush:larger", title: "Larger brush", keys: "]", icon: "brush", run: () => resize(tools, true), ...always },
    { id: "brush:softer", title: "Softer brush", keys: "Shift+[", icon: "brush", run: () => harden(tools, -0.1), ...always },
    { id: "brush:harder", title: "Harder brush", keys: "Shift+]", icon: "brush", run: () => harden(tools, 0.1), ...always },
    {
      id: "drawing:select_all", title: "Select all that is drawn", keys: "Ctrl+A", icon: "select",
      run: () => {
        activeTool.value = kSelect.id;
        selection.value = new Set(tools.features.peek().map((feature) => feature.key));
      },
      enabled: () => tools.features.peek().length > 0,
    },
  ];
}

/** Actions of the tools that are offered now, each of which has its own key. Reads signals: changes with the selection. */
export function offeredActions(studio: Studio): ToolAction[] {
  const tools = toolsOf(studio);
  const taken = new Set<string>();
  return tools.offers.value.rail
    .filter((offer) => !kFixed.has(offer.id) && !(offer.look.keys && taken.has(offer.look.keys)) && taken.add(offer.look.keys))
    .map((offer) => takeByKey(tools, offer));
}

/** "Shift+[" of a pressed key. */
export function keysOf(event: { key: string; code?: string; ctrlKey: boolean; shiftKey: boolean; altKey: boolean; metaKey: boolean }): string {
  const bracket = event.code === "BracketLeft" ? "[" : event.code === "BracketRight" ? "]" : null;
  const key = bracket ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  return `${event.ctrlKey || event.metaKey ? "Ctrl+" : ""}${event.altKey ? "Alt+" : ""}${event.shiftKey ? "Shift+" : ""}${key}`;
}

function digit(tools: ToolBox, key: string): boolean {
  const { slot } = tools.active.peek();
  if (!slot?.brush && slot?.op !== "classify.paint") return false;
  const region = slot.members.find((member) => member.name === "region");
  if (region) {
    const named = kRegions[Number(key) - 1];
    if (named) choose(slot, "region", named);
    return named !== undefined;
  }
  const strength = slot.members.find((member) => member.name === "strength" || member.name === "opacity");
  if (!strength) return false;
  choose(slot, strength.name, key === "0" ? 1 : Number(key) / 10);
  return true;
}

/** Whether a focused control takes the key itself: texts all, number fields those that change or type a number. */
function isForControl(event: { key: string; target?: EventTarget | null }): boolean {
  const { target } = event;
  if (typeof Element === "undefined" || !(target instanceof Element)) return false;
  if (target.closest("input:not([type=checkbox]), textarea, select, [contenteditable], .cm-editor")) return true;
  const control = target.closest("[data-number-field], button, [role=menu], [role=dialog], [role=slider]");
  const name = control?.hasAttribute("data-number-field") ? /^([\d.,-]|Arrow\w+|Backspace|Delete|Enter|Escape|Home|End)$/ : /^(Enter| |Arrow\w+)$/;
  return control !== null && name.test(event.key);
}

/** What a pressed key means to the tools; false: nothing. For whoever listens to the page's keys. */
export function toolKey(studio: Studio, event: Parameters<typeof keysOf>[0] & { target?: EventTarget | null }): boolean {
  if (isForControl(event)) return false;
  const tools = toolsOf(studio);
  if (tools.key({ key: event.key, ctrl: event.ctrlKey || event.metaKey, shift: event.shiftKey })) return true;
  const keys = keysOf(event);
  if (/^\d$/.test(keys) && digit(tools, keys)) return true;
  const action = [...toolActions(studio), ...offeredActions(studio)].find((one) => one.keys === keys && one.enabled());
  action?.run();
  return action !== undefined;
}
