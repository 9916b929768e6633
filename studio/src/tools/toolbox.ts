// The tools of a studio: what is offered for the selected step, which one is active, and what of it the views are told.
import { computed, effect, signal, untracked, type ReadonlySignal } from "@preact/signals";
import type { Json } from "../api/types";
import type { Studio } from "../document/studio";
import type { GroundPointer, OverlayShape, PenTarget } from "../viewport/types";
import {
  activeTool, chosenMembers, draft, ownReach, readout, selectedPoints, selection,
} from "./active";
import { bridge } from "./bridge";
import type { Desk, Pen, PenKey } from "./desk";
import { featuresOf, type Feature } from "./features";
import { Gesture } from "./gesture";
import { lookOf } from "./names";
import { kSelect, offerById, offersFor, type Offer, type Offers } from "./offers";
import { EraserPen } from "./pens/eraser_pen";
import { LinePen } from "./pens/line_pen";
import { MeasurePen } from "./pens/measure_pen";
import { PlacePen } from "./pens/place_pen";
import { PolarPen, outlinesOf } from "./pens/polar_pen";
import { RingPen } from "./pens/ring_pen";
import { SelectPen } from "./pens/select_pen";
import { VectorPen } from "./pens/vector_pen";
import { classesFor, firstClass } from "./objects";
import { domainOf } from "./place";
import { featureShapes, outlineShapes } from "./shapes";
import { slotsOf, type Slot } from "./slots";
import type { Point } from "./geometry";

/** What a view lets the tools do. */
export interface PenViewport {
  setPen(pen: PenTarget | null): void;
  setOverlayShapes(shapes: readonly OverlayShape[]): void;
  /** Shows the ground along a line from the side; null: not any more. */
  showProfile?(line: readonly Point[] | null): void;
}

function penFor(desk: Desk): Pen {
  const { offer } = desk;
  if (offer.id === "edit:select") return new SelectPen(desk);
  if (offer.id === "edit:erase") return new EraserPen(desk);
  if (!offer.slot) return new MeasurePen(desk, offer.id === "measure:profile");
  switch (offer.slot.geometry) {
    case "line": return new LinePen(desk);
    case "ring": return new RingPen(desk);
    case "polar": return new PolarPen(desk);
    case "vector": return new VectorPen(desk);
    case "place": return new PlacePen(desk);
  }
}

/** Where the pen goes down the keys go too: a button or a field that had them lets them go. */
function takingFocus(pen: Pen): Pen {
  const down = pen.down.bind(pen);
  pen.down = (at) => {
    const focused = typeof document === "undefined" ? null : (document.activeElement as HTMLElement | null);
    if (focused?.closest?.("button, input, textarea, select, [data-number-field]")) focused.blur();
    down(at);
  };
  return pen;
}

export class ToolBox {
  readonly offers: ReadonlySignal<Offers>;
  readonly active: ReadonlySignal<Offer>;
  readonly features: ReadonlySignal<readonly Feature[]>;
  readonly shapes: ReadonlySignal<readonly OverlayShape[]>;
  /** A gesture is under way. */
  readonly busy = signal(false);
  private pen: Pen | null = null;
  private penOf = "";
  private goingTo: string | null | undefined;
  private readonly viewports = new Set<PenViewport>();
  private readonly stop: (() => void)[];

  constructor(readonly studio: Studio) {
    this.offers = computed(() => {
      const shown = studio.shown.value.terrain?.split(".")[0] ?? null;
      return offersFor(studio.document.value.recipe, studio.schema, studio.selected.value, shown);
    });
    this.active = computed(() => offerById(this.offers.value, activeTool.value) ?? kSelect);
    this.features = computed(() => this.readFeatures());
    this.shapes = computed(() => {
      // With a brush in the hand the ground is what one looks at: its strokes are seen when they are to be edited.
      const { id, slot } = this.active.value;
      const seen = slot?.brush ? this.features.value.filter((feature) => !feature.slot.brush) : this.features.value;
      const drawn = featureShapes(seen, selection.value, selectedPoints.value, id === kSelect.id);
      return [...this.outlines(), ...drawn, ...draft.value];
    });
    this.stop = [
      effect(() => this.takePen(this.active.value, studio.selected.value, this.busy.value)),
      effect(() => {
        const shapes = this.shapes.value;
        for (const viewport of this.viewports) viewport.setOverlayShapes(shapes);
      }),
      effect(() => this.forgetGone(this.features.value)),
      ...bridge(this),
    ];
  }

  private slots(): Slot[] {
    const id = this.studio.selected.value;
    const step = id === null ? undefined : this.studio.document.value.recipe.steps.find((one) => one.id === id);
    const operator = step && this.studio.operator(step.op);
    return operator ? slotsOf(operator) : [];
  }

  private readFeatures(): readonly Feature[] {
    const id = this.studio.selected.value;
    return id === null ? [] : featuresOf(this.studio.document.value.recipe, id, this.slots());
  }

  private outlines(): OverlayShape[] {
    const id = this.studio.selected.value;
    const { recipe } = this.studio.document.value;
    return this.slots()
      .filter((slot) => slot.geometry === "polar" && id !== null)
      .flatMap((slot) => {
        const { outlines, centre } = outlinesOf({ recipe: () => recipe }, id!, slot.parts[0]!.path);
        return outlineShapes(outlines, centre);
      });
  }

  /** What is not drawn any more is not selected any more; while a gesture runs, keys may come a moment later. */
  private forgetGone(features: readonly Feature[]): void {
    if (untracked(() => this.busy.value)) return;
    const keys = new Set(features.map((feature) => feature.key));
    const kept = [...untracked(() => selection.value)].filter((key) => keys.has(key));
    if (kept.length === untracked(() => selection.value.size)) return;
    selection.value = new Set(kept);
    selectedPoints.value = new Set();
  }

  private takePen(offer: Offer, step: string | null, busy: boolean): void {
    if (busy) {  // the tool of a running gesture stays until its end, which is now if another step is selected
      const before = this.penOf.split(" ")[0];
      if ((step ?? "") !== before && step !== this.goingTo) untracked(() => this.pen?.leave?.());
      return;
    }
    this.goingTo = undefined;
    const name = `${step ?? ""} ${offer.id} ${offer.adds?.existing ?? ""}`;
    if (name === this.penOf) return;
    untracked(() => {
      this.pen?.leave?.();
      draft.value = [];
      readout.value = "";
      const stepChanged = this.penOf.split(" ")[0] !== (step ?? "");
      if (stepChanged) selectedPoints.value = new Set();
      this.penOf = name;
      this.pen = takingFocus(penFor(this.deskFor(offer)));
      for (const viewport of this.viewports) viewport.setPen(this.pen);
    });
  }

  private deskFor(offer: Offer): Desk {
    const { studio } = this;
    const recipe = () => studio.document.peek().recipe;
    const domain = () => domainOf(recipe());
    const own = studio.selected.peek();
    return {
      studio,
      offer,
      recipe,
      domain,
      step: () => own,
      features: () => this.features.peek(),
      fitting: (at: GroundPointer) => ({ pixel_m: at.pixel_m, cell_m: this.cell_m() }),
      begin: (what, name) => {
        this.busy.value = true;
        const step = offer.adds?.existing ?? offer.adds?.at ?? own;
        return new Gesture(studio, step === null ? what : `${step}: ${what}`, undefined, name);
      },
      goTo: (step) => {
        this.goingTo = step;
        studio.selected.value = step;
      },
      end: (then) => {
        if (then) activeTool.value = then;
        this.busy.value = false;
      },
      draw: (shapes) => (draft.value = shapes),
      say: (text) => (readout.value = text),
      select: (keys, points) => {
        selection.value = new Set(keys);
        selectedPoints.value = new Set(points ?? []);
      },
      selected: () => selection.peek(),
      selectedPoints: () => selectedPoints.peek(),
      members: (slot) => {
        const members = chosenMembers(slot, domain());
        const first = firstClass(untracked(() => classesFor(studio, own, slot)));
        return first === "" || slot.tool !== "add" ? members : { class: first, ...members };
      },
      reach: () => untracked(() => ownReach(offer.slot?.geometry, domain())),
      profile: (line) => {
        for (const viewport of this.viewports) viewport.showProfile?.(line);
      },
    };
  }

  private cell_m(): number {
    const { recipe } = this.studio.document.peek();
    const source = this.studio.shown.peek().terrain;
    const shown = source === null ? undefined : this.studio.values.peek().get(source)?.frame;
    const own = domainOf(recipe).cell_m;
    return shown ? Math.min(shown.cell_m, own) : own;
  }

  /** Takes a tool; one that draws into another step takes that step along. */
  take(id: string): void {
    const offer = offerById(this.offers.peek(), id);
    if (!offer || this.busy.peek()) return;
    const existing = offer.adds?.existing;
    if (existing && offer.slot) {
      this.studio.selected.value = existing;
      activeTool.value = `slot:${offer.slot.id}`;
    } else activeTool.value = id;
  }

  /** Hands a view the pen and the drawing until the returned function is called. */
  attach(viewport: PenViewport): () => void {
    this.viewports.add(viewport);
    viewport.setPen(this.pen);
    viewport.setOverlayShapes(this.shapes.peek());
    return () => {
      this.viewports.delete(viewport);
      viewport.setPen(null);
    };
  }

  /** True: the key was meant for the pen, or for the brush. */
  key(pressed: PenKey): boolean {
    if (this.pen?.key?.(pressed)) return true;
    if (pressed.key === "Escape" && activeTool.peek() !== kSelect.id) {
      activeTool.value = kSelect.id;
      return true;
    }
    return false;
  }

  /** True: the turn of the wheel was meant for the pen. */
  wheel(notches: number): boolean {
    return this.pen?.wheel?.(notches) ?? false;
  }

  /** Values of members of the selected things, if all of them belong to one slot. */
  selectedOfOneSlot(): readonly Feature[] {
    const chosen = this.features.value.filter((feature) => selection.value.has(feature.key));
    return chosen.every((feature) => feature.slot.id === chosen[0]!.slot.id) ? chosen : [];
  }

  /** Sets a member of drawn things; edits of one drag of a slider share a gesture. */
  setMember(features: readonly Feature[], member: string, value: Json, gesture: string): void {
    const step = this.studio.selected.peek();
    const label = `${step ?? ""}: ${lookOf(features[0]!.slot).title.toLowerCase()}, ${member.replace(/_/g, " ")}`;
    const edits = features.map((feature) => ({ do: "set" as const, pointer: `${feature.item.pointer}/${member}`, value }));
    void this.studio.edit(edits, label, gesture);
  }

  close(): void {
    this.pen?.leave?.();
    for (const stop of this.stop) stop();
  }
}

const boxes = new WeakMap<Studio, ToolBox>();

/** The tools of a studio; the same for all that ask. */
export function toolsOf(studio: Studio): ToolBox {
  let box = boxes.get(studio);
  if (!box) boxes.set(studio, (box = new ToolBox(studio)));
  return box;
}
