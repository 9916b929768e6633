// The map: what part of the ground it shows and what is drawn over it.
import { ContentInk } from "./content_ink";
import { drawCurrent } from "./current_ink";
import type { Projector } from "./drape";
import { heightAt, type DetailGround } from "./detail_ground";
import { windowOfMap, type Source, type Window } from "./detail_window";
import type { Under } from "./ground_pointer";
import type { HeightField } from "./heights";
import { fitted, toGround, toScreen, visible, type MapEye, type Rectangle } from "./map_camera";
import { drawFurniture } from "./map_furniture";
import { MapMover } from "./map_mover";
import type { ViewOptions } from "./options";
import type { OverlayWindow } from "./overlay_keeper";
import type { PictureRenderer, Sort } from "./picture_renderer";
import { drawShapes } from "./shapes_ink";
import type { GroundOverlay, OverlayShape, Raster } from "./types";
import { ViewSurface } from "./view_surface";

export class MapView {
  readonly surface: ViewSurface;
  readonly mover: MapMover;
  shapes: readonly OverlayShape[] = [];
  /** Shapes that a step makes, and currents. */
  content: readonly OverlayShape[] = [];
  current: Raster | null = null;
  inkStale = true;
  field: HeightField | null = null;
  detail: DetailGround | null = null;
  overlayDetail: OverlayWindow | null = null;
  /** Of the cells that the terrain is computed in. */
  cell_m = 1;
  private eye: MapEye = { x: 0, y: 0, pixel_m: 1 };
  private framed = true;
  private readonly contentInk = new ContentInk();

  constructor(
    element: HTMLElement, software: boolean, private readonly changed: () => void,
    private readonly scaled: (pixel_m: number) => void,
  ) {
    this.surface = new ViewSurface(element, "Map of the terrain", software, () => {
      if (this.framed && this.field !== null) this.frame(this.field);
      this.changed();
    });
    this.mover = new MapMover({
      eye: () => this.eye,
      size: () => this.surface,
      limits: () => this.limits(),
      set: (eye) => {
        this.framed = false;
        this.set(eye);
        this.changed();
      },
    });
  }

  frame(field: HeightField): void {
    this.field = field;
    this.frameRectangle(field.rectangle);
    this.framed = true;
  }

  frameRectangle(rectangle: Rectangle): void {
    this.framed = false;
    this.set(fitted(rectangle, this.surface, this.surface.width > 420 ? 28 : 10));
  }

  /** Pictures that are averaged at rest: the shader smooths its own edges. */
  samples(): number {
    return 1;
  }

  /** Around the shapes that tools show; null without any. */
  shapesRectangle(): Rectangle | null {
    let west = Infinity, east = -Infinity, south = Infinity, north = -Infinity;
    const take = (x: number, y: number, r = 0): void => {
      west = Math.min(west, x - r);
      east = Math.max(east, x + r);
      south = Math.min(south, y - r);
      north = Math.max(north, y + r);
    };
    for (const shape of this.shapes.length > 0 ? this.shapes : this.content) {
      if (shape.shape === "line" || shape.shape === "area") for (const [x, y] of shape.points) take(x, y);
      else if (shape.shape === "dot") take(shape.at[0], shape.at[1]);
    }
    if (west > east) return null;
    const least = 60 * this.cell_m;
    const grow = Math.max(
      0.1 * Math.max(east - west, north - south), 0.5 * (least - Math.max(east - west, north - south)),
    );
    return { west: west - grow, east: east + grow, south: south - grow, north: north + grow };
  }

  under(event: MouseEvent): Under | null {
    if (this.field === null) return null;
    const box = this.surface.element.getBoundingClientRect();
    const [x, y] = toGround(this.eye, this.surface, event.clientX - box.left, event.clientY - box.top);
    return { x, y, height: heightAt(this.field, this.detail, x, y), pixel_m: this.eye.pixel_m };
  }

  /** What should be known finely, of at most so many cells a side. */
  window(source: Source, most: number): Window | null {
    const pixel_m = this.eye.pixel_m / this.surface.ratio;
    return windowOfMap(source, visible(this.eye, this.surface), pixel_m, most, this.detail?.window ?? null);
  }

  draw(
    renderer: PictureRenderer, field: HeightField, options: ViewOptions, overlay: GroundOverlay, size: number,
    sort: Sort,
  ): DetailGround | null {
    const { width, height } = this.surface.pixels;
    const pixels = { width: Math.ceil(width * size), height: Math.ceil(height * size) };
    const known = { ground: this.detail, over: this.overlayDetail }, paper = paperOf(this.surface.element);
    const drawn = renderer.drawMap(field, known, options, overlay, this.eye, this.surface, pixels, paper, sort);
    renderer.show(this.surface, pixels, sort);
    return drawn;
  }

  drawInk(options: ViewOptions): void {
    this.inkStale = false;
    if (!this.surface.shown) return;
    const ink = this.surface.beginInk();
    if (this.field === null) return;
    drawFurniture(ink, this.eye, this.surface, {
      grid: options.grid,
      light: paperOf(this.surface.element)[1] > 0.3,
    });
    const by: Projector = {
      project: (x, y) => toScreen(this.eye, this.surface, x, y),
      pixelSize: () => this.eye.pixel_m,
      hidden: () => false,
      flat: true,
    };
    if (this.current !== null) drawCurrent(ink, this.current, this.eye, this.surface);
    this.drawContent(ink, this.field.rectangle, by);
    drawShapes(ink, this.shapes, by);
  }

  /** Not beyond the ground. */
  private drawContent(ink: CanvasRenderingContext2D, ground: Rectangle, by: Projector): void {
    const [left, top] = by.project(ground.west, ground.north)!;
    const [right, bottom] = by.project(ground.east, ground.south)!;
    const state = [this.eye, ground.west, ground.north, ground.east, ground.south];
    this.contentInk.draw(ink, this.content, by, state, [left, top, right, bottom]);
  }

  dispose(): void {
    this.surface.dispose();
  }

  private limits(): { least: number; most: number } {
    if (this.field === null) return { least: 1e-3, most: 1e6 };
    const size = Math.max(this.field.width_m, this.field.height_m);
    const pixels = Math.max(200, Math.min(this.surface.width, this.surface.height));
    return { least: this.cell_m / 40, most: (8 * size) / pixels };
  }

  private set(eye: MapEye): void {
    this.eye = eye;
    this.inkStale = true;
    this.scaled(eye.pixel_m);
  }
}

/** Colour of the element around the ground, in linear light. */
function paperOf(element: HTMLElement): [number, number, number] {
  const colour = getComputedStyle(element).backgroundColor;
  const parts = /(\d+(?:\.\d+)?)[ ,]+(\d+(?:\.\d+)?)[ ,]+(\d+(?:\.\d+)?)/.exec(colour);
  const linear = (text: string | undefined): number => {
    const c = Number(text ?? 22) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  };
  return [linear(parts?.[1]), linear(parts?.[2]), linear(parts?.[3])];
}
