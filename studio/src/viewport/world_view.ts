// The 3D view: where its eye is, what ground is under a pixel, and what is drawn over it.
import { ContentInk } from "./content_ink";
import type { Projector } from "./drape";
import { dryAt, heightAt, hiddenBehind, pickGround, type DetailGround } from "./detail_ground";
import { windowOfWorld, type Seen, type Source, type Window } from "./detail_window";
import type { Under } from "./ground_pointer";
import type { HeightField } from "./heights";
import type { Rectangle } from "./map_camera";
import type { ViewOptions } from "./options";
import type { OverlayWindow } from "./overlay_keeper";
import type { PictureRenderer, Sort } from "./picture_renderer";
import { drawShapes } from "./shapes_ink";
import type { GroundOverlay, OverlayShape } from "./types";
import { ViewSurface } from "./view_surface";
import {
  add, confined, direction, fieldOfView, frame, project, type Box, type Eye, type Lens, type Vector,
} from "./world_camera";
import { WorldMover } from "./world_mover";

/** Where the pictures that are averaged look through a pixel. */
const jitters: readonly (readonly [number, number])[] = [
  [0, 0], [0.375, 0.125], [-0.375, -0.125], [0.125, -0.375], [-0.125, 0.375], [0.3, 0.45], [-0.3, -0.45], [0.45, -0.3],
];

/** Where one looks to see what ground is near. */
const sightColumns = 12, sightRows = 12;

export class WorldView {
  readonly surface: ViewSurface;
  readonly mover: WorldMover;
  shapes: readonly OverlayShape[] = [];
  /** Shapes that a step makes: many, so they rest while the view moves. */
  content: readonly OverlayShape[] = [];
  inkStale = true;
  field: HeightField | null = null;
  /** Of the cells that the terrain is computed in. */
  cell_m = 1;
  overlayDetail: OverlayWindow | null = null;
  private known: DetailGround | null = null;
  private eye: Eye = { at: [0, -1000, 1000], azimuth: 0, pitch: -0.7 };
  private framed = true;
  private readonly contentInk = new ContentInk();

  constructor(
    element: HTMLElement, software: boolean, private readonly changed: () => void,
    private readonly options: () => ViewOptions,
  ) {
    this.surface = new ViewSurface(element, "3D view of the terrain", software, () => {
      if (this.framed && this.field !== null) this.frame(this.field);
      this.changed();
    });
    this.mover = new WorldMover({
      eye: () => this.eye,
      lens: () => this.lens(),
      ground: (x, y) => this.ground(x, y),
      reach: () => this.reach(),
      nearest: () => 3 * this.cell_m,
      set: (eye) => {
        this.framed = false;
        this.eye = this.kept(eye);
        this.inkStale = true;
        this.changed();
      },
    });
  }

  /** Pictures that are averaged at rest. */
  samples(): number {
    return jitters.length;
  }

  /** Present eye, for tests and for coming back to it. */
  get place(): Eye {
    return this.eye;
  }
  set place(eye: Eye) {
    this.framed = false;
    this.eye = this.kept(eye);
    this.inkStale = true;
    this.changed();
  }

  frame(field: HeightField): void {
    const first = this.field === null || this.framed;
    this.field = field;
    this.eye = frame(
      this.box(field, this.options().water ? field.dryRectangle : field.rectangle), this.lens(),
      first ? 0.45 : this.eye.azimuth, first ? this.firstPitch() : Math.min(-0.25, this.eye.pitch),
    );
    this.framed = true;
    this.inkStale = true;
  }

  /** Tall pictures look down more steeply, so that the ground fills them. */
  private firstPitch(): number {
    const { width, height } = this.lens();
    return -0.46 - 0.55 * Math.min(0.7, Math.max(0, 1.35 - width / height));
  }

  frameRectangle(field: HeightField, r: Rectangle): void {
    this.framed = false;
    const whole = this.box(field);
    const box: Box = {
      low: [r.west, r.south, whole.low[2]], high: [r.east, r.north, 0.5 * (whole.low[2] + whole.high[2])],
    };
    this.eye = this.kept(frame(box, this.lens(), this.eye.azimuth, Math.min(-0.35, this.eye.pitch)));
    this.inkStale = true;
  }

  /** The exaggeration is another: the eye keeps over the same ground. */
  rescale(factor: number): void {
    const [x, y, z] = this.eye.at;
    if (this.framed && this.field !== null) this.frame(this.field);
    else this.eye = this.kept({ ...this.eye, at: [x, y, Math.max(z, z * Math.min(factor, 1.5))] });
    this.inkStale = true;
  }

  under(event: MouseEvent): Under | null {
    if (this.field === null) return null;
    const box = this.surface.element.getBoundingClientRect();
    const place = this.ground(event.clientX - box.left, event.clientY - box.top);
    if (place === null) return null;
    const [x, y] = place;
    return { x, y, height: heightAt(this.field, this.known, x, y), pixel_m: this.pixelSize(place) };
  }

  get detail(): DetailGround | null {
    return this.known;
  }
  /** The eye keeps over the ground, that may be higher now. */
  set detail(detail: DetailGround | null) {
    this.known = detail;
    const kept = this.kept(this.eye);
    if (kept.at.some((x, i) => x !== this.eye.at[i])) this.place = kept;
  }

  /** What should be known finely, of at most so many cells a side. */
  window(source: Source, most: number): Window | null {
    const seen: Seen[] = [], { width, height, ratio } = this.surface;
    for (let row = 0; row < sightRows; ++row) {
      for (let column = 0; column < sightColumns; ++column) {
        const place = this.ground((width * (column + 0.5)) / sightColumns, (height * (row + 0.5)) / sightRows);
        if (place !== null) seen.push({ x: place[0], y: place[1], pixel_m: this.pixelSize(place) / ratio });
      }
    }
    return windowOfWorld(source, seen, most, this.known?.window ?? null);
  }

  draw(
    renderer: PictureRenderer, field: HeightField, options: ViewOptions, overlay: GroundOverlay, size: number,
    sort: Sort,
  ): DetailGround | null {
    const { width, height } = this.surface.pixels;
    const lens = { width: Math.ceil(width * size), height: Math.ceil(height * size), fov: fieldOfView };
    const known = { ground: this.known, over: this.overlayDetail }, jitter = jitters[this.surface.samples]!;
    const drawn = renderer.drawWorld(field, known, options, overlay, this.eye, lens, jitter, sort);
    renderer.show(this.surface, lens, sort);
    return drawn;
  }

  drawInk(options: ViewOptions, moving: boolean): void {
    this.inkStale = moving && this.content.length > 0;
    if (!this.surface.shown) return;
    const ink = this.surface.beginInk(), field = this.field;
    if (field === null || this.shapes.length + this.content.length === 0) return;
    const lens = this.lens(), raise = options.exaggeration;
    const above = 0.6 * (this.known?.cell_m ?? field.frame.cell_m);
    const seen: Vector = [this.eye.at[0], this.eye.at[1], this.eye.at[2] / raise];
    const height = (x: number, y: number): number => this.surfaceHeight(x, y);
    const by: Projector = {
      project: (x, y) => {
        const at = project(this.eye, lens, [x, y, raise * height(x, y)]);
        return at === null ? null : [at[0], at[1]];
      },
      pixelSize: (x, y) => this.pixelSize([x, y, raise * height(x, y)]),
      hidden: (x, y) => hiddenBehind(field, this.known, [x, y, height(x, y) + above], seen),
      flat: false,
    };
    const { west, east, south, north } = field.rectangle;
    const inside = (x: number, y: number): boolean => x >= west && x <= east && y >= south && y <= north;
    const onGround: Projector = { ...by, project: (x, y) => (inside(x, y) ? by.project(x, y) : null) };
    if (!moving) this.contentInk.draw(ink, this.content, onGround, [this.eye, field, raise, options.water]);
    drawShapes(ink, this.shapes, by);
  }

  dispose(): void {
    this.surface.dispose();
  }

  private lens(): Lens {
    return { width: Math.max(1, this.surface.width), height: Math.max(1, this.surface.height), fov: fieldOfView };
  }

  /** Of the ground or of the water over it, without exaggeration. */
  private surfaceHeight(x: number, y: number): number {
    const known = this.field === null ? null : heightAt(this.field, this.known, x, y);
    const height = known ?? (this.field?.inSea === true ? 0 : this.field?.min ?? 0);
    const flooded = this.options().water && height < 0 && !(this.field !== null && dryAt(this.field, this.known, x, y));
    return flooded ? 0 : height;
  }

  private ground(px: number, py: number): Vector | null {
    const field = this.field;
    if (field === null) return null;
    const raise = this.options().exaggeration, ray = direction(this.eye, this.lens(), px, py);
    const from: Vector = [this.eye.at[0], this.eye.at[1], this.eye.at[2] / raise];
    const along: Vector = [ray[0], ray[1], ray[2] / raise];
    const t = pickGround(field, this.known, { from, to: add(from, along) }, this.options().water ? 0 : -Infinity);
    if (t !== null) return add(this.eye.at, ray, t);
    // Beside the terrain: its sea, or the level of its foot.
    const level = field.inSea ? 0 : raise * field.min;
    const down = (level - this.eye.at[2]) / ray[2];
    const near = down > 0 && down < 8 * Math.max(field.width_m, field.height_m);
    return ray[2] < -1e-3 && near ? add(this.eye.at, ray, down) : null;
  }

  private pixelSize(place: Vector): number {
    const at = project(this.eye, this.lens(), place);
    return ((at?.[2] ?? 1) * 2 * Math.tan(fieldOfView / 2)) / Math.max(1, this.surface.height);
  }

  /** How far the ground before the eye is, roughly. */
  private reach(): number {
    const field = this.field;
    if (field === null) return 1000;
    const { at } = this.eye, ground = this.options().exaggeration * this.surfaceHeight(at[0], at[1]);
    return Math.min(
      2 * Math.max(field.width_m, field.height_m), Math.max(20 * this.cell_m, 2 * Math.abs(at[2] - ground)),
    );
  }

  private box(field: HeightField, r: Rectangle = field.rectangle): Box {
    const raise = this.options().exaggeration;
    const low = this.options().water ? Math.max(field.lowestDry, field.min) : field.min;
    return {
      low: [r.west, r.south, raise * low], high: [r.east, r.north, raise * (low + 0.4 * Math.max(0, field.max - low))],
    };
  }

  private kept(eye: Eye): Eye {
    const field = this.field;
    if (field === null) return eye;
    const ground = (x: number, y: number): number => this.options().exaggeration * this.surfaceHeight(x, y);
    return confined(eye, this.box(field), ground, Math.max(1.5, 1.2 * this.cell_m));
  }
}
