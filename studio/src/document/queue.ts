// Edits on their way: one request at a time; what waits is overtaken by later edits of its gesture at the same place.
import type { Edit } from "../api/types";
import { equalJson } from "./pointer";

export interface Waiting {
  edits: readonly Edit[];
  label: string;
  gesture: string;
  /** The gesture is over with these. */
  ends: boolean;
  /** They only say that: the hand rested before it let go. */
  idle: boolean;
  /** Called once the server has answered: was it taken? */
  settle: ((taken: boolean) => void)[];
}

/** Later edits after earlier ones; an earlier value that is set again at once is left out. */
export function joinEdits(earlier: readonly Edit[], later: readonly Edit[]): Edit[] {
  const joined = [...earlier];
  for (const edit of later) {
    if (edit.do === "set") dropOvertaken(joined, edit.pointer);
    joined.push(edit);
  }
  return joined;
}

/** Places move when items are put in or taken out: only what was set since then is looked at. */
function dropOvertaken(edits: Edit[], pointer: string): void {
  for (let i = edits.length - 1; i >= 0; --i) {
    const edit = edits[i]!;
    if (edit.do !== "set") return;
    if (edit.pointer === pointer) edits.splice(i, 1);
  }
}

/** Puts an edit at the end of those that wait, or into the last one if it is of the same gesture. */
export function enqueue(waiting: readonly Waiting[], next: Waiting): Waiting[] {
  const last = waiting[waiting.length - 1];
  if (!last || next.gesture === "" || last.gesture !== next.gesture) return [...waiting, next];
  const joined = {
    edits: joinEdits(last.edits, next.edits),
    label: next.label,
    gesture: next.gesture,
    ends: next.ends,
    idle: last.idle && next.idle,
    settle: [...last.settle, ...next.settle],
  };
  return [...waiting.slice(0, -1), joined];
}

export function sameEdits(a: readonly Edit[], b: readonly Edit[]): boolean {
  return equalJson(a as never, b as never);
}
