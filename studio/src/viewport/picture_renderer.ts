// The one WebGL renderer of both views and what it holds: textures of the ground, the scene of the 3D view, the map.
import { WebGLRenderer, type DataTexture, type Texture } from "three";
import type { DetailGround } from "./detail_ground";
import { DetailTextures, showDetail } from "./detail_textures";
import { sameWindow } from "./detail_window";
import { GroundTextures, type TextureBudget } from "./ground_textures";
import { OverlayTexture } from "./ground_overlay";
import type { HeightField } from "./heights";
import { visible, type MapEye, type Size } from "./map_camera";
import { MapScene } from "./map_scene";
import { noiseTexture } from "./noise_texture";
import type { ViewOptions } from "./options";
import {
  sharedUniforms, showOverlay, showOverlayDetail, showTextures, styleNumber, type SharedUniforms,
} from "./shared_uniforms";
import type { OverlayWindow } from "./overlay_keeper";
import { Pace } from "./pace";
import { contourInterval } from "./ticks";
import type { GroundOverlay } from "./types";
import type { ViewSurface } from "./view_surface";
import type { Eye, Lens } from "./world_camera";
import { WorldScene } from "./world_scene";

/** What a frame was: of a moving view, of one at rest as good as it gets, or neither. */
export type Sort = "quick" | "fine" | "plain";

/** What a view has of a part of the ground, and of what is laid over it there. */
export interface Known {
  ground: DetailGround | null;
  over: OverlayWindow | null;
}

export class PictureRenderer {
  readonly canvas: OffscreenCanvas;
  /** Drawn by the processor: fewer triangles, coarser light. */
  readonly software: boolean;
  readonly overlay = new OverlayTexture();
  readonly world: WorldScene;
  readonly pace: Pace;
  private fence: WebGLSync | null = null;
  private begun = 0;
  private drawnAs: Sort = "quick";
  private held: HeightField | null = null;
  private readonly quickMost = { width: 4, height: 4 };
  private readonly stillMost = { width: 4, height: 4 };
  private readonly renderer: WebGLRenderer;
  private readonly noise: DataTexture;
  private readonly shared: SharedUniforms;
  private readonly textures: GroundTextures;
  private readonly map: MapScene;
  private readonly mapDetail: DetailTextures;
  private readonly worldDetail: DetailTextures;
  /** Of the windows that the views have. */
  private readonly mapOverlay = new OverlayTexture();
  private readonly worldOverlay = new OverlayTexture();
  /** Cells of the overlay in the window that was drawn last; null: it has none of its own. */
  overlayCell_m: number | null = null;

  constructor(restored: () => void) {
    this.canvas = new OffscreenCanvas(4, 4);
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", restored);
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: false, alpha: false });
    const gl = this.renderer.getContext();
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(info === null ? gl.RENDERER : info.UNMASKED_RENDERER_WEBGL));
    this.software = /swiftshader|llvmpipe|software|basic render/i.test(name);
    this.pace = new Pace(this.software);
    gl.getExtension("EXT_color_buffer_float");
    this.renderer.autoClear = false;
    this.noise = noiseTexture(!this.software);
    this.shared = sharedUniforms(this.noise);
    const budget: TextureBudget = this.software
      ? { lightCells: 288, colourCells: 1024, quickCells: 256, quickColourCells: 160,
          anisotropy: 1, smoothLevels: false }
      : { lightCells: 1024, colourCells: 4096, quickCells: 4096, quickColourCells: 4096,
          anisotropy: 8, smoothLevels: true };
    this.textures = new GroundTextures(this.renderer, this.noise, budget);
    this.mapDetail = new DetailTextures(this.renderer, this.noise, budget);
    this.worldDetail = new DetailTextures(this.renderer, this.noise, budget);
    this.world = new WorldScene(this.shared);
    this.world.thingBudget = this.software ? 120_000 : 2_000_000;
    this.map = new MapScene(this.shared);
  }

  /** What was drawn last is done: more would only queue up. */
  ready(): boolean {
    if (this.fence === null) return true;
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    if (!gl.isContextLost() && gl.getSyncParameter(this.fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
    gl.deleteSync(this.fence);
    this.fence = null;
    if (this.drawnAs !== "plain") this.pace.took(performance.now() - this.begun, this.drawnAs === "fine");
    return true;
  }

  /** Before and after the drawing of a frame. */
  beginFrame(): void {
    this.begun = performance.now();
  }
  endFrame(sort: Sort): void {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    this.drawnAs = sort;
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  get triangles(): number {
    return this.world.triangles;
  }
  get calls(): number {
    return this.renderer.info.render.calls;
  }

  /** What is drawn from now on. Results may come faster than they can be drawn: what nobody sees is not uploaded. */
  hold(field: HeightField, quick: boolean): void {
    if (field !== this.held) this.textures.upload(field);
    this.held = field;
    this.textures.shape(field, quick);
    showTextures(this.shared, this.textures, field);
    showOverlay(this.shared, this.overlay, field);
  }

  /** The graphics processor has lost what it held. */
  forget(): void {
    this.held = null;
    this.mapDetail.forget();
    this.worldDetail.forget();
  }

  /** Sun, water or exaggeration are others, or, `shadowsToo` false, only the style of the ground. */
  relight(shadowsToo: boolean): void {
    this.textures.relight(shadowsToo);
    this.worldDetail.textures.relight(shadowsToo);
  }

  /** The climate is another. */
  recolour(): void {
    this.textures.recolour();
    this.worldDetail.textures.recolour();
  }

  updateOverlay(overlay: GroundOverlay, field: HeightField | null): void {
    this.overlay.update(overlay);
    if (field !== null) showOverlay(this.shared, this.overlay, field);
  }

  /** The detail that is drawn. */
  drawWorld(
    field: HeightField, { ground: known, over }: Known, options: ViewOptions, overlay: GroundOverlay, eye: Eye,
    lens: Lens, jitter: readonly [number, number], sort: Sort,
  ): DetailGround | null {
    const style = styleNumber(options.ground, overlay);
    this.textures.colour(field, options, style, sort === "quick");
    const ready = known !== null && this.worldDetail.colour(known, this.textures, options, style, this.hurry(sort));
    const detail = ready ? known : null;
    showDetail(this.shared, detail, this.worldDetail);
    showOverlayDetail(this.shared, this.overlayOf(this.worldOverlay, detail, over, overlay));
    this.begin(lens, sort);
    this.shared.ground_style.value = style;
    // Lines are as far apart as suits the whole terrain, not the changing distance.
    const typical = contourInterval(Math.max(field.width_m, field.height_m) / 900, field.typicalSlope, 18);
    this.shared.contour_m.value = overlay.overlay === "contours"
      ? overlay.interval_m
      : options.ground === "contours" ? typical : 0;
    this.renderer.clear(false, true, false);
    this.world.patchBudget = !this.software ? 420 : sort === "quick" ? 56 : 160;
    this.world.render(this.renderer, field, detail, options, eye, lens, jitter, sort === "fine" || !this.software);
    return detail;
  }

  /** The detail that is drawn. */
  drawMap(
    field: HeightField, { ground: known, over }: Known, options: ViewOptions, overlay: GroundOverlay, eye: MapEye,
    size: Size, pixels: Size, paper: readonly [number, number, number], sort: Sort,
  ): DetailGround | null {
    const detail = known !== null && this.mapDetail.shape(known, this.hurry(sort)) ? known : null;
    this.begin(pixels, sort);
    this.shared.ground_style.value = styleNumber(options.ground, overlay);
    this.shared.contour_m.value = overlay.overlay === "contours"
      ? overlay.interval_m
      : contourInterval(eye.pixel_m, field.typicalSlope);
    // What lies wholly in the window is drawn of it alone: that costs no more than the whole ground does.
    const alone = detail !== null && detail.covers(visible(eye, size)), ground = alone ? detail.field : field;
    showTextures(this.map.ground, alone ? this.mapDetail.textures : this.textures, ground);
    const fine = this.overlayOf(this.mapOverlay, detail, over, overlay), whole = alone && fine !== null;
    this.map.ground.overlay.value = whole ? fine : this.shared.overlay.value;
    this.map.ground.overlay_place.value = whole ? [0, 0, 1, 1] : this.overlay.placeOn(ground.frame);
    showOverlayDetail(this.shared, fine);
    showDetail(this.shared, alone ? null : detail, this.mapDetail);
    const pixel_m = (eye.pixel_m * size.width) / pixels.width;
    this.map.render(
      this.renderer,
      { field: ground, detail: alone ? null : detail, tinted: field, eye, size, pixel_m, water: options.water,
        quick: this.hurry(sort), paper },
    );
    return detail;
  }

  /** Of the window that is drawn; null: the whole one's will do. */
  private overlayOf(
    texture: OverlayTexture, detail: DetailGround | null, over: OverlayWindow | null, overlay: GroundOverlay,
  ): Texture | null {
    const raster = overlay.overlay === "labels" || overlay.overlay === "field" ? overlay.raster : null;
    const fits = detail !== null && over !== null && over.raster.key === raster?.key &&
      sameWindow(detail.window, over.window);
    this.overlayCell_m = fits ? over.raster.frame.cell_m : null;
    if (!fits || raster === null) return null;
    texture.update({ overlay: overlay.overlay as "labels" | "field", raster: over.raster });
    return texture.texture;
  }

  /** What was drawn last, on its way to the page. */
  show(surface: ViewSurface, size: Size, sort: Sort): void {
    if (sort === "quick") surface.showQuick(this.canvas.transferToImageBitmap(), size);
    else surface.show(this.canvas);
  }

  dispose(): void {
    for (const textures of [this.textures, this.mapDetail.textures, this.worldDetail.textures]) textures.dispose();
    for (const overlay of [this.overlay, this.mapOverlay, this.worldOverlay]) overlay.dispose();
    this.world.dispose();
    this.map.dispose();
    this.noise.dispose();
    this.renderer.dispose();
  }

  /** No time for bakes. */
  private hurry(sort: Sort): boolean {
    return this.software && sort === "quick";
  }

  /** Pictures are drawn into the lower left corner of a canvas that is as large as the largest of their sort. */
  private begin(size: Size, sort: Sort): void {
    const quick = sort === "quick", most = quick ? this.quickMost : this.stillMost;
    most.width = Math.max(most.width, size.width);
    most.height = Math.max(most.height, size.height);
    if (this.canvas.width !== most.width || this.canvas.height !== most.height) {
      this.renderer.setSize(most.width, most.height, false);
    }
    this.renderer.setViewport(0, 0, size.width, size.height);
    this.renderer.setScissor(0, 0, size.width, size.height);
    this.renderer.setScissorTest(true);
  }
}
