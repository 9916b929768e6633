// Which tools there are for what is selected: those that draw into the step, those that edit what is drawn, and those
// for which a step is added, with what it would be.
import type { OperatorInfo, Recipe, Schema } from "../api/types";
import { connectionsOf, operatorOf, stepOf } from "../document/connections";
import { lookOf, type Look } from "./names";
import { slotsOf, type Slot } from "./slots";

/** Where a step is added for a tool, and how it is connected. */
export interface Addition {
  op: string;
  /** The step behind or before which it comes. */
  at?: string;
  /** "behind": it takes an output of the selected step, and all that read it read the new step. "before": its output
   * goes to an input of the selected step. "alone": it begins something new. */
  where: "behind" | "before" | "alone";
  /** "before": the input of the selected step. */
  input?: string;
  /** There is one already: it is drawn into that. */
  existing?: string;
}

export interface Offer {
  /** "slot:ridges", "edit:select", "measure:distance", "add:terrain.sculpt:behind". */
  id: string;
  look: Look;
  help: string;
  group: "edit" | "draw" | "brush" | "measure" | "more";
  slot?: Slot;
  adds?: Addition;
}

function look(title: string, icon: string, keys: string): Look {
  return { title, icon, keys, role: "ink", done: title.toLowerCase() };
}

export const kSelect: Offer = {
  id: "edit:select", group: "edit", look: look("Select and move", "select", "Q"),
  help: "click selects, drag moves; drag between two points makes one, Delete takes it out, arrows nudge",
};
export const kEraser: Offer = {
  id: "edit:erase", group: "edit", look: { ...look("Eraser", "eraser", "E"), role: "erase", done: "erased" },
  help: "what lies under it is taken out of the drawing",
};
export const kMeasures: readonly Offer[] = [
  {
    id: "measure:distance", group: "measure", look: look("Measure a distance", "measure", "Shift+M"),
    help: "length of a line, and how much it rises",
  },
  {
    id: "measure:profile", group: "measure", look: look("Profile along a line", "profile", "Shift+P"),
    help: "the ground along a drawn line, from the side",
  },
];

export function slotOffers(operator: OperatorInfo): Offer[] {
  return slotsOf(operator).map((slot) => ({
    id: `slot:${slot.id}`, look: lookOf(slot), help: slot.about, group: slot.brush ? "brush" : "draw", slot,
  }));
}

/** Operators that take something and give the same again: what drawing behind a step may add. */
const kBehind: readonly { op: string; kind: string; title: string; icon: string }[] = [
  { op: "terrain.sculpt", kind: "terrain", title: "Sculpt", icon: "raise" },
  { op: "island.wind", kind: "labels", title: "Wind", icon: "wind" },
  { op: "classify.paint", kind: "labels", title: "Paint regions", icon: "brush" },
  { op: "contour.edit", kind: "contours", title: "Edit contours", icon: "warp" },
  { op: "reef.grow", kind: "terrain", title: "Reef", icon: "kernel" },
  { op: "terrain.paint", kind: "field", title: "Paint over it", icon: "brush" },
];
const kBefore: readonly { op: string; kind: string; title: (input: string) => string }[] = [
  { op: "classify.paint", kind: "labels", title: () => "Paint regions" },
  { op: "terrain.paint", kind: "field", title: (input) => `Paint the ${input.replace(/_/g, " ")}` },
];
const kAlone: readonly { op: string; slot: string; title: string; icon: string }[] = [
  { op: "island.build", slot: "areas", title: "Draw a coast", icon: "coast" },
  { op: "learned.sketch", slot: "ridges", title: "Sketch ridges", icon: "ridge" },
  { op: "contour.grow", slot: "outlines", title: "Draw regions of contours", icon: "region" },
];

function addOffer(operator: OperatorInfo, adds: Addition, title: string, icon: string, slotId?: string): Offer | null {
  const slots = slotsOf(operator);
  const slot = slotId ? slots.find((one) => one.id === slotId) : slots[0];
  if (!slot) return null;
  const where = {
    behind: `adds ${operator.name} behind ${adds.at}`, before: `adds ${operator.name} before ${adds.at}`,
    alone: `adds ${operator.name}`,
  };
  const target = adds.existing ? `in the step ${adds.existing}` : where[adds.where];
  const id = ["add", adds.op, adds.where, ...(adds.input ? [adds.input] : [])].join(":");
  return { id, look: { ...lookOf(slot), title, icon, keys: "" }, help: target, group: "more", slot, adds };
}

/** The step that already stands there for it: the reader of the step's output that is of this operator. */
function readerOf(recipe: Recipe, schema: Schema, step: string, op: string): string | undefined {
  return recipe.steps.find((other) => {
    if (other.op !== op) return false;
    return connectionsOf(recipe, schema, other).some(({ from }) => from && "step" in from && from.step === step);
  })?.id;
}

function moreOffers(recipe: Recipe, schema: Schema, stepId: string): Offer[] {
  const step = stepOf(recipe, stepId);
  const operator = step && operatorOf(schema, step.op);
  if (!step || !operator) return [];
  const offers: (Offer | null)[] = [];
  for (const { op, kind, title, icon } of kBehind) {
    const other = operatorOf(schema, op);
    if (!other || op === step.op || !operator.out.some((port) => port.kind === kind)) continue;
    if (kind === "field" && operator.out.some((port) => port.kind === "terrain")) continue;
    const existing = readerOf(recipe, schema, stepId, op);
    offers.push(addOffer(other, { op, at: stepId, where: "behind", ...(existing ? { existing } : {}) }, title, icon));
  }
  const connections = connectionsOf(recipe, schema, step);
  for (const { op, kind, title } of kBefore) {
    const other = operatorOf(schema, op);
    if (!other || op === step.op) continue;
    for (const { input, from } of connections) {
      if (input.kind !== kind || /_\d+$/.test(input.name)) continue;
      if (operator.out.some((port) => port.kind === kind && (kind === "labels" || port.name === input.name))) continue;
      const there = from && "step" in from && stepOf(recipe, from.step)?.op === op ? from.step : undefined;
      offers.push(
        addOffer(
          other, { op, at: stepId, where: "before", input: input.name, ...(there ? { existing: there } : {}) },
          title(input.name), "brush",
        ),
      );
    }
  }
  return offers.filter((offer): offer is Offer => offer !== null);
}

/** Tools that begin something new. */
function aloneOffers(schema: Schema): Offer[] {
  return kAlone
    .map(({ op, slot, title, icon }) => {
      const operator = operatorOf(schema, op);
      return operator ? addOffer(operator, { op, where: "alone" }, title, icon, slot) : null;
    })
    .filter((offer): offer is Offer => offer !== null);
}

export interface Offers {
  /** In the rail, in this order. */
  rail: Offer[];
  /** In the flyout. */
  more: Offer[];
}

/** `shown`: the step whose result is seen; without a selection the pen may go on behind it. */
export function offersFor(recipe: Recipe, schema: Schema, stepId: string | null, shown: string | null = null): Offers {
  const step = stepId === null ? undefined : stepOf(recipe, stepId);
  const operator = step && operatorOf(schema, step.op);
  if (!operator) {
    const behind = shown === null ? []
      : moreOffers(recipe, schema, shown).filter((offer) => offer.adds!.where === "behind");
    return { rail: [kSelect, ...aloneOffers(schema), ...kMeasures], more: behind };
  }
  const own = slotOffers(operator);
  const erasable = own.some(({ slot }) => slot!.geometry === "line" || slot!.geometry === "ring");
  const ownEraser = own.some(({ look }) => look.keys === "E");
  const edit = [kSelect, ...(erasable && !ownEraser ? [kEraser] : [])];
  const draw = [...own.filter((o) => o.slot!.id !== "centre"), ...own.filter((o) => o.slot!.id === "centre")];
  return {
    rail: [...edit, ...draw, ...kMeasures], more: [...moreOffers(recipe, schema, step.id), ...aloneOffers(schema)],
  };
}

export function offerById(offers: Offers, id: string): Offer | undefined {
  return offers.rail.find((offer) => offer.id === id) ?? offers.more.find((offer) => offer.id === id);
}
