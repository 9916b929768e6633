// The server's refusals in words for a toast.
import type { ApiError } from "../api/api";
import type { Recipe } from "../api/types";
import { pointerTokens } from "./pointer";
import type { Message } from "./studio";

/** The step that a place in the recipe belongs to. */
export function stepAt(recipe: Recipe, pointer: string): string | undefined {
  if (!pointer.startsWith("/steps/")) return undefined;
  const token = pointerTokens(pointer)[1] ?? "";
  return recipe.steps.find((step) => step.id === token)?.id ?? recipe.steps[Number(token)]?.id;
}

export function refusalMessage(error: ApiError, recipe: Recipe): Message {
  const first = error.answer.diagnostics?.[0];
  const step = first && stepAt(recipe, first.pointer);
  const conflict = error.status === 409 ? "Another window has just changed the document. Try again" : undefined;
  const text = conflict ?? first?.message ?? error.answer.error;
  return step ? { kind: "error", text, step } : { kind: "error", text };
}
