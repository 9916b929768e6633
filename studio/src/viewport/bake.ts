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
  private readonly mesh = new Mesh<PlaneGeometry, RawShaderMaterial>(new PlaneGeometry(2, 2));
  private readonly variants = new Map<string, RawShaderMaterial>();

  constructor(private readonly shader: string, readonly uniforms: Uniforms) {
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  /** `defines`: what the shader is to do besides; empty words say nothing. */
  into(renderer: WebGLRenderer, target: WebGLRenderTarget, defines: readonly string[] = []): void {
    this.mesh.material = this.variant(defines.filter((name) => name !== ""));
    renderer.setRenderTarget(target);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    for (const material of this.variants.values()) material.dispose();
  }

  private variant(defines: readonly string[]): RawShaderMaterial {
    const key = defines.join(" ");
    let made = this.variants.get(key);
    if (made === undefined) {
      const head = defines.map((name) => `#define ${name}\n`).join("");
      made = new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader: bakeVertex, fragmentShader: head + common + this.shader,
        uniforms: this.uniforms, depthTest: false, depthWrite: false,
      });
      this.variants.set(key, made);
    }
    return made;
  }
}

export function target(width: number, height: number, half: boolean, mipmaps = true): WebGLRenderTarget {
  return new WebGLRenderTarget(width, height, {
    format: RGBAFormat, type: half ? HalfFloatType : UnsignedByteType, depthBuffer: false, generateMipmaps: mipmaps,
    magFilter: LinearFilter, minFilter: mipmaps ? LinearMipmapLinearFilter : LinearFilter, wrapS: ClampToEdgeWrapping,
    wrapT: ClampToEdgeWrapping,
  });
}
