// What the keyboard does to the tools: actions for the page's registry, and the keys that are the pen's own.
import { matches } from "../actions/keys";
import type { Studio } from "../document/studio";
import { activeTool, choose, chosenValue, isReach, ownReach, reach, selection, suitableReach } from "./active";
import { kRegions } from "./names";
import { kEraser, kMeasures, kSelect, type Offer } from "./offers";
import { domainOf } from "./place";
import { toolsOf, type ToolBox } from "./toolbox";

/** For the page's registry. */
export interface ToolAction {
  id: string;
  title: string;
  /** "B", "Shift+R", "["; "" for none. */
  keys: string;
  /** Name of a picture of icons.tsx. */
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

function action(
  id: string, title: string, keys: string, icon: string, run: () => void, enabled = () => true,
): ToolAction {
  return { id, title, keys, icon, run, enabled };
}

function takeByKey(tools: ToolBox, { id, look }: Offer): ToolAction {
  const offered = () => tools.offers.value.rail.some((one) => one.id === id);
  return action(`tool.${id}`, look.title, look.keys, look.icon, () => tools.take(id), offered);
}

const kFixed = new Set([kSelect, kEraser, ...kMeasures].map((offer) => offer.id));

/** Actions that are always there. Those of the step's own tools follow in `offeredActions`. */
export function toolActions(studio: Studio): ToolAction[] {
  const tools = toolsOf(studio);
  const selectAll = () => {
    activeTool.value = kSelect.id;
    selection.value = new Set(tools.features.peek().map((feature) => feature.key));
  };
  return [
    ...[kSelect, kEraser, ...kMeasures].map((offer) => takeByKey(tools, offer)),
    action("brush.smaller", "Smaller brush", "[", "brush", () => resize(tools, false)),
    action("brush.larger", "Larger brush", "]", "brush", () => resize(tools, true)),
    action("brush.softer", "Softer brush", "{", "brush", () => harden(tools, -0.1)),
    action("brush.harder", "Harder brush", "}", "brush", () => harden(tools, 0.1)),
    action(
      "drawing.select_all", "Select all that is drawn", "Ctrl+A", "select", selectAll,
      () => tools.features.value.length > 0,
    ),
  ];
}

/** Actions of the tools that are offered now. Reads signals: changes with the selection. */
export function offeredActions(studio: Studio): ToolAction[] {
  const tools = toolsOf(studio);
  const { rail, more } = tools.offers.value;
  return [...rail, ...more].filter((offer) => !kFixed.has(offer.id)).map((offer) =>
    rail.includes(offer) ? takeByKey(tools, offer) : action(`tool.${offer.id}`, `${offer.look.title}: ${offer.help}`,
      "", offer.look.icon, () => tools.take(offer.id)));
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
  const name =
    control?.hasAttribute("data-number-field") ? /^([\d.,-]|Arrow\w+|Backspace|Delete|Enter|Escape|Home|End)$/
    : /^(Enter| |Arrow\w+)$/;
  return control !== null && name.test(event.key);
}

type Press = Pick<KeyboardEvent, "key" | "ctrlKey" | "shiftKey" | "altKey" | "metaKey"> & {
  target?: EventTarget | null,
};

/** Keys of what the pen is doing: ends, cancels, deletes, nudges, types a height. False: it means nothing to the
 * pen. */
function penKey(studio: Studio, event: Press): boolean {
  if (isForControl(event)) return false;
  const tools = toolsOf(studio);
  const ctrl = event.ctrlKey || event.metaKey;
  if (tools.key({ key: event.key, ctrl, shift: event.shiftKey })) return true;
  return !ctrl && !event.altKey && /^\d$/.test(event.key) && digit(tools, event.key);
}

/** What a pressed key means: to the pen, to the brush, to the tools that are offered. */
export function toolKey(studio: Studio, event: Press): boolean {
  if (penKey(studio, event)) return true;
  const meant = [...toolActions(studio), ...offeredActions(studio)].find(
    (one) => one.keys !== "" && matches(event, one.keys) && one.enabled(),
  );
  meant?.run();
  return meant !== undefined;
}
