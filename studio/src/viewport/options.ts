// How the views show the ground: what a person sets in the view's own controls. Never part of a recipe.
import type { ClimateChoice } from "./climate";

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
