// How the page is laid out: which view is big, what is open, how wide and high things are. Remembered by the browser.
import { computed, signal } from "@preact/signals";
import { numberWithin, oneOf, remembered } from "../../document/remember";

export type ViewName = "map" | "world";
export type Arrangement = "inset" | "split" | "single";
export type DockTab = "graph" | "text" | "history" | "timeline";

/** From this width on the views stand side by side. */
const kSplitWidth = 1920;

export const windowWidth = signal(typeof innerWidth === "undefined" ? 1280 : innerWidth);
const chosen = remembered<Arrangement | "auto">("arrangement", "auto", oneOf("auto", "inset", "split", "single"));
export const bigView = remembered<ViewName>("bigView", "world", oneOf("map", "world"));
export const arrangement = computed<Arrangement>(() => (
  chosen.value !== "auto" ? chosen.value : windowWidth.value >= kSplitWidth ? "split" : "inset"
));

export const dockTab = remembered<DockTab>("dockTab", "graph", oneOf("graph", "text", "history", "timeline"));
const asBoolean = (value: unknown): boolean | undefined => (typeof value === "boolean" ? value : undefined);
export const dockOpen = remembered<boolean>("dockOpen", false, asBoolean);
export const dockHeight = remembered("dockHeight", 260, numberWithin(120, 900));
/** Share of the right panel that the step cards have. */
export const stepsShare = remembered("stepsShare", 0.42, numberWithin(0.1, 0.9));
/** Share of the left one of two views. */
export const splitShare = remembered("splitShare", 0.5, numberWithin(0.15, 0.85));
/** Views alone: bars and panels are away. */
export const viewsAlone = signal(false);

export function chooseArrangement(next: Arrangement): void {
  chosen.value = next;
}

export function swapViews(): void {
  bigView.value = bigView.value === "map" ? "world" : "map";
}

/** Opens a tab; closes the dock if it is the open one already. */
export function toggleDock(tab: DockTab): void {
  dockOpen.value = !(dockOpen.value && dockTab.value === tab);
  dockTab.value = tab;
}

export function followWindow(): void {
  addEventListener("resize", () => (windowWidth.value = innerWidth));
}
