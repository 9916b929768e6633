// The 3D picture: patches of ground, the sea's plane around them, and the sky.
import {
  GLSL3, DoubleSide, Mesh, PerspectiveCamera, PlaneGeometry, RawShaderMaterial, Scene, Vector3, Matrix4,
  type BufferGeometry, type IUniform,
  type WebGLRenderer,
} from "three";
import { heightAt, type DetailGround } from "./detail_ground";
import type { HeightField } from "./heights";
import { lamps } from "./light";
import type { ViewOptions } from "./options";
import { choosePatches } from "./patches";
import { PatchGeometry } from "./patch_mesh";
import common from "./shaders/common.glsl";
import detailShader from "./shaders/detail.glsl";
import groundFragment from "./shaders/ground.frag.glsl";
import groundVertex from "./shaders/ground.vert.glsl";
import overlayShader from "./shaders/overlay.glsl";
import seaVertex from "./shaders/sea.vert.glsl";
import skyFragment from "./shaders/sky.frag.glsl";
import skyShader from "./shaders/sky.glsl";
import skyVertex from "./shaders/sky.vert.glsl";
import wallFragment from "./shaders/wall.frag.glsl";
import wireFragment from "./shaders/wire.frag.glsl";
import type { SharedUniforms } from "./shared_uniforms";
import type { Things } from "./things";
import { ThingsMesh } from "./things_mesh";
import { axes, viewPlanes, type Eye, type Lens } from "./world_camera";

const light = common + detailShader + skyShader + overlayShader + groundFragment;
/** Of vertices and pixels; both are told what a picture needs. */
const shaders = {
  ground: [groundVertex, light], sea: [seaVertex, light], wall: [groundVertex, common + skyShader + wallFragment],
  wire: [groundVertex, common + wireFragment],
} as const;

const hazeDepth = 0.022;

export class WorldScene {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera();
  private readonly geometry = new PatchGeometry();
  private readonly uniforms: { [name: string]: IUniform };
  private readonly plain: RawShaderMaterial[] = [];
  private readonly variants = new Map<string, RawShaderMaterial>();
  private readonly ground: Mesh;
  private readonly sea: Mesh;
  private readonly wire: Mesh;
  private things: ThingsMesh | null = null;
  triangles = 0;
  /** Of ground that is drawn at most. */
  patchBudget = 170;
  /** Triangles of things. */
  thingBudget = 120_000;

  constructor(shared: SharedUniforms) {
    this.uniforms = {
      ...shared,
      eye: { value: new Vector3() }, base_m: { value: -100 }, border_depth: { value: 1000 }, floor_m: { value: 0 },
      exaggeration: { value: 1 }, sea_size: { value: [1, 1] }, half_size: { value: [1, 1] }, in_sea: { value: true },
      to_sun: { value: new Vector3(0, 0, 1) }, sun_light: { value: new Vector3() }, sky_light: { value: new Vector3() },
      sky_scale: { value: 1 }, haze_density: { value: 0 }, haze_far: { value: 1 }, forward: { value: new Vector3() },
      right: { value: new Vector3() }, upward: { value: new Vector3() }, pixel_angle: { value: 1 },
      sun_path: { value: 1 }, wire_colour: { value: [1, 1, 1, 0.22] },
    };
    this.ground = this.mesh(this.geometry, [], 0);
    this.sea = this.mesh(new PlaneGeometry(2, 2), [], 1);
    this.sea.geometry.addGroup(0, Infinity, 0);
    const skyMaterial = this.material(skyVertex, common + skyShader + skyFragment);
    skyMaterial.depthWrite = false;
    this.mesh(new PlaneGeometry(2, 2), skyMaterial, 2);
    this.wire = this.mesh(this.geometry, [], 3);
    this.camera.up.set(0, 0, 1);
  }

  /** Stands things on the ground; null: none. */
  setThings(things: Things | null, field: HeightField): void {
    this.things?.dispose();
    this.things = things === null ? null : new ThingsMesh(things, field, this.uniforms);
    if (this.things !== null) this.scene.add(this.things.group);
  }

  /** Draws into the renderer's current target of the size of the lens. `jitter`: parts of a pixel. */
  render(
    renderer: WebGLRenderer, field: HeightField, detail: DetailGround | null, options: ViewOptions, eye: Eye,
    lens: Lens, jitter: readonly [number, number], fine: boolean,
  ): void {
    const [cx, cy] = field.centre;
    const local: [number, number, number] = [eye.at[0] - cx, eye.at[1] - cy, eye.at[2]];
    const below = heightAt(field, detail, eye.at[0], eye.at[1]) ?? 0;
    const above = Math.max(1, local[2] - options.exaggeration * Math.max(field.lowestDry, below));
    this.place(eye, local, lens, field, above, jitter);
    this.light(field, options, lens);
    const origin = [field.frame.west, field.frame.north] as const;
    this.geometry.show(choosePatches(field, {
      eye: [eye.at[0] - origin[0], origin[1] - eye.at[1], eye.at[2]],
      planes: viewPlanes(eye, lens, origin),
      exaggeration: options.exaggeration,
      floor: options.water ? 0 : -Infinity,
      budget: this.patchBudget,
      walls: cutAround(field, options),
      detail,
    }));
    this.things?.choose(field, {
      eye: eye.at, planes: viewPlanes(eye, lens, [0, 0], 1), exaggeration: options.exaggeration,
      pixel: (2 * Math.tan(lens.fov / 2)) / lens.height, budget: fine ? this.thingBudget : this.thingBudget / 3,
    });
    this.dress(field, detail, options, above, fine);
    this.ground.visible = this.geometry.instanceCount > 0;
    this.wire.visible = options.wireframe && this.ground.visible;
    renderer.render(this.scene, this.camera);
    this.triangles = renderer.info.render.triangles;
  }

  dispose(): void {
    this.things?.dispose();
    this.scene.traverse((object) => {
      if (!(object instanceof Mesh)) return;
      object.geometry.dispose();
    });
    for (const material of this.plain) material.dispose();
  }

  private place(
    eye: Eye, local: [number, number, number], lens: Lens, field: HeightField, above: number,
    jitter: readonly [number, number],
  ): void {
    const camera = this.camera, size = Math.max(field.width_m, field.height_m);
    const { forward, right, up } = axes(eye);
    camera.fov = (lens.fov * 180) / Math.PI;
    camera.aspect = lens.width / lens.height;
    camera.near = Math.max(0.5, Math.min(0.3 * above, 0.05 * size));
    camera.far = 60 * size + 20 * above;
    camera.setViewOffset(lens.width, lens.height, jitter[0], jitter[1], lens.width, lens.height);
    camera.updateProjectionMatrix();
    camera.matrixAutoUpdate = false;
    const back = new Vector3(...forward).negate();
    camera.matrix.copy(new Matrix4().makeBasis(new Vector3(...right), new Vector3(...up), back));
    camera.matrix.setPosition(...local);
    camera.matrixWorld.copy(camera.matrix);
    camera.matrixWorldInverse.copy(camera.matrix).invert();
    camera.matrixWorldAutoUpdate = false;
    (this.uniforms.eye!.value as Vector3).set(...local);
    const tan = Math.tan(lens.fov / 2);
    (this.uniforms.forward!.value as Vector3).set(...forward);
    (this.uniforms.right!.value as Vector3).set(...right).multiplyScalar(tan * camera.aspect);
    (this.uniforms.upward!.value as Vector3).set(...up).multiplyScalar(tan);
  }

  private light(field: HeightField, options: ViewOptions, lens: Lens): void {
    const u = this.uniforms, size = Math.max(field.width_m, field.height_m);
    const lit = lamps(options.sun);
    (u.to_sun!.value as Vector3).set(...lit.toSun);
    (u.sun_light!.value as Vector3).set(...lit.sun);
    (u.sky_light!.value as Vector3).set(...lit.sky);
    u.sky_scale!.value = lit.skyScale;
    u.sun_path!.value = 1 / Math.sqrt(1 - (1 - Math.max(0.02, lit.toSun[2]) ** 2) / 1.777);
    u.pixel_angle!.value = (2 * Math.tan(lens.fov / 2)) / lens.height;
    u.haze_density!.value = hazeDepth / size;
    u.haze_far!.value = 2.5 * size;
    u.exaggeration!.value = options.exaggeration;
    u.floor_m!.value = options.water ? 0 : -1e9;
    const lowest = options.exaggeration * (options.water ? Math.min(0, Math.max(field.min, 0)) : field.min);
    u.base_m!.value = (options.water && field.min < 0 ? 0 : lowest) - 0.022 * size;
    if (options.water && field.min >= 0) u.base_m!.value = options.exaggeration * field.min - 0.022 * size;
    u.border_depth!.value = field.borderDepth;
    u.half_size!.value = [field.width_m / 2, field.height_m / 2];
    u.sea_size!.value = field.inSea ? [50 * size, 50 * size] : [field.width_m / 2, field.height_m / 2];
    u.in_sea!.value = field.inSea && options.water;
    this.sea.visible = options.water && field.min <= 0;
  }

  /** Chooses the shaders that do what this picture needs and no more. */
  private dress(
    field: HeightField, detail: DetailGround | null, options: ViewOptions, above: number, fine: boolean,
  ): void {
    const magnified = fine && above * this.uniforms.pixel_angle!.value * 1.6 < (detail?.cell_m ?? field.frame.cell_m);
    const dry = options.water && (field.dry !== null || (detail?.field.dry ?? null) !== null) ? ["DRY"] : [];
    const names = [
      ...dry, detail !== null ? "DETAIL" : "", fine ? "FINE" : "", magnified ? "SMOOTH" : "",
      this.uniforms.overlay_strength!.value > 0 ? "OVERLAY" : "",
      detail !== null && this.uniforms.overlay_fine!.value === true ? "FINE_OVERLAY" : "",
      this.uniforms.contour_m!.value > 0 ? "CONTOURS" : "",
    ].filter((name) => name !== "");
    const ground = this.variant("ground", options.water && field.min <= 0 ? [...names, "WATER"] : names);
    this.ground.material = cutAround(field, options) ? [ground, this.variant("wall", dry)] : [ground];
    this.sea.material = [this.variant("sea", [...names.filter((name) => name !== "CONTOURS"), "PLANE"])];
    this.wire.material = this.variant("wire", dry);
  }

  private variant(of: keyof typeof shaders, defines: string[]): RawShaderMaterial {
    const key = [of, ...defines].join(" ");
    let made = this.variants.get(key);
    if (made === undefined) {
      const head = defines.map((name) => `#define ${name}\n`).join(""), [vertex, fragment] = shaders[of];
      made = this.material(head + detailShader + vertex, head + fragment);
      if (of === "wire") made.wireframe = made.transparent = true;
      if (of === "sea") {
        made.polygonOffset = true;
        made.polygonOffsetFactor = made.polygonOffsetUnits = 2;
      }
      this.variants.set(key, made);
    }
    return made;
  }

  private material(vertexShader: string, fragmentShader: string): RawShaderMaterial {
    const made = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, uniforms: this.uniforms, side: DoubleSide,
    });
    this.plain.push(made);
    return made;
  }

  private mesh(
    geometry: PatchGeometry | PlaneGeometry, material: RawShaderMaterial | RawShaderMaterial[], order: number,
  ): Mesh {
    const mesh = new Mesh<BufferGeometry, RawShaderMaterial | RawShaderMaterial[]>(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = order;
    this.scene.add(mesh);
    return mesh;
  }
}

/** The ground is cut at its edges: no sea goes on there, or land reaches them. */
function cutAround(field: HeightField, options: ViewOptions): boolean {
  return field.seaBorder < 1 || !options.water;
}
