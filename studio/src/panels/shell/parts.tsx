// The parts that others make, at the places where the shell puts them. The only file that knows where they come from.
import { signal } from "@preact/signals";
import type { ParamInfo } from "../../api/types";
import type { Studio } from "../../document/studio";

export { Steps } from "../steps/steps";
export { Parameters } from "../params/parameters";
export { Graph } from "../graph/graph";
export { Timeline } from "../timeline/timeline";

export interface PointedPlace {
  x: number;
  y: number;
  height: number | null;
  /** Of the region there. */
  label: string | null;
}

/** The place under the pointer; null: none. */
export const pointed = signal<PointedPlace | null>(null);
/** Metres of a pixel of the map; null: no map yet. */
export const mapScale = signal<number | null>(null);

/** Draws into the two elements until it is ended. */
export function startViews(_map: HTMLElement, _world: HTMLElement, _studio: Studio): () => void {
  return () => undefined;
}

export function ToolRail(_props: { studio: Studio }) {
  return null;
}

export function ToolOptions(_props: { studio: Studio }) {
  return null;
}

/** Puts the pen for a parameter into the hand. */
export function askToDraw(_step: string, _param: ParamInfo): void {
  return undefined;
}
