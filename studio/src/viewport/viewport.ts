// The two views of a terrain: the map and the 3D view, of one height field and through one renderer. Draws when
// something has changed, and not at all otherwise.
import { computed, effect, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { registerActions } from "../actions/registry";
import type { ValueEvent } from "../api/types";
import { remembered } from "../document/remember";
import type { Shown, Studio } from "../document/studio";
import { followContent, type Content } from "./content";
import { finerOf, heightAt } from "./detail_ground";
import { DetailKeeper, mostDetailCells } from "./detail_keeper";
import { sourceOf } from "./detail_window";
import { Follower, mostCells } from "./follower";
import { Gestures } from "./gestures";
import { HeightField, sameRectangle } from "./heights";
import { legendElement } from "./legend";
import { labelAt, legendOf } from "./ground_overlay";
import { MapView } from "./map_view";
import { defaultOptions, readTaste, suggestedExaggeration, tasteOf, type ViewOptions } from "./options";
import { OverlayKeeper } from "./overlay_keeper";
import { PenStrokes } from "./pen_strokes";
import { PictureRenderer } from "./picture_renderer";
import { ProfileBox } from "./profile_box";
import type { GroundOverlay, GroundPointer, OverlayShape, PenTarget, Raster } from "./types";
import type { Things } from "./things";
import { viewActions } from "./view_actions";
import { mountControls } from "./view_controls";
import { WorldView } from "./world_view";

export interface ViewportStats {
  /** Mean time that a picture takes while something moves. */
  frame_ms: number;
  triangles: number;
  calls: number;
  /** Drawn by the processor. */
  software: boolean;
  /** From the arrival of the last raster until it was drawn. */
  upload_ms: number;
}

const taste = remembered("ground", tasteOf(defaultOptions), readTaste);
const restAfter_ms = 160;
const otherAfter_ms = 250;
const awaited_ms = 600;

type View = MapView | WorldView;

/** What a picture shows that is not yet on the page. */
interface Untold {
  view: View;
  field: HeightField;
  revision: number;
  detail_m: number | null;
  overlay_m: number | null;
}

export class Viewport {
  /** What is under the pointer, in either view. */
  readonly pointer: Signal<GroundPointer | null> = signal(null);
  /** Region under the pointer, where labels are laid over the ground. */
  readonly label: ReadonlySignal<string | null> = computed(() => labelAt(this.activeOverlay, this.pointer.value));
  /** Metres a pixel of the map. */
  readonly scale: Signal<number> = signal(1);
  readonly options: Signal<ViewOptions> = signal({ ...defaultOptions, ...taste.peek() });
  /** Key of the result that is drawn, and whether it is a coarse one. */
  readonly drawn: Signal<{ key: string; coarse: boolean } | null> = signal(null);
  readonly map: MapView;
  readonly world: WorldView;

  private readonly renderer: PictureRenderer;
  private readonly gestures: Gestures[] = [];
  private readonly followers: Follower[] = [];
  /** Of the map and of the 3D view. */
  private readonly details: DetailKeeper[];
  /** The same of what is laid over the ground. */
  private readonly overlays: OverlayKeeper[];
  private readonly stops: (() => void)[] = [];
  private field: HeightField | null = null;
  private readonly strokes = new PenStrokes(
    this.pointer, () => this.restTimer === 0 && this.seekDetail(), () => this.showCursor(),
  );
  private overlay: GroundOverlay = { overlay: "none" };
  private shownOverlay: GroundOverlay = { overlay: "none" };
  private things: Things | null = null;
  private contentShapes: readonly OverlayShape[] = [];
  private legend: HTMLElement | null = null;
  private shapes: readonly OverlayShape[] = [];
  /** Place of the profile that is pointed at. */
  private profiled: readonly [number, number] | null = null;
  private readonly profile: ProfileBox;
  /** The view that the pointer was in last. */
  private ahead: View;
  private readonly drawnQuickly = new Set<View>();
  private readonly untold: Untold[] = [];
  /** Nothing that is wanted is still being computed, and no edit on its way. */
  private readonly computed: () => boolean;
  private request = 0;
  private restTimer = 0;
  private upload_ms = 0;
  /** When the last result was there; 0 in the first once it is seen. */
  private arrived = 0;
  private came = 0;
  /** Of the document, that the last result is of. */
  private revision = 0;
  private readonly isOvertaken: () => boolean;
  /** A picture was not drawn since a newer result is about to come. */
  private waited = false;

  constructor(mapElement: HTMLElement, worldElement: HTMLElement, studio: Studio) {
    this.isOvertaken = () => {
      const shown = studio.shown.peek().terrain, value = shown === null ? undefined : studio.values.peek().get(shown);
      return value !== undefined && studio.overtaken(value.key === this.field?.key ? value.revision : 0);
    };
    this.computed = () => studio.engine.peek().settled && !studio.busy.peek();
    this.renderer = new PictureRenderer(() => this.restore());
    const { software } = this.renderer;
    this.map = new MapView(mapElement, software, () => this.moved(this.map), (pixel_m) => (this.scale.value = pixel_m));
    this.world = new WorldView(worldElement, software, () => this.moved(this.world), () => this.options.peek());
    this.ahead = this.map;
    for (const view of [this.map, this.world]) {
      const strokes = this.strokes.over((event) => {
        this.ahead = view;
        return view.under(event);
      });
      this.gestures.push(new Gestures(view.surface.element, view.mover, strokes, () => this.options.peek().navigation));
    }
    this.details = (["map", "world"] as const).map((name) =>
      new DetailKeeper(studio.api, this[name], mostDetailCells(name, software), () => this.detailCame(this[name])));
    this.overlays = [this.map, this.world].map((view) => new OverlayKeeper(studio.api, view, () => this.dirty(view)));
    const bigger = (): HTMLElement =>
      this.map.surface.area >= this.world.surface.area ? mapElement : worldElement;
    this.profile = new ProfileBox(bigger, (x, y) => this.heightAt(x, y), (place) => {
      this.profiled = place;
      this.ink();
    });
    const terrain = (raster: Raster | null, value: ValueEvent | null): void => this.terrain(raster, value);
    const overlay = (raster: Raster | null, value: ValueEvent | null): void => this.overlaid(raster, value);
    this.followers.push(
      new Follower(studio, (shown: Shown) => shown.terrain, terrain, mostCells(software)),
      new Follower(studio, (shown: Shown) => shown.overlay, overlay),
    );
    this.stops.push(
      followContent(studio, (content) => this.contentCame(content)), registerActions(viewActions(this)),
      mountControls(this, worldElement),
    );
    const themes = new MutationObserver(() => {
      this.map.inkStale = true;
      this.dirty(this.map);
    });
    themes.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
    this.stops.push(() => themes.disconnect());
    this.stops.push(effect(() => {
      if (studio.engine.value.settled && !studio.busy.value && this.restTimer === 0) this.seekDetail();
    }));
    this.stops.push(effect(() => {  // another revision may have the same result
      studio.values.value;
      if (this.waited) this.wake();
    }));
    let before = this.options.peek();
    this.stops.push(effect(() => {
      const now = this.options.value;
      const relit = now.sun !== before.sun || now.water !== before.water || now.exaggeration !== before.exaggeration;
      if (now.exaggeration !== before.exaggeration) this.world.rescale(now.exaggeration / before.exaggeration);
      if (now.climate !== before.climate) this.renderer.recolour();
      if (relit || now.ground !== before.ground) this.renderer.relight(relit);
      before = now;
      taste.value = tasteOf(now);
      this.dirty(this.map, this.world);
    }));
  }

  setPen(target: PenTarget | null): void {
    if (target === this.strokes.pen) return;
    for (const gestures of this.gestures) gestures.cancel();
    this.strokes.pen = target;
    this.showCursor();
  }

  /** What the pen is to look like may depend on where it is. */
  private showCursor(): void {
    const cursor = this.strokes.pen?.cursor ?? "default";
    for (const { surface } of [this.map, this.world]) {
      if (surface.element.style.cursor !== cursor) surface.element.style.cursor = cursor;
    }
  }

  setOverlayShapes(shapes: readonly OverlayShape[]): void {
    this.shapes = shapes;
    this.ink();
  }

  /** Shows the ground along a line from the side; null: not any more. */
  showProfile(line: readonly (readonly [number, number])[] | null): void {
    this.profile.show(line);
  }

  /** Laid over the ground instead of what `studio.shown` says; "none": that again. */
  setGroundOverlay(overlay: GroundOverlay): void {
    this.overlay = overlay;
    this.applyOverlay();
  }

  frameAll(): void {
    if (this.field === null) return;
    this.map.frame(this.field);
    this.world.frame(this.field);
    this.moved(this.map, this.world);
  }

  /** Brings a rectangle of the ground into both views: of the shapes that tools show, without one. */
  frameSelection(rectangle?: { west: number; east: number; south: number; north: number }): void {
    if (this.field === null) return;
    const chosen = rectangle ?? this.map.shapesRectangle();
    if (chosen === null) return this.frameAll();
    this.map.frameRectangle(chosen);
    this.world.frameRectangle(this.field, chosen);
    this.moved(this.map, this.world);
  }

  stats(): ViewportStats {
    const { triangles, calls, software } = this.renderer;
    return { frame_ms: this.renderer.pace.quickMs, triangles, calls, software, upload_ms: this.upload_ms };
  }

  /** PNG of a view as it is seen, with what is drawn over it. */
  async screenshot(view: "map" | "world" = "world"): Promise<Blob> {
    const { surface } = view === "map" ? this.map : this.world;
    const { width, height } = surface.pixels;
    const canvas = new OffscreenCanvas(width, height), to = canvas.getContext("2d")!;
    to.drawImage(surface.canvas, 0, 0, width, height);
    to.drawImage(surface.ink.canvas, 0, 0, width, height);
    return canvas.convertToBlob({ type: "image/png" });
  }

  /** Resolves once both views show the present state, at rest. */
  async settled(): Promise<void> {
    while (this.request !== 0 || this.restTimer !== 0 || [...this.details, ...this.overlays].some(({ busy }) => busy)) {
      await new Promise((done) => setTimeout(done, 20));
    }
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    clearTimeout(this.restTimer);
    for (const stop of this.stops) stop();
    const many = [...this.followers, ...this.details, ...this.overlays, ...this.gestures];
    for (const part of [this.profile, ...many, this.map, this.world, this.renderer]) {
      part.dispose();
    }
    this.legend?.remove();
  }

  private terrain(raster: Raster | null, value: ValueEvent | null): void {
    if (raster === null) return;
    this.arrived = this.came = performance.now();
    this.revision = value?.revision ?? 0;
    const before = this.field, field = HeightField.of(raster);
    this.field = field;
    this.map.field = this.world.field = field;
    const source = sourceOf(raster, value?.frame ?? raster.frame);
    this.map.cell_m = this.world.cell_m = source.frame.cell_m;
    for (const detail of this.details) detail.follow(field, source);
    this.drawn.value = { key: raster.key, coarse: raster.coarse };
    if (before === null && this.things !== null) this.renderer.world.setThings(this.things, field);
    if (before === null || !sameRectangle(before, field)) this.begin(field);
    this.profile.update();
    // A quick picture at once, since results may come in a row; a good one when they rest.
    this.moved(this.map, this.world);
    if (before !== null && !raster.coarse) this.drawNow();
  }

  private detailCame(view: View): void {
    view.inkStale = true;
    this.profile.update();
    this.dirty(view);
    for (const keeper of this.overlays) void keeper.seek();
  }

  /** As finely as either view knows it. */
  private heightAt(x: number, y: number): number | null {
    if (this.field === null) return null;
    return heightAt(this.field, finerOf([this.map.detail, this.world.detail], x, y), x, y);
  }

  /** Another terrain: all of it is shown, as high as shows its forms. */
  private begin(field: HeightField): void {
    this.options.value = { ...this.options.peek(), exaggeration: suggestedExaggeration(field.typicalSlope) };
    this.frameAll();
  }

  private overlaid(raster: Raster | null, value: ValueEvent | null): void {
    const kind = value?.kind ?? "";
    this.map.current = kind === "current" ? raster : null;
    this.map.inkStale = true;
    const none = raster === null || (kind !== "labels" && kind !== "field");
    this.shownOverlay = none
      ? { overlay: "none" }
      : { overlay: kind === "labels" ? "labels" : "field", raster: raster! };
    for (const keeper of this.overlays) keeper.follow(none ? null : raster, value?.frame ?? null);
    this.applyOverlay();
  }

  private get activeOverlay(): GroundOverlay {
    return this.overlay.overlay === "none" ? this.shownOverlay : this.overlay;
  }

  /** What is laid over the ground is no raster: things that stand on it, or shapes. */
  private contentCame({ things, shapes }: Content): void {
    this.things = things;
    if (this.field !== null) this.renderer.world.setThings(things, this.field);
    this.contentShapes = shapes;
    this.ink();
    this.dirty(this.map, this.world);
  }

  private applyOverlay(): void {
    const overlay = this.activeOverlay;
    this.renderer.relight(false);
    this.renderer.updateOverlay(overlay, this.field);
    this.legend?.remove();
    const legend = legendOf(overlay);
    this.legend = legend === null ? null : legendElement(legend);
    if (this.legend !== null) this.map.surface.element.append(this.legend);
    this.dirty(this.map, this.world);
  }

  private ink(): void {
    const shapes: readonly OverlayShape[] = this.profiled === null
      ? this.shapes
      : [...this.shapes, { shape: "dot", at: this.profiled, role: "selected" }];
    this.map.shapes = this.world.shapes = shapes;
    this.map.content = this.world.content = this.contentShapes;
    this.map.inkStale = this.world.inkStale = true;
    this.wake();
  }

  private restore(): void {
    this.renderer.forget();
    this.dirty(this.map, this.world);
  }

  /** Neither while a stroke is drawn nor while results of it come in a row: the next one would overtake it. */
  private seekDetail(): void {
    if (!this.strokes.drawing && this.computed()) for (const detail of this.details) detail.seek();
  }

  /** Views move: quick pictures now, good ones when they rest. */
  private moved(...views: View[]): void {
    for (const view of views) view.inkStale = true;
    this.restSoon();
    this.dirty(...views);
  }

  /** At rest once nothing has moved for longer than slow pictures take, and no button is held that moves a view. */
  private restSoon(): void {
    clearTimeout(this.restTimer);
    this.restTimer = window.setTimeout(() => {
      if (this.gestures.some((gestures) => gestures.navigating) || this.fullFollows(1500) || this.overtaken()) {
        this.wake();
        return this.restSoon();
      }
      this.restTimer = 0;
      this.dirty(...this.drawnQuickly);
      this.drawnQuickly.clear();
      this.seekDetail();
    }, Math.max(restAfter_ms, Math.min(1200, 2 * this.renderer.pace.quickMs)));
  }

  /** A coarse result was there within so many milliseconds: the processor is left to what computes the full one. */
  private fullFollows(within_ms: number): boolean {
    return this.renderer.software && this.field?.coarse === true && performance.now() - this.came < within_ms;
  }

  /** What is there is of a gesture that has ended, and what it ended with is about to come. */
  private overtaken(): boolean {
    const soon = performance.now() - this.came < awaited_ms;
    return this.renderer.software && soon && this.isOvertaken();
  }

  private dirty(...views: View[]): void {
    for (const { surface } of views) surface.samples = 0;
    this.wake();
  }

  private wake(): void {
    if (this.request === 0) this.request = requestAnimationFrame(() => this.frame());
  }

  /** On the page, for who measures it: which result is seen in the views that were drawn last. */
  private tellDrawn(): void {
    const told = this.untold.splice(0);
    for (const { view: { surface }, field, revision, detail_m, overlay_m } of told) {
      for (const [name, cell_m] of [["detailCell", detail_m], ["overlayCell", overlay_m]] as const) {
        if (cell_m === null) delete surface.element.dataset[name];
        else surface.element.dataset[name] = String(cell_m);
      }
      surface.element.dataset["revision"] = String(revision);
      surface.element.dataset["coarse"] = String(field.coarse);
      surface.element.dataset["key"] = field.key;
    }
    if (this.arrived > 0 && told.some(({ field }) => field === this.field)) {
      this.upload_ms = performance.now() - this.arrived;
      this.arrived = 0;
    }
  }

  /** Without waiting for the next frame, which shows it. */
  private drawNow(): void {
    if (!this.renderer.ready()) return;
    cancelAnimationFrame(this.request);
    this.frame();
  }

  private frame(): void {
    this.request = 0;
    const moving = this.restTimer !== 0;
    if (moving && !this.renderer.software) this.seekDetail();
    for (const view of [this.map, this.world]) if (view.inkStale) view.drawInk(this.options.peek(), moving);
    const field = this.field;
    if (field === null) return;
    if (!this.renderer.ready()) return this.wake();
    this.tellDrawn();
    queueMicrotask(() => {  // whoever watches what is seen is told before the next picture takes its time
      if (this.draw(field, moving)) this.wake();
    });
  }

  /** Whether there is more to draw. */
  private draw(field: HeightField, moving: boolean): boolean {
    this.waited = this.overtaken();
    if (this.waited) return false;
    const { renderer } = this, { pace } = renderer, options = this.options.peek();
    const shown = this.inTurn(), alone = this.fullFollows(otherAfter_ms) && shown.includes(this.ahead);
    const inTurn = alone ? [this.ahead] : shown;
    const stale = inTurn.filter((view) => view.surface.samples < this.wanted(view, moving));
    if (stale.length === 0) return false;
    // The processor draws one view after the other, so that the first one is seen soon.
    const now = renderer.software ? stale.slice(0, 1) : stale;
    renderer.beginFrame();
    renderer.hold(field, moving);
    const fine = !moving && now.includes(this.world) && pace.mayBeFine();
    const sort = moving ? "quick" : fine ? "fine" : "plain";
    for (const view of now) {
      const detail = view.draw(renderer, field, options, this.activeOverlay, moving ? pace.quickSize : 1, sort);
      if (moving) this.drawnQuickly.add(view);
      const detail_m = detail?.cell_m ?? null, overlay_m = renderer.overlayCell_m;
      this.untold.push({ view, field, revision: this.revision, detail_m, overlay_m });
    }
    renderer.endFrame(sort);
    return true;
  }

  /** What is shown: that of the pointer first, the other one before it is drawn again. */
  private inTurn(): View[] {
    const views = this.ahead === this.map ? [this.map, this.world] : [this.world, this.map];
    return views.filter(({ surface }) => surface.shown).sort((a, b) => a.surface.samples - b.surface.samples);
  }

  private wanted(view: View, moving: boolean): number {
    return moving ? 1 : this.renderer.pace.samples(view.samples());
  }
}
