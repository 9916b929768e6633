// The picture of the map: one rectangle that the shader fills.
import {
  GLSL3, Mesh, OrthographicCamera, PlaneGeometry, RawShaderMaterial, Scene, Vector3, type IUniform, type WebGLRenderer,
} from "three";
import type { DetailGround } from "./detail_ground";
import { nowhere } from "./dry_texture";
import type { HeightField } from "./heights";
import type { MapEye, Size } from "./map_camera";
import common from "./shaders/common.glsl";
import detailShader from "./shaders/detail.glsl";
import mapFragment from "./shaders/map.frag.glsl";
import mapVertex from "./shaders/map.vert.glsl";
import overlayShader from "./shaders/overlay.glsl";
import type { SharedUniforms } from "./shared_uniforms";
import { tintScale, tintTexture } from "./tints";

export interface MapPicture {
  /** The ground whose textures are shown. */
  field: HeightField;
  /** Goes over into the ground at its border. */
  detail: DetailGround | null;
  /** The tints are those of its heights. */
  tinted: HeightField;
  eye: MapEye;
  size: Size;
  /** Of the pixels that are drawn. */
  pixel_m: number;
  water: boolean;
  /** No time for smooth heights between cells. */
  quick: boolean;
  /** Linear light around the ground. */
  paper: readonly [number, number, number];
}

export class MapScene {
  /** The map may show other ground than the 3D view. */
  readonly ground: Pick<
    SharedUniforms, "heights" | "surface" | "lit" | "dry" | "cell_m" | "overlay" | "overlay_place"
  > = {
    heights: { value: null }, surface: { value: null }, lit: { value: null }, dry: { value: nowhere },
    cell_m: { value: 1 }, overlay: { value: null },
    overlay_place: { value: [0, 0, 1, 1] },
  };
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly uniforms: { [name: string]: IUniform };
  private readonly mesh = new Mesh<PlaneGeometry, RawShaderMaterial>(new PlaneGeometry(2, 2));
  private readonly variants = new Map<string, RawShaderMaterial>();

  constructor(shared: SharedUniforms) {
    this.uniforms = {
      ...shared, ...this.ground,
      tints: { value: tintTexture() }, map_place: { value: [0.5, 0.5, 0.5, 0.5] }, pixel_m: { value: 1 },
      tint_scale: { value: new Vector3(1000, 0, 1000) }, paper: { value: new Vector3(0.01, 0.01, 0.01) },
      water: { value: true },
    };
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  render(renderer: WebGLRenderer, picture: MapPicture): void {
    const { field, detail, tinted, eye, size, pixel_m, water, quick, paper } = picture;
    const u = this.uniforms, { frame } = field;
    u.map_place!.value = [
      (eye.x - frame.west) / field.width_m, (frame.north - eye.y) / field.height_m,
      (0.5 * size.width * eye.pixel_m) / field.width_m, (-0.5 * size.height * eye.pixel_m) / field.height_m,
    ];
    u.pixel_m!.value = pixel_m;
    const { min, max, lowestSea, lowestDry } = tinted;
    const scale = water
      ? tintScale(lowestSea < 0 ? lowestSea : min, max, lowestDry)
      : { deepest: 1, base: min, top: Math.max(max, min + 1) };
    (u.tint_scale!.value as Vector3).set(scale.deepest, scale.base, scale.top);
    (u.paper!.value as Vector3).set(...paper);
    u.water!.value = water;
    // Cells that are larger than pixels are sampled finely.
    const names = [
      u.overlay_strength!.value > 0 ? "OVERLAY" : "",
      detail !== null && u.overlay_fine!.value === true ? "FINE_OVERLAY" : "", detail !== null ? "DETAIL" : "",
      field.dry !== null || (detail?.field.dry ?? null) !== null ? "DRY" : "",
      !quick && pixel_m < 1.5 * (detail?.cell_m ?? frame.cell_m) ? "SMOOTH" : "",
    ];
    this.mesh.material = this.variant(names.filter((name) => name !== ""));
    renderer.render(this.scene, this.camera);
  }

  private variant(defines: string[]): RawShaderMaterial {
    const key = defines.join(" ");
    let made = this.variants.get(key);
    if (made === undefined) {
      const head = defines.map((name) => `#define ${name}\n`).join("");
      made = new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader: mapVertex, uniforms: this.uniforms, depthTest: false, depthWrite: false,
        fragmentShader: head + common + detailShader + overlayShader + mapFragment,
      });
      this.variants.set(key, made);
    }
    return made;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    for (const material of this.variants.values()) material.dispose();
    this.uniforms.tints!.value.dispose();
  }
}
