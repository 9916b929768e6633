// The meshes of things on the ground: one for each model, drawn once for the instances that a picture needs.
import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, GLSL3, Group, InstancedBufferAttribute,
  InstancedBufferGeometry,
  InterleavedBuffer, InterleavedBufferAttribute, Mesh, RawShaderMaterial, Vector3, type IUniform,
} from "three";
import type { HeightField } from "./heights";
import common from "./shaders/common.glsl";
import skyShader from "./shaders/sky.glsl";
import thingsFragment from "./shaders/things.frag.glsl";
import thingsVertex from "./shaders/things.vert.glsl";
import { chooseThings, thingNumbers, type Things, type ThingsView } from "./things";

interface Part {
  mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  geometry: InstancedBufferGeometry;
  places: InstancedBufferAttribute;
  angles: InstancedBufferAttribute;
}

export class ThingsMesh {
  readonly group = new Group();
  private readonly parts: Part[];
  private readonly origin: readonly [number, number];
  private readonly shift = { value: new Vector3() };

  constructor(private readonly things: Things, field: HeightField, uniforms: { [name: string]: IUniform }) {
    this.origin = field.centre;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: thingsVertex, fragmentShader: common + skyShader + thingsFragment,
      side: DoubleSide,
      uniforms: { ...uniforms, origin_shift: this.shift },
    });
    this.parts = things.models.map(
      (model, m) => this.part(model.corners, things.instances[m]!.length / thingNumbers, material),
    );
  }

  choose(field: HeightField, view: ThingsView): void {
    const [cx, cy] = field.centre;
    this.shift.value.set(this.origin[0] - cx, this.origin[1] - cy, 0);
    chooseThings(this.things, view).forEach(
      (indices, m) => this.fill(this.parts[m]!, this.things.instances[m]!, indices),
    );
  }

  dispose(): void {
    for (const { geometry, mesh } of this.parts) {
      geometry.dispose();
      mesh.material.dispose();
    }
    this.group.removeFromParent();
  }

  private part(corners: Float32Array, count: number, material: RawShaderMaterial): Part {
    const geometry = new InstancedBufferGeometry();
    const buffer = new InterleavedBuffer(corners, 9);
    geometry.setAttribute("position", new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute("normal", new InterleavedBufferAttribute(buffer, 3, 3));
    geometry.setAttribute("colour", new InterleavedBufferAttribute(buffer, 3, 6));
    const places = new InstancedBufferAttribute(new Float32Array(4 * count), 4);
    const angles = new InstancedBufferAttribute(new Float32Array(count), 1);
    for (const attribute of [places, angles] as BufferAttribute[]) attribute.setUsage(DynamicDrawUsage);
    geometry.setAttribute("thing", places);
    geometry.setAttribute("angle", angles);
    geometry.instanceCount = 0;
    const mesh = new Mesh<BufferGeometry, RawShaderMaterial>(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = 1.5;
    this.group.add(mesh);
    return { mesh, geometry, places, angles };
  }

  private fill(part: Part, numbers: Float64Array, indices: Uint32Array): void {
    part.geometry.instanceCount = indices.length;
    part.mesh.visible = indices.length > 0;
    indices.forEach((index, k) => {
      const i = index * thingNumbers;
      part.places.setXYZW(
        k, numbers[i]! - this.origin[0], numbers[i + 1]! - this.origin[1], numbers[i + 2]!, numbers[i + 4]!,
      );
      part.angles.setX(k, numbers[i + 3]!);
    });
    for (const attribute of [part.places, part.angles]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, indices.length * attribute.itemSize);
      attribute.needsUpdate = true;
    }
  }
}
