// What the tools and the parameters' panel tell each other: which item is worked on, and what is asked to be drawn.
import { effect, untracked } from "@preact/signals";
import { activeItem, drawing, drawRequest, type DrawRequest } from "../panels/params/active_item";
import { activeTool, selection } from "./active";
import { paramPlace } from "./place";
import { slotsOf, type Slot } from "./slots";
import type { ToolBox } from "./toolbox";

/** The slot that a pointer below a step's parameters means: of a parameter, or of an item of a list. */
export function slotAt(slots: readonly Slot[], pointer: string, tool?: string): Slot | undefined {
  const path = pointer.split("/params/")[1]?.split("/").filter((token) => !/^\d+$/.test(token)).join("/") ?? "";
  const fits = (slot: Slot) => {
    const own = (slot.list ?? slot.parts[0]!.path).join("/");
    return own === path || (own !== "" && path.startsWith(`${own}/`));
  };
  return slots.find((slot) => fits(slot) && slot.tool === tool) ?? slots.find(fits);
}

function answer(tools: ToolBox, request: DrawRequest): void {
  const { studio } = tools;
  const step = studio.step(request.step);
  const operator = step && studio.operator(step.op);
  if (!operator) return;
  const index = request.pointer.split("/params/")[1]?.split("/") ?? [];
  const item = paramPlace(studio.document.peek().recipe, request.step, index.slice(0, 2)).value;
  const named = item !== null && typeof item === "object" && !Array.isArray(item) ? item["tool"] : undefined;
  const slot = slotAt(slotsOf(operator), request.pointer, typeof named === "string" ? named : undefined);
  studio.selected.value = request.step;
  if (!slot) return;
  // Pressed again the pen is put away.
  activeTool.value = drawing.peek() === request.pointer ? "edit:select" : `slot:${slot.id}`;
}

/** Keeps both in step until the returned functions are called. */
export function bridge(tools: ToolBox): (() => void)[] {
  const { studio } = tools;
  return [
    effect(() => {
      const request = drawRequest.value;
      if (!request) return;
      untracked(() => answer(tools, request));
      drawRequest.value = null;
    }),
    effect(() => {
      const { slot } = tools.active.value;
      const step = studio.selected.value;
      const path = slot && !tools.active.value.adds ? (slot.list ?? slot.parts[0]!.path).join("/") : null;
      drawing.value = path === null || step === null ? null : `/steps/${step}/params/${path}`;
    }),
    effect(() => {  // what is selected of the drawing is the active item of the panel
      const chosen = tools.features.value.find((feature) => selection.value.has(feature.key));
      const step = untracked(() => studio.selected.value);
      if (chosen?.slot.list && step !== null && chosen.item.pointer !== untracked(() => activeItem.value?.pointer)) {
        activeItem.value = { step, pointer: chosen.item.pointer };
      }
    }),
    effect(() => {  // and the other way round
      const item = activeItem.value;
      untracked(() => {
        if (!item || item.step !== studio.selected.value || tools.busy.value) return;
        const of = tools.features.value.filter((feature) => feature.item.pointer === item.pointer);
        if (of.length === 0 || of.some((feature) => selection.value.has(feature.key))) return;
        selection.value = new Set(of.map((feature) => feature.key));
      });
    }),
  ];
}
