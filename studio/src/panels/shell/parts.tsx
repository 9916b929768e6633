// The parts that others make, at the places where the shell puts them. The only file that knows where they come from.
import { computed, signal } from "@preact/signals";
import type { ParamInfo } from "../../api/types";
import type { Studio } from "../../document/studio";
import { toolsOf } from "../../tools/toolbox";
import { ToolRail as Rail } from "../../tools/rail";
import { Viewport } from "../../viewport/viewport";
import { drawRequest } from "../params/active_item";
import { labelUnder } from "./label_under";

export { Graph } from "../graph/graph";
export { Parameters } from "../params/parameters";
export { adding } from "../steps/adding";
export { Steps } from "../steps/steps";
export { Timeline } from "../timeline/timeline";
export { ToolOptions } from "../../tools/options";

export interface PointedPlace {
  x: number;
  y: number;
  height: number | null;
  /** Of the region there. */
  label: string | null;
}

/** Null until the views are on the page. */
export const viewport = signal<Viewport | null>(null);

/** The place under the pointer; null: none. */
export const pointed = computed<PointedPlace | null>(() => {
  const at = viewport.value?.pointer.value ?? null;
  return at && { x: at.x, y: at.y, height: at.height, label: labelUnder(at.x, at.y) };
});

/** Metres of a pixel of the map; null: no map yet. */
export const mapScale = computed<number | null>(
  () => (viewport.value?.drawn.value ? viewport.value.scale.value : null)
);

/** Draws into the two elements until it is ended. */
export function startViews(map: HTMLElement, world: HTMLElement, studio: Studio): () => void {
  const views = new Viewport(map, world, studio);
  viewport.value = views;
  return () => {
    viewport.value = null;
    views.dispose();
  };
}

export function ToolRail({ studio }: { studio: Studio }) {
  return <Rail studio={studio} viewport={viewport.value} />;
}

/** Puts the pen for a parameter into the hand. */
export function askToDraw(studio: Studio, step: string, param: ParamInfo): void {
  toolsOf(studio);  // listens from now on
  drawRequest.value = { step, pointer: `/steps/${step}/params/${param.name}`, kind: param.kind, name: param.name };
}
