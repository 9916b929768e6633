// What is laid over the ground (labels, a field, a picture) as a texture of colours, and the legend that goes with it.
import {
  ClampToEdgeWrapping, DataTexture, LinearFilter, LinearMipmapLinearFilter, RGBAFormat, Texture,
  UnsignedByteType,
} from "three";
import type { Frame } from "../api/types";
import { fieldColour, labelColours, labelNames, type Colour } from "./tints";
import type { GroundOverlay, GroundPointer, Raster } from "./types";

export interface Legend {
  /** A bar from min to max, or swatches. */
  bar?: { min: number; max: number; colour: (place: number) => Colour };
  swatches?: { name: string; colour: Colour }[];
}

const slopeColours: readonly [string, Colour][] = [
  ["0\u00b0", [199, 212, 189]], ["15\u00b0", [237, 219, 133]], ["25\u00b0", [235, 143, 71]],
  ["40\u00b0", [189, 56, 56]], ["60\u00b0", [92, 33, 77]],
];

/** Region at a place, where labels are laid over the ground. */
export function labelAt(overlay: GroundOverlay, place: GroundPointer | null): string | null {
  if (place === null || overlay.overlay !== "labels") return null;
  const { frame, values } = overlay.raster;
  const column = Math.floor((place.x - frame.west) / frame.cell_m);
  const row = Math.floor((frame.north - place.y) / frame.cell_m);
  if (column < 0 || row < 0 || column >= frame.columns || row >= frame.rows) return null;
  return labelNames[values[row * frame.columns + column]!] ?? null;
}

export function legendOf(overlay: GroundOverlay): Legend | null {
  switch (overlay.overlay) {
    case "labels":
      return { swatches: labelNames.map((name, i) => ({ name, colour: labelColours[i]! })) };
    case "field":
      return { bar: { min: overlay.raster.min, max: overlay.raster.max, colour: fieldColour } };
    case "slope":
      return { swatches: slopeColours.map(([name, colour]) => ({ name, colour })) };
    default:
      return null;
  }
}

/** Colours of a raster's cells, unknown ones without any. */
export function overlayPixels(raster: Raster): Uint8Array<ArrayBuffer> {
  const { values } = raster, data = new Uint8Array(values.length * 4);
  const words = new Uint32Array(data.buffer);
  const table = new Uint32Array(256);
  const labels = values instanceof Uint8Array;
  for (let i = 0; i < 256; ++i) {
    const [r, g, b] = labels ? labelColours[Math.min(i, labelColours.length - 1)]! : fieldColour(i / 255);
    table[i] = (255 << 24) | (Math.round(b) << 16) | (Math.round(g) << 8) | Math.round(r);
  }
  const scale = labels ? 1 : 255 / Math.max(1e-30, raster.max - raster.min), zero = labels ? 0 : raster.min;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    words[i] = Number.isNaN(value) ? 0 : table[Math.min(255, Math.max(0, Math.round((value - zero) * scale)))]!;
  }
  return data;
}

export class OverlayTexture {
  texture: Texture | null = null;
  /** Cells are regions with borders between them. */
  sharp = false;
  private frame: Frame | null = null;
  private shownKey = "";

  update(overlay: GroundOverlay): void {
    this.sharp = overlay.overlay === "labels";
    if (overlay.overlay === "picture") {
      this.replace(new Texture(overlay.bitmap), null, "");
      return;
    }
    if (overlay.overlay !== "labels" && overlay.overlay !== "field") {
      this.texture?.dispose();
      this.texture = this.frame = null;
      this.shownKey = "";
      return;
    }
    const { raster } = overlay;
    const key = `${overlay.overlay} ${raster.key} ${raster.min} ${raster.max} ${Object.values(raster.frame).join(" ")}`;
    if (key === this.shownKey) return;
    const texture = new DataTexture(
      overlayPixels(raster), raster.frame.columns, raster.frame.rows, RGBAFormat, UnsignedByteType,
    );
    this.replace(texture, raster.frame, key);
  }

  /** Places of a ground (0 to 1) times the last two plus the first two are places of the overlay. */
  placeOn(ground: Frame): [number, number, number, number] {
    const over = this.frame;
    if (over === null) return [0, 0, 1, 1];
    const across = over.columns * over.cell_m, down = over.rows * over.cell_m;
    return [
      (ground.west - over.west) / across, (over.north - ground.north) / down,
      (ground.columns * ground.cell_m) / across, (ground.rows * ground.cell_m) / down,
    ];
  }

  dispose(): void {
    this.texture?.dispose();
  }

  private replace(texture: Texture, frame: Frame | null, key: string): void {
    this.texture?.dispose();
    texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearMipmapLinearFilter;
    texture.generateMipmaps = true;
    texture.flipY = false;
    texture.needsUpdate = true;
    this.texture = texture;
    this.frame = frame;
    this.shownKey = key;
  }
}
