// The height field on the graphics side, shared by both views: heights as they are (R32F, sampled by hand), and what is
// baked of them once, so that frames are cheap and far ground does not shimmer: gradients, natural colours, light.
// Twice: as finely as the heights are, and coarsely for moving views and results that come in a row.
import {
  DataTexture, FloatType, LinearMipmapLinearFilter, LinearMipmapNearestFilter, NearestFilter, RedFormat, type Texture,
  type WebGLRenderTarget, type WebGLRenderer,
} from "three";
import { Bake, target } from "./bake";
import { climateOf, type ClimateChoice } from "./climate";
import type { DetailGround } from "./detail_ground";
import { dryTexture, nowhere } from "./dry_texture";
import type { HeightField } from "./heights";
import { lamps } from "./light";
import { sunVector, type ViewOptions } from "./options";
import albedoShader from "./shaders/bake_albedo.frag.glsl";
import litShader from "./shaders/bake_lit.frag.glsl";
import lightShader from "./shaders/bake_light.frag.glsl";
import surfaceShader from "./shaders/bake_surface.frag.glsl";
import overlayShader from "./shaders/overlay.glsl";

/** What is baked of heights at one fineness, each from the one before, and whether it fits them. */
interface Ground {
  surface: WebGLRenderTarget;
  albedo: WebGLRenderTarget;
  lit: WebGLRenderTarget;
  surfaceFits: boolean;
  albedoFits: boolean;
  litFits: boolean;
}

interface Set {
  columns: number;
  rows: number;
  heights: DataTexture;
  fine: Ground;
  /** The same where heights are few or the machine is fast. */
  quick: Ground;
}

/** A window of finer ground in another, whose looks it shares. */
export interface Within {
  ground: DetailGround;
  /** Textures of the other one. */
  around: GroundTextures;
}

/** What suits the machine: cells along the longer side of textures. */
export interface TextureBudget {
  lightCells: number;
  colourCells: number;
  /** Of all that is baked for a moving view, and of its colours. */
  quickCells: number;
  quickColourCells: number;
  anisotropy: number;
  /** Between levels of a texture, too. */
  smoothLevels: boolean;
}

export class GroundTextures {
  private readonly sets: Set[] = [];
  private ground: Ground | null = null;
  private light: WebGLRenderTarget | null = null;
  private low: DataTexture | null = null;
  private lightFits = false;
  private readonly surfaceBake: Bake;
  private readonly albedoBake: Bake;
  private readonly lightBake: Bake;
  private readonly litBake: Bake;

  constructor(
    private readonly renderer: WebGLRenderer, noise: Texture, private readonly budget: TextureBudget,
    private readonly kept = 3,
  ) {
    this.surfaceBake = new Bake(surfaceShader, {
      heights: { value: null }, cell_m: { value: 1 }, relief_scale: { value: 1 }, broad: { value: 5 },
      result_size: { value: [1, 1] },
    });
    this.albedoBake = new Bake(albedoShader, {
      surface: { value: null }, dry: { value: nowhere }, noise: { value: noise }, cell_m: { value: 1 },
      scale: { value: 1 }, coarse_m: { value: 1 },
      finer: { value: 0 }, middle: { value: [0, 0] }, warmth_c: { value: 25 }, rain_mm: { value: 2000 },
      latitude: { value: 18 }, rain_from: { value: [1, 0] }, low_m: { value: 0 }, basalt: { value: true },
      snow_line: { value: 5000 }, tree_line: { value: 3900 },
    });
    this.lightBake = new Bake(lightShader, {
      surface: { value: null }, dry: { value: nowhere }, cell_m: { value: 1 }, exaggeration: { value: 1 },
      floor_m: { value: 0 }, to_sun: { value: [0, 0, 1] }, light_size: { value: [1, 1] },
      around: { value: null }, around_dry: { value: nowhere }, around_place: { value: [0, 0, 1, 1] },
      finer: { value: 0 },
    });
    const none = { value: null };
    this.litBake = new Bake(overlayShader + litShader, {
      surface: { ...none }, dry: { value: nowhere }, albedo: { ...none }, lights: { ...none },
      exaggeration: { value: 1 }, floor_m: { value: 0 },
      to_sun: { value: [0, 0, 1] }, sun_light: { value: [1, 1, 1] }, sky_light: { value: [1, 1, 1] },
      ground_style: { value: 0 },
    });
  }

  get heights(): Texture | null {
    return this.sets[0]?.heights ?? null;
  }
  get surface(): Texture | null {
    return this.ground?.surface.texture ?? null;
  }
  get lit(): Texture | null {
    return this.ground?.lit.texture ?? null;
  }

  /** Where low ground is dry. */
  get dry(): Texture {
    return this.low ?? nowhere;
  }

  /** Another height field: nothing that was baked fits it. */
  upload(field: HeightField): void {
    const set = this.setOf(field.columns, field.rows);
    set.heights.image = { data: field.values as Float32Array<ArrayBuffer>, width: field.columns, height: field.rows };
    set.heights.needsUpdate = true;
    this.low?.dispose();
    this.low = field.dry === null ? null : dryTexture(field.dry, field.columns, field.rows);
    for (const ground of [set.fine, set.quick]) ground.surfaceFits = ground.albedoFits = ground.litFits = false;
    this.lightFits = false;
  }

  /** Sun, water or exaggeration are others, or, `shadowsToo` false, only the style of the ground. */
  relight(shadowsToo: boolean): void {
    for (const { fine, quick } of this.sets) fine.litFits = quick.litFits = false;
    if (shadowsToo) this.lightFits = false;
  }

  /** The climate is another. */
  recolour(): void {
    for (const { fine, quick } of this.sets) fine.albedoFits = quick.albedoFits = false;
  }

  /** Everything that the 3D view needs is there. */
  get fits(): boolean {
    const fine = this.sets[0]?.fine;
    return fine !== undefined && fine.surfaceFits && fine.albedoFits && fine.litFits && this.lightFits;
  }

  /** Bakes gradients, coarsely where it must be quick and there are no fine ones: all that the map needs. After
   * upload(). */
  shape(field: HeightField, quick: boolean, within: DetailGround | null = null): void {
    const set = this.sets[0]!, ground = quick && !(set.fine.surfaceFits && set.fine.albedoFits) ? set.quick : set.fine;
    this.ground = ground;
    if (ground.surfaceFits) return;
    const { uniforms } = this.surfaceBake;
    uniforms.heights!.value = set.heights;
    uniforms.cell_m!.value = field.frame.cell_m;
    const slope = (within?.coarse ?? field).typicalSlope;
    uniforms.relief_scale!.value = slope > 0 ? Math.min(12, Math.max(0.3, 0.62 / slope)) : 1;
    uniforms.broad!.value = 5 * 2 ** (within?.levels ?? 0);
    uniforms.result_size!.value = [ground.surface.width, ground.surface.height];
    this.surfaceBake.into(this.renderer, ground.surface);
    ground.surfaceFits = true;
  }

  /** Colours in their light, for the 3D view. After shape(). A moving view keeps the shadows that there were. */
  colour(field: HeightField, options: ViewOptions, style: number, quick: boolean, within: Within | null = null): void {
    const ground = this.ground!;
    if (!ground.albedoFits) this.bakeAlbedo(ground, field, options.climate, within?.ground ?? null);
    if (this.light === null || (!quick && !this.lightFits)) this.bakeLight(ground, field, options, within);
    if (!ground.litFits) this.bakeLit(ground, options, style);
  }

  dispose(): void {
    for (const set of this.sets.splice(0)) disposeSet(set);
    this.light?.dispose();
    this.low?.dispose();
    for (const bake of [this.surfaceBake, this.albedoBake, this.lightBake, this.litBake]) bake.dispose();
  }

  private bakeAlbedo(ground: Ground, field: HeightField, chosen: ClimateChoice, within: DetailGround | null): void {
    const whole = within?.coarse ?? field, cell_m = field.width_m / ground.surface.width;
    const { uniforms } = this.albedoBake, climate = climateOf(whole.frame, whole.inSea, chosen);
    uniforms.surface!.value = ground.surface.texture;
    uniforms.dry!.value = this.dry;
    uniforms.cell_m!.value = cell_m;
    uniforms.coarse_m!.value = within === null ? cell_m : whole.frame.cell_m;
    uniforms.finer!.value = within?.levels ?? 0;
    uniforms.middle!.value = [field.centre[0] - whole.centre[0], whole.centre[1] - field.centre[1]];
    uniforms.scale!.value = ground.albedo.width / ground.surface.width;
    uniforms.warmth_c!.value = climate.seaLevel_c;
    uniforms.rain_mm!.value = climate.rain_mm;
    uniforms.latitude!.value = climate.latitude;
    const from = (climate.windFrom_deg * Math.PI) / 180;
    uniforms.rain_from!.value = [Math.sin(from), Math.cos(from)];
    uniforms.low_m!.value = Math.max(0, whole.min);
    uniforms.basalt!.value = climate.basalt;
    uniforms.snow_line!.value = climate.snowLine;
    uniforms.tree_line!.value = climate.treeLine;
    this.albedoBake.into(this.renderer, ground.albedo, [this.low === null ? "" : "DRY"]);
    ground.albedoFits = true;
    ground.litFits = false;
  }

  /** Shadows and open sky. */
  private bakeLight(ground: Ground, field: HeightField, options: ViewOptions, within: Within | null): void {
    const most = field.coarse ? Math.min(128, this.budget.lightCells) : this.budget.lightCells;
    const [width, height] = sizeWithin(most, field.columns, field.rows);
    if (this.light === null || this.light.width !== width || this.light.height !== height) {
      this.light?.dispose();
      this.light = target(width, height, false, false);
    }
    const { uniforms } = this.lightBake;
    if (within !== null) {
      const [x, y, across, down] = within.ground.place;
      uniforms.around!.value = within.around.surface;
      uniforms.around_dry!.value = within.around.dry;
      uniforms.around_place!.value = [-x / across, -y / down, 1 / across, 1 / down];
      uniforms.finer!.value = within.ground.levels;
    }
    uniforms.surface!.value = ground.surface.texture;
    uniforms.dry!.value = this.dry;
    uniforms.cell_m!.value = field.width_m / ground.surface.width;
    uniforms.exaggeration!.value = options.exaggeration;
    uniforms.floor_m!.value = options.water ? 0 : -1e9;
    uniforms.to_sun!.value = sunVector(options.sun);
    uniforms.light_size!.value = [width, height];
    const dry = this.low !== null || (within?.around.low ?? null) !== null;
    this.lightBake.into(this.renderer, this.light, [within === null ? "" : "AROUND", dry ? "DRY" : ""]);
    this.lightFits = true;
    ground.litFits = false;
  }

  private bakeLit(ground: Ground, options: ViewOptions, style: number): void {
    const { uniforms } = this.litBake, light = lamps(options.sun);
    uniforms.surface!.value = ground.surface.texture;
    uniforms.dry!.value = this.dry;
    uniforms.albedo!.value = ground.albedo.texture;
    uniforms.lights!.value = this.light!.texture;
    uniforms.exaggeration!.value = options.exaggeration;
    uniforms.floor_m!.value = options.water ? 0 : -1e9;
    uniforms.to_sun!.value = light.toSun;
    uniforms.sun_light!.value = light.sun;
    uniforms.sky_light!.value = light.sky;
    uniforms.ground_style!.value = style;
    this.litBake.into(this.renderer, ground.lit, [this.low === null ? "" : "DRY"]);
    ground.litFits = true;
  }

  /** Sets of the last few sizes are kept: coarse and full results alternate. The one in use is the first. */
  private setOf(columns: number, rows: number): Set {
    const index = this.sets.findIndex((s) => s.columns === columns && s.rows === rows);
    const set = index >= 0 ? this.sets.splice(index, 1)[0]! : this.made(columns, rows);
    this.sets.unshift(set);
    for (const old of this.sets.splice(this.kept)) disposeSet(old);
    return set;
  }

  private made(columns: number, rows: number): Set {
    const { budget } = this, most = Math.max(columns, rows);
    const heights = new DataTexture(null, columns, rows, RedFormat, FloatType);
    heights.minFilter = heights.magFilter = NearestFilter;
    heights.unpackAlignment = 4;
    const fine = this.groundOf(columns, rows, budget.colourCells);
    if (most <= Math.min(budget.quickCells, budget.quickColourCells)) {
      return { columns, rows, heights, fine, quick: fine };
    }
    return {
      columns, rows, heights, fine,
      quick: this.groundOf(...sizeWithin(budget.quickCells, columns, rows), budget.quickColourCells),
    };
  }

  private groundOf(columns: number, rows: number, colourCells: number): Ground {
    const ground: Ground = {
      surface: target(columns, rows, true), albedo: target(...sizeWithin(colourCells, columns, rows), false, false),
      lit: target(columns, rows, false), surfaceFits: false, albedoFits: false, litFits: false,
    };
    for (const { texture } of [ground.surface, ground.lit]) {
      texture.anisotropy = this.budget.anisotropy;
      texture.minFilter = this.budget.smoothLevels ? LinearMipmapLinearFilter : LinearMipmapNearestFilter;
    }
    return ground;
  }
}

/** So many cells, or as many as fit. */
function sizeWithin(most: number, columns: number, rows: number): [number, number] {
  const scale = Math.min(1, most / Math.max(columns, rows));
  return [Math.max(1, Math.ceil(columns * scale)), Math.max(1, Math.ceil(rows * scale))];
}

function disposeSet({ heights, fine, quick }: Set): void {
  heights.dispose();
  for (const { surface, albedo, lit } of [fine, quick]) for (const part of [surface, albedo, lit]) part.dispose();
}
