// The list of gestures as a window shows it, kept up to date from what the server says of each revision.
import type { DocumentEvent } from "../api/types";

export interface Gesture {
  label: string;
  window: string;
}

export interface History {
  history: readonly Gesture[];
  done: number;
}

/** Null: the list does not follow from the one before and must be fetched. */
export function followHistory(before: History, event: DocumentEvent): History | null {
  const { done, undone } = event;
  const length = before.history.length;
  if (done > before.done + 1 || done < before.done - 1) return null;
  if (undone > 0 || (done === before.done + 1 && done + undone === length && isAgain(before, event))) {
    return done + undone === length ? { history: before.history, done } : null;
  }
  if (done < before.done) return null;
  const kept = before.history.slice(0, Math.min(before.done, Math.max(done - 1, 0)));
  return done === 0 ? { history: [], done } : {
    history: [...kept, { label: event.label, window: event.window }], done,
  };
}

/** The last gesture that was taken back, made again. */
function isAgain(before: History, event: DocumentEvent): boolean {
  return before.history[event.done - 1]?.label === event.label;
}
