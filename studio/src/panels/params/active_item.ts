// What the parameters' panel and the pen's tools agree on: which item of a list is worked on, and what is to be drawn.
import { signal } from "@preact/signals";
import type { ParamKind } from "../../api/types";

export interface ActiveItem {
  step: string;
  /** JSON pointer with the step's id: "/steps/wind/params/strokes/2". */
  pointer: string;
}

/** The selected item of a list of groups, tools or drawn shapes; null: none. */
export const activeItem = signal<ActiveItem | null>(null);

export interface DrawRequest {
  step: string;
  /** Of the parameter (or its item) that is to be drawn: "/steps/wind/params/strokes". */
  pointer: string;
  kind: ParamKind;
  name: string;
}

/** Set by a 'Draw' button; the tools take it, activate the pen that draws such a thing, and set it back to null. */
export const drawRequest = signal<DrawRequest | null>(null);

/** Pointer of the parameter that a pen draws at the moment, set by the tools: its button shows as pressed. */
export const drawing = signal<string | null>(null);
