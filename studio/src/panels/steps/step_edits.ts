// What can be done to a step from its card or its node, each as one entry of the history.
import type { Studio } from "../../document/studio";
import { duplicateStep } from "../graph/insert";
import { picturedSource } from "./thumbnail";

export function toggleBypass(studio: Studio, id: string): void {
  const on = studio.step(id)?.bypass !== true;
  const pointer = `/steps/${id}/bypass`;
  void studio.edit([on ? { do: "set", pointer, value: true } : { do: "set", pointer }],
    `${id}: ${on ? "left out" : "taken in again"}`);
}

/** Shows this step's result whatever is selected; again: what is selected is shown. */
export function togglePin(studio: Studio, id: string): void {
  const source = picturedSource(id, studio.operator(studio.step(id)?.op ?? ""))?.source ?? id;
  studio.pinned.value = studio.pinned.value === source ? null : source;
}

export function isPinned(studio: Studio, id: string): boolean {
  return studio.pinned.value?.split(".")[0] === id;
}

export async function duplicate(studio: Studio, id: string): Promise<void> {
  const copy = duplicateStep(id, studio.document.value.recipe, (name) => studio.operator(name));
  if (copy && await studio.edit(copy.edits, `${id} copied as ${copy.id}`)) studio.selected.value = copy.id;
}

/** The next step, or the one before, is selected then. */
export async function removeStep(studio: Studio, id: string): Promise<void> {
  const { steps } = studio.document.value.recipe;
  const at = steps.findIndex((step) => step.id === id);
  const next = steps[at + 1]?.id ?? steps[at - 1]?.id ?? null;
  if (await studio.edit([{ do: "remove_step", id }], `${id} removed`)
    && (studio.selected.value === id || studio.selected.value === null))
    studio.selected.value = next;
}

export function moveStep(studio: Studio, id: string, to: number): void {
  const { steps } = studio.document.value.recipe;
  const at = steps.findIndex((step) => step.id === id);
  if (at === -1 || to === at || to < 0 || to >= steps.length) return;
  void studio.edit([{ do: "move", item: `/steps/${id}`, index: to }], `${id} moved ${to < at ? "up" : "down"}`);
}

const ID = /^[A-Za-z0-9_-]{1,64}$/;

/** Why an id cannot be given; "": it can. */
export function idProblem(studio: Studio, id: string, wanted: string): string {
  if (wanted === id) return "";
  if (!ID.test(wanted)) return "letters, digits, _ and - only";
  return studio.step(wanted) ? "there is such a step already" : "";
}

export async function renameStep(studio: Studio, id: string, wanted: string): Promise<void> {
  if (wanted === id || idProblem(studio, id, wanted) !== "") return;
  const selected = studio.selected.value === id;
  const pinned = isPinned(studio, id) ? studio.pinned.value : null;
  if (!await studio.edit([{ do: "rename", id, new_id: wanted }], `${id} is now ${wanted}`)) return;
  if (selected) studio.selected.value = wanted;
  if (pinned) studio.pinned.value = pinned.replace(/^[^.]*/, wanted);
}
