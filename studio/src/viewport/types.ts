// What passes between the views (map and 3D), the tools of the pen and the panels. Places are metres of the document's
// system: x east, y north, height up.
import type { Frame } from "../api/types";

export interface Raster {
  key: string;
  frame: Frame;
  /** Heights or another scalar, row-major from the north-west; or labels. */
  values: Float32Array | Uint8Array;
  /** Of heights: 255 where ground below the sea is dry, and on land that touches it. Absent: nowhere. */
  dry?: Uint8Array;
  coarse: boolean;
  min: number;
  max: number;
}

/** A pen, mouse or finger over the ground, from the map or, by picking, from the 3D view. */
export interface GroundPointer {
  x: number;
  y: number;
  /** Height of the ground there; null beside the terrain. */
  height: number | null;
  /** 0 to 1; 1 for what has no pressure. */
  pressure: number;
  device: "pen" | "mouse" | "touch";
  shift: boolean;
  ctrl: boolean;
  alt: boolean;
  /** Metres of a screen pixel here: how near is near. */
  pixel_m: number;
}

/** What the active tool is told. A gesture is down, moves, and up or cancel; every stroke ends in exactly one of these.
 * Moves carry all coalesced events since the last. */
export interface PenTarget {
  cursor: "crosshair" | "none" | "default" | "grab" | "move" | "pointer";
  down(at: GroundPointer): void;
  move(path: GroundPointer[]): void;
  up(at: GroundPointer): void;
  cancel(): void;
  hover?(at: GroundPointer | null): void;
  double?(at: GroundPointer): void;
}

/** Drawn over the ground in both views, or on the map alone. */
export type OverlayShape = (
  | {
    shape: "line"; points: readonly (readonly [number, number])[]; role: Role; closed?: boolean; width_m?: number;
    width_px?: number; colour?: string;
  }
  | { shape: "lines"; lines: readonly (readonly (readonly [number, number])[])[]; role: Role; width_px: number }
  | { shape: "area"; points: readonly (readonly [number, number])[]; role: Role; colour?: string }
  | { shape: "dot"; at: readonly [number, number]; role: Role; label?: string; handle?: boolean }
  | { shape: "dots"; places: readonly (readonly [number, number])[]; colour: string }
  | { shape: "circle"; at: readonly [number, number]; radius_m: number; role: Role; inner_m?: number }
) & { only?: "map" };

/** Roles have colours in the theme; "mountain" ... are the label colours. */
export type Role =
  | "ink" | "guide" | "selected" | "handle" | "ridge" | "river" | "wind" | "height" | "erase" | "coast" | "contour"
  | "mountain" | "beach" | "lagoon" | "reef" | "abyss";

export type GroundOverlay =
  | { overlay: "none" }
  | { overlay: "labels"; raster: Raster }
  | { overlay: "field"; raster: Raster }
  | { overlay: "slope" }
  | { overlay: "contours"; interval_m: number }
  | { overlay: "picture"; bitmap: ImageBitmap };
