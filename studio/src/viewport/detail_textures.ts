// A window of finer ground on the graphics side, for one view.
import type { Texture, WebGLRenderer } from "three";
import type { DetailGround } from "./detail_ground";
import { GroundTextures, type TextureBudget } from "./ground_textures";
import type { ViewOptions } from "./options";
import type { SharedUniforms } from "./shared_uniforms";

export class DetailTextures {
  readonly textures: GroundTextures;
  private held: DetailGround | null = null;

  constructor(renderer: WebGLRenderer, noise: Texture, budget: TextureBudget) {
    // What is seen of a window is never baked coarsely: in a hurry the coarse ground is there.
    this.textures = new GroundTextures(
      renderer, noise, { ...budget, quickCells: Infinity, quickColourCells: Infinity }, 1,
    );
  }

  /** The graphics processor has lost what it held. */
  forget(): void {
    this.held = null;
  }

  /** Gradients and heights, for the map: whether they are there. Nothing is baked in a hurry. */
  shape(detail: DetailGround, hurry: boolean): boolean {
    if (detail === this.held) return true;
    if (hurry) return false;
    this.held = detail;
    this.textures.upload(detail.field);
    this.textures.shape(detail.field, false, detail);
    return true;
  }

  /** Colours in their light too, for the 3D view. */
  colour(detail: DetailGround, around: GroundTextures, options: ViewOptions, style: number, hurry: boolean): boolean {
    if (!this.shape(detail, hurry)) return false;
    if (this.textures.fits) return true;
    if (hurry) return false;
    this.textures.colour(detail.field, options, style, false, { ground: detail, around });
    return true;
  }
}

/** Tells the shaders of a window, or of none. */
export function showDetail(u: SharedUniforms, detail: DetailGround | null, of: DetailTextures): void {
  u.detail_strength.value = detail === null ? 0 : 1;
  u.detail_heights.value = detail === null ? u.heights.value : of.textures.heights;
  u.detail_surface.value = detail === null ? u.surface.value : of.textures.surface;
  u.detail_dry.value = detail === null ? u.dry.value : of.textures.dry;
  u.detail_lit.value = detail === null ? u.lit.value : of.textures.lit;
  if (detail === null) return;
  u.detail_cell_m.value = detail.cell_m;
  u.detail_place.value = detail.place;
  u.detail_fade.value = detail.fade;
  u.detail_edge.value = detail.edge;
}
