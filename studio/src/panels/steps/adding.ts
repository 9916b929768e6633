// Whether the search for a step to add is open, and where the step will come.
import { signal } from "@preact/signals";
import type { PortInfo } from "../../api/types";

export interface AddRequest {
  /** The step that it follows; null: the last. */
  after: string | null;
  /** A loose wire: only what takes (or makes) this is offered. */
  from?: { step: string; port: PortInfo };
  to?: { step: string; port: PortInfo };
  /** A wire into which it comes. */
  into?: { from: string; output: string; to: string; input: string; kind: string };
}

/** Set by the button, by Tab over the views, by the graph. Null: closed. */
export const adding = signal<AddRequest | null>(null);
