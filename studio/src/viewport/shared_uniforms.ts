// What the shaders of both views are told: textures of the ground and what is laid over it.
import { Vector3, type IUniform, type Texture } from "three";
import { nowhere } from "./dry_texture";
import type { GroundTextures } from "./ground_textures";
import type { OverlayTexture } from "./ground_overlay";
import type { HeightField } from "./heights";
import type { GroundStyle } from "./options";
import type { GroundOverlay } from "./types";

export interface SharedUniforms {
  [name: string]: IUniform;
  heights: IUniform<Texture | null>;
  surface: IUniform<Texture | null>;
  lit: IUniform<Texture | null>;
  dry: IUniform<Texture | null>;
  noise: IUniform<Texture | null>;
  cell_m: IUniform<number>;
  ground_style: IUniform<number>;
  overlay: IUniform<Texture | null>;
  overlay_detail: IUniform<Texture | null>;
  overlay_fine: IUniform<boolean>;
  overlay_place: IUniform<[number, number, number, number]>;
  overlay_strength: IUniform<number>;
  overlay_sharp: IUniform<number>;
  contour_m: IUniform<number>;
  contour_colour: IUniform<Vector3>;
  detail_heights: IUniform<Texture | null>;
  detail_surface: IUniform<Texture | null>;
  detail_lit: IUniform<Texture | null>;
  detail_dry: IUniform<Texture | null>;
  detail_place: IUniform<[number, number, number, number]>;
  detail_fade: IUniform<[number, number, number, number]>;
  detail_edge: IUniform<[number, number, number, number]>;
  detail_strength: IUniform<number>;
  detail_cell_m: IUniform<number>;
}

export function sharedUniforms(noise: Texture): SharedUniforms {
  return {
    heights: { value: null }, surface: { value: null }, lit: { value: null }, dry: { value: nowhere },
    noise: { value: noise }, cell_m: { value: 1 }, ground_style: { value: 0 }, overlay: { value: null },
    overlay_detail: { value: null }, overlay_fine: { value: false },
    overlay_place: { value: [0, 0, 1, 1] }, overlay_strength: { value: 0 }, overlay_sharp: { value: 0 },
    contour_m: { value: 0 },
    contour_colour: { value: new Vector3(0.02, 0.015, 0.01) },
    detail_heights: { value: null }, detail_surface: { value: null }, detail_lit: { value: null },
    detail_dry: { value: nowhere },
    detail_place: { value: [0, 0, 1, 1] },
    detail_fade: { value: [0, 0, 0, 0] }, detail_edge: { value: [0, 0, 0, 0] }, detail_strength: { value: 0 },
    detail_cell_m: { value: 1 },
  };
}

export function showTextures(
  u: Pick<SharedUniforms, "heights" | "surface" | "lit" | "dry" | "cell_m">, textures: GroundTextures,
  field: HeightField,
): void {
  u.heights.value = textures.heights;
  u.surface.value = textures.surface;
  u.lit.value = textures.lit;
  u.dry.value = textures.dry;
  u.cell_m.value = field.frame.cell_m;
}

export function showOverlay(u: SharedUniforms, overlay: OverlayTexture, field: HeightField): void {
  u.overlay.value = overlay.texture ?? u.noise.value;
  u.overlay_place.value = overlay.placeOn(field.frame);
  u.overlay_sharp.value = overlay.sharp ? 1 : 0;
  u.overlay_strength.value = overlay.texture === null ? 0 : 0.8;
}

/** Tells the shaders of the overlay of a window of finer ground, or of none. */
export function showOverlayDetail(u: SharedUniforms, texture: Texture | null): void {
  u.overlay_detail.value = texture ?? u.overlay.value;
  u.overlay_fine.value = texture !== null;
}

/** Number of a style of the ground in the shaders. */
export function styleNumber(style: GroundStyle, overlay: GroundOverlay): number {
  return overlay.overlay === "slope" || style === "slope" ? 2 : style === "relief" ? 1 : 0;
}
