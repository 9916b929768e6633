// View options over a reload of the window: where the sun stood, the climate, what was shown. Each window has its own;
// exaggeration is chosen anew with each terrain.
import { effect, type Signal } from "@preact/signals";
import { climateNames } from "./climate";
import { defaultOptions, type GroundStyle, type NavigationPreset, type ViewOptions } from "./options";

const kKey = "seamount.view";
const styles: readonly GroundStyle[] = ["texture", "relief", "slope", "contours"];
const presets: readonly NavigationPreset[] = ["blender", "gaea"];

function within(value: unknown, low: number, high: number, otherwise: number): number {
  return typeof value === "number" && value >= low && value <= high ? value : otherwise;
}

function oneOf<T>(value: unknown, known: readonly T[], otherwise: T): T {
  return known.find((one) => one === value) ?? otherwise;
}

/** What was kept, as far as it is something that can be set. */
export function keptOptions(storage: Pick<Storage, "getItem"> | null): ViewOptions {
  let kept: Partial<Record<string, unknown>> = {};
  try {
    const value: unknown = JSON.parse(storage?.getItem(kKey) ?? "{}");
    if (typeof value === "object" && value !== null) kept = value as typeof kept;
  } catch {
    return defaultOptions;  // somebody else's, or forbidden by the browser
  }
  const sun = (typeof kept["sun"] === "object" && kept["sun"] !== null ? kept["sun"] : {}) as Record<string, unknown>;
  const standard = defaultOptions;
  const flag = (name: "wireframe" | "water" | "grid"): boolean => oneOf(kept[name], [true, false], standard[name]);
  return {
    exaggeration: standard.exaggeration,
    wireframe: flag("wireframe"),
    water: flag("water"),
    grid: flag("grid"),
    sun: {
      azimuth_deg: within(sun["azimuth_deg"], 0, 360, standard.sun.azimuth_deg),
      elevation_deg: within(sun["elevation_deg"], 0, 90, standard.sun.elevation_deg),
    },
    ground: oneOf(kept["ground"], styles, standard.ground),
    climate: oneOf(kept["climate"], climateNames.map(([name]) => name), standard.climate),
    navigation: oneOf(kept["navigation"], presets, standard.navigation),
  };
}

/** Keeps them from now on; gives what ends that. */
export function keepOptions(storage: Pick<Storage, "setItem"> | null, options: Signal<ViewOptions>): () => void {
  return effect(() => {
    const text = JSON.stringify(options.value);
    try {
      storage?.setItem(kKey, text);
    } catch {
      // full or forbidden: nothing is kept
    }
  });
}

/** This window's storage, if the browser lets it be used. */
export function windowStorage(): Storage | null {
  try {
    return typeof sessionStorage === "undefined" ? null : sessionStorage;
  } catch {
    return null;
  }
}
