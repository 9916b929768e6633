// The height field on the graphics side, shared by both views: heights as they are (R32F, sampled by hand), and what is
// baked of them once, so that frames are cheap and far ground does not shimmer: gradients, natural colours, light.
import {
  ClampToEdgeWrapping, DataTexture, FloatType, GLSL3, HalfFloatType, LinearFilter, LinearMipmapLinearFilter, LinearMipmapNearestFilter, Mesh,
  NearestFilter, OrthographicCamera, PlaneGeometry, RawShaderMaterial, RedFormat, RGBAFormat, Scene, UnsignedByteType,
  WebGLRenderTarget, type IUniform, type Texture, type WebGLRenderer,
} from "three";
import { climateOf } from "./climate";
import type { HeightField } from "./heights";
import { lamps } from "./light";
import { sunVector, type ViewOptions } from "./options";
import albedoShader from "./shaders/bake_albedo.frag.glsl";
import litShader from "./shaders/bake_lit.frag.glsl";
import lightShader from "./shaders/bake_light.frag.glsl";
import surfaceShader from "./shaders/bake_surface.frag.glsl";
import bakeVertex from "./shaders/bake.vert.glsl";
import common from "./shaders/common.glsl";
import overlayShader from "./shaders/overlay.glsl";

type Uniforms = { [name: string]: IUniform };

class Bake {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly material: RawShaderMaterial;

  constructor(shader: string, readonly uniforms: Uniforms) {
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: bakeVertex, fragmentShader: common + shader, uniforms, depthTest: false, depthWrite: false,
    });
    const mesh = new Mesh(new PlaneGeometry(2, 2), this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
  }

  into(renderer: WebGLRenderer, target: WebGLRenderTarget): void {
    renderer.setRenderTarget(target);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.material.dispose();
  }
}

function target(width: number, height: number, half: boolean, mipmaps = true): WebGLRenderTarget {
  return new WebGLRenderTarget(width, height, {
    format: RGBAFormat, type: half ? HalfFloatType : UnsignedByteType, depthBuffer: false, generateMipmaps: mipmaps,
    magFilter: LinearFilter, minFilter: mipmaps ? LinearMipmapLinearFilter : LinearFilter, wrapS: ClampToEdgeWrapping, wrapT: ClampToEdgeWrapping,
  });
}

interface Set {
  columns: number;
  rows: number;
  heights: DataTexture;
  surface: WebGLRenderTarget;
  albedo: WebGLRenderTarget;
  lit: WebGLRenderTarget;
}

const keptSets = 3;

/** What suits the machine. */
export interface TextureBudget {
  /** Cells along the longer side of the light's texture. */
  lightCells: number;
  /** Of the colours' texture. */
  colourCells: number;
  anisotropy: number;
  /** Between levels of a texture, too. */
  smoothLevels: boolean;
}

export class GroundTextures {
  private readonly sets: Set[] = [];
  private light: WebGLRenderTarget | null = null;
  private readonly surfaceBake: Bake;
  private readonly albedoBake: Bake;
  private readonly lightBake: Bake;
  private readonly litBake: Bake;

  constructor(private readonly renderer: WebGLRenderer, noise: Texture, private readonly budget: TextureBudget) {
    this.surfaceBake = new Bake(surfaceShader, { heights: { value: null }, cell_m: { value: 1 }, relief_scale: { value: 1 } });
    this.albedoBake = new Bake(albedoShader, {
      surface: { value: null }, noise: { value: noise }, cell_m: { value: 1 }, scale: { value: 1 }, tropical: { value: true },
      snow_line: { value: 5000 }, tree_line: { value: 3900 },
    });
    this.lightBake = new Bake(lightShader, {
      surface: { value: null }, heights: { value: null }, cell_m: { value: 1 }, exaggeration: { value: 1 },
      floor_m: { value: 0 }, to_sun: { value: [0, 0, 1] }, light_size: { value: [1, 1] },
    });
    const none = { value: null };
    this.litBake = new Bake(overlayShader + litShader, {
      surface: { ...none }, albedo: { ...none }, lights: { ...none }, exaggeration: { value: 1 }, floor_m: { value: 0 },
      to_sun: { value: [0, 0, 1] }, sun_light: { value: [1, 1, 1] }, sky_light: { value: [1, 1, 1] }, ground_style: { value: 0 },
    });
  }

  get heights(): Texture | null {
    return this.sets[0]?.heights ?? null;
  }
  get surface(): Texture | null {
    return this.sets[0]?.surface.texture ?? null;
  }
  get hasLight(): boolean {
    return this.light !== null;
  }
  get lit(): Texture | null {
    return this.sets[0]?.lit.texture ?? null;
  }

  /** Uploads heights and bakes what depends on nothing else. */
  update(field: HeightField): void {
    const set = this.setOf(field.columns, field.rows);
    set.heights.image = { data: field.values as Float32Array<ArrayBuffer>, width: field.columns, height: field.rows };
    set.heights.needsUpdate = true;
    const surface = this.surfaceBake.uniforms, albedo = this.albedoBake.uniforms;
    surface.heights!.value = set.heights;
    surface.cell_m!.value = albedo.cell_m!.value = field.frame.cell_m;
    surface.relief_scale!.value = field.typicalSlope > 0 ? Math.min(12, Math.max(0.3, 0.62 / field.typicalSlope)) : 1;
    this.surfaceBake.into(this.renderer, set.surface);
    albedo.surface!.value = set.surface.texture;
    albedo.scale!.value = set.albedo.width / set.columns;
    const climate = climateOf(field.frame, field.inSea);
    albedo.tropical!.value = climate.tropical;
    albedo.snow_line!.value = climate.snowLine;
    albedo.tree_line!.value = climate.treeLine;
    this.albedoBake.into(this.renderer, set.albedo);
  }

  /** Shadows and open sky: after update, or when sun, water or exaggeration are others. */
  updateLight(field: HeightField, options: ViewOptions): void {
    const set = this.sets[0];
    if (set === undefined) return;
    const most = field.coarse ? Math.min(128, this.budget.lightCells) : this.budget.lightCells;
    const scale = Math.min(1, most / Math.max(field.columns, field.rows));
    const width = Math.max(1, Math.round(field.columns * scale)), height = Math.max(1, Math.round(field.rows * scale));
    if (this.light === null || this.light.width !== width || this.light.height !== height) {
      this.light?.dispose();
      this.light = target(width, height, false, false);
    }
    const light = this.lightBake.uniforms;
    light.surface!.value = set.surface.texture;
    light.heights!.value = set.heights;
    light.cell_m!.value = field.frame.cell_m;
    light.exaggeration!.value = options.exaggeration;
    light.floor_m!.value = options.water ? 0 : -1e9;
    light.to_sun!.value = sunVector(options.sun);
    light.light_size!.value = [width, height];
    this.lightBake.into(this.renderer, this.light);
  }

  /** Colours in their light: after the others, or when the style of the ground is another. */
  updateLit(options: ViewOptions, style: number): void {
    const set = this.sets[0];
    if (set === undefined || this.light === null) return;
    const lit = this.litBake.uniforms, light = lamps(options.sun);
    lit.surface!.value = set.surface.texture;
    lit.albedo!.value = set.albedo.texture;
    lit.lights!.value = this.light.texture;
    lit.exaggeration!.value = options.exaggeration;
    lit.floor_m!.value = options.water ? 0 : -1e9;
    lit.to_sun!.value = light.toSun;
    lit.sun_light!.value = light.sun;
    lit.sky_light!.value = light.sky;
    lit.ground_style!.value = style;
    this.litBake.into(this.renderer, set.lit);
  }

  dispose(): void {
    for (const set of this.sets.splice(0)) disposeSet(set);
    this.light?.dispose();
    for (const bake of [this.surfaceBake, this.albedoBake, this.lightBake, this.litBake]) bake.dispose();
  }

  /** Sets of the last few sizes are kept: coarse and full results alternate. The one in use is the first. */
  private setOf(columns: number, rows: number): Set {
    const index = this.sets.findIndex((s) => s.columns === columns && s.rows === rows);
    const set = index >= 0 ? this.sets.splice(index, 1)[0]! : this.made(columns, rows);
    this.sets.unshift(set);
    for (const old of this.sets.splice(keptSets)) disposeSet(old);
    return set;
  }

  private made(columns: number, rows: number): Set {
    const heights = new DataTexture(null, columns, rows, RedFormat, FloatType);
    heights.minFilter = heights.magFilter = NearestFilter;
    heights.unpackAlignment = 4;
    const scale = Math.min(1, this.budget.colourCells / Math.max(columns, rows));
    const set: Set = {
      columns, rows, heights, surface: target(columns, rows, true),
      albedo: target(Math.ceil(columns * scale), Math.ceil(rows * scale), false, false),
      lit: target(columns, rows, false),
    };
    for (const { texture } of [set.surface, set.lit]) {
      texture.anisotropy = this.budget.anisotropy;
      texture.minFilter = this.budget.smoothLevels ? LinearMipmapLinearFilter : LinearMipmapNearestFilter;
    }
    return set;
  }
}

function disposeSet(set: Set): void {
  set.heights.dispose();
  set.surface.dispose();
  set.albedo.dispose();
  set.lit.dispose();
}
