// The picture of the map: one rectangle that the shader fills.
import { GLSL3, Mesh, OrthographicCamera, PlaneGeometry, RawShaderMaterial, Scene, Vector3, type IUniform, type WebGLRenderer } from "three";
import type { HeightField } from "./heights";
import type { MapEye, Size } from "./map_camera";
import common from "./shaders/common.glsl";
import mapFragment from "./shaders/map.frag.glsl";
import mapVertex from "./shaders/map.vert.glsl";
import overlayShader from "./shaders/overlay.glsl";
import type { SharedUniforms } from "./shared_uniforms";
import { tintScale, tintTexture } from "./tints";

export class MapScene {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly uniforms: { [name: string]: IUniform };
  private readonly mesh = new Mesh<PlaneGeometry, RawShaderMaterial>(new PlaneGeometry(2, 2));
  private readonly variants = new Map<string, RawShaderMaterial>();

  constructor(shared: SharedUniforms) {
    this.uniforms = {
      ...shared,
      tints: { value: tintTexture() }, map_place: { value: [0.5, 0.5, 0.5, 0.5] }, pixel_m: { value: 1 },
      tint_scale: { value: new Vector3(1000, 0, 1000) }, paper: { value: new Vector3(0.01, 0.01, 0.01) },
      water: { value: true },
    };
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  /** `pixel_m`: of the pixels that are drawn. `paper`: linear light around the ground. */
  render(renderer: WebGLRenderer, field: HeightField, eye: MapEye, size: Size, pixel_m: number, water: boolean, paper: readonly [number, number, number]): void {
    const u = this.uniforms, { frame } = field;
    u.map_place!.value = [
      (eye.x - frame.west) / field.width_m, (frame.north - eye.y) / field.height_m,
      (0.5 * size.width * eye.pixel_m) / field.width_m, (-0.5 * size.height * eye.pixel_m) / field.height_m,
    ];
    u.pixel_m!.value = pixel_m;
    const scale = water ? tintScale(field.min, field.max) : { deepest: 1, base: field.min, top: Math.max(field.max, field.min + 1) };
    (u.tint_scale!.value as Vector3).set(scale.deepest, scale.base, scale.top);
    (u.paper!.value as Vector3).set(...paper);
    u.water!.value = water;
    // Cells that are larger than pixels are sampled finely.
    const names = [u.overlay_strength!.value > 0 ? "OVERLAY" : "", pixel_m < 1.5 * frame.cell_m ? "SMOOTH" : ""];
    this.mesh.material = this.variant(names.filter((name) => name !== ""));
    renderer.render(this.scene, this.camera);
  }

  private variant(defines: string[]): RawShaderMaterial {
    const key = defines.join(" ");
    let made = this.variants.get(key);
    if (made === undefined) {
      made = new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader: mapVertex, uniforms: this.uniforms, depthTest: false, depthWrite: false,
        fragmentShader: defines.map((name) => `#define ${name}\n`).join("") + common + overlayShader + mapFragment,
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
