// How the views show the ground: what a person sets in the view's own controls. Never part of a recipe.
import { climateNames, type ClimateChoice } from "./climate";

/** texture: natural ground; relief: one pale stone; slope: steepness in colours; contours: natural with height
 * lines. */
export type GroundStyle = "texture" | "relief" | "slope" | "contours";
export type NavigationPreset = "blender" | "gaea";

export interface ViewOptions {
  /** Heights of the 3D view are drawn so many times as high. */
  exaggeration: number;
  wireframe: boolean;
  water: boolean;
  /** Bearing the sun stands at, clockwise from north, and its height over the horizon. */
  sun: { azimuth_deg: number; elevation_deg: number };
  ground: GroundStyle;
  /** That natural ground grows in. */
  climate: ClimateChoice;
  /** Kilometre lines over the map. */
  grid: boolean;
  navigation: NavigationPreset;
}

export const defaultOptions: ViewOptions = {
  exaggeration: 1,
  wireframe: false,
  water: true,
  sun: { azimuth_deg: 300, elevation_deg: 33 },
  ground: "texture",
  climate: "automatic",
  grid: false,
  navigation: "blender",
};

const styles: readonly GroundStyle[] = ["texture", "relief", "slope", "contours"];

/** What of the options outlasts the page: taste. Heights follow the terrain, and what hides or uncovers something of
 * it is of the moment. */
export type Taste = Pick<ViewOptions, "ground" | "climate" | "sun" | "grid" | "navigation">;

export function tasteOf({ ground, climate, sun, grid, navigation }: ViewOptions): Taste {
  return { ground, climate, sun, grid, navigation };
}

/** Of what was kept: what is no such option, or not in its range, is the default's. */
export function readTaste(kept: unknown): Taste | undefined {
  if (kept === null || typeof kept !== "object") return undefined;
  const { ground, climate, sun, grid, navigation } = kept as { readonly [name in keyof Taste]?: unknown };
  const { azimuth_deg, elevation_deg } = (sun ?? {}) as { readonly [name in keyof ViewOptions["sun"]]?: unknown };
  const usual = tasteOf(defaultOptions);
  return {
    ground: styles.find((style) => style === ground) ?? usual.ground,
    climate: climateNames.find(([name]) => name === climate)?.[0] ?? usual.climate,
    sun: {
      azimuth_deg: within(azimuth_deg, 0, 360) ?? usual.sun.azimuth_deg,
      elevation_deg: within(elevation_deg, 1, 90) ?? usual.sun.elevation_deg,
    },
    grid: typeof grid === "boolean" ? grid : usual.grid,
    navigation: navigation === "gaea" || navigation === "blender" ? navigation : usual.navigation,
  };
}

function within(value: unknown, low: number, high: number): number | undefined {
  return typeof value === "number" && value >= low && value <= high ? value : undefined;
}

/** Unit vector to the sun: x east, y north, z up. */
export function sunVector(sun: ViewOptions["sun"]): [number, number, number] {
  const azimuth = (sun.azimuth_deg * Math.PI) / 180;
  const elevation = (Math.max(1, sun.elevation_deg) * Math.PI) / 180;
  const flat = Math.cos(elevation);
  return [flat * Math.sin(azimuth), flat * Math.cos(azimuth), Math.sin(elevation)];
}

/** An exaggeration that shows the forms of gentle or wide ground: 1 to 2.5 in halves. */
export function suggestedExaggeration(typicalSlope: number): number {
  if (typicalSlope <= 0) return 1;
  return Math.min(2.5, Math.max(1, Math.round((2 * 0.4) / typicalSlope) / 2));
}
