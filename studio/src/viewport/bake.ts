// Pictures that a shader fills from others: what is computed of the ground on the graphics side.
import {
  ClampToEdgeWrapping, GLSL3, HalfFloatType, LinearFilter, LinearMipmapLinearFilter, Mesh, OrthographicCamera,
  PlaneGeometry,
  RawShaderMaterial, RGBAFormat, Scene, UnsignedByteType, WebGLRenderTarget, type IUniform, type WebGLRenderer,
} from "three";
import bakeVertex from "./shaders/bake.vert.glsl";
import common from "./shaders/common.glsl";

type Uniforms = { [name: string]: IUniform };

export class Bake {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly material: RawShaderMaterial;

  constructor(shader: string, readonly uniforms: Uniforms) {
    this.material = new RawShaderMaterial({
      glslVersion: GLSL3, vertexShader: bakeVertex, fragmentShader: common + shader, uniforms, depthTest: false,
      depthWrite: false,
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

export function target(width: number, height: number, half: boolean, mipmaps = true): WebGLRenderTarget {
  return new WebGLRenderTarget(width, height, {
    format: RGBAFormat, type: half ? HalfFloatType : UnsignedByteType, depthBuffer: false, generateMipmaps: mipmaps,
    magFilter: LinearFilter, minFilter: mipmaps ? LinearMipmapLinearFilter : LinearFilter, wrapS: ClampToEdgeWrapping,
    wrapT: ClampToEdgeWrapping,
  });
}
