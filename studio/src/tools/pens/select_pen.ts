// Selects and edits what is drawn: a click selects, a drag moves points, whole things, or draws a box; a handle between
// two points makes a point; keys delete and nudge.
import type { Edit } from "../../api/types";
import type { GroundPointer, OverlayShape } from "../../viewport/types";
import { insertPoint, moveFeature, removeFeatures, removePoints, setPoints } from "../changes";
import { pointOf, type Desk, type Pen, type PenKey } from "../desk";
import type { Feature } from "../features";
import { tolerance } from "../fit";
import type { Gesture } from "../gesture";
import { distance, roundedPoint, roundingStep, smoothed, type Point } from "../geometry";
import { hitTest, insideBox, isClosed, type Hit } from "../hit";
import { TypedNumber } from "../typed_number";
import { kClick_px } from "./line_pen";

interface Held {
  hit: Hit | null;
  from: GroundPointer;
  /** As they were when the hand took hold. */
  features: Feature[];
  /** Points that move; null: the whole features. */
  points: ReadonlyMap<string, ReadonlySet<number>> | null;
  gesture: Gesture | null;
  wasSelected: boolean;
}

const kArrows: { [key: string]: Point } = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
};

export class SelectPen implements Pen {
  cursor: Pen["cursor"] = "default";
  private held: Held | null = null;
  private pixel_m = 0;
  private lastKey = { at: 0, gesture: "" };
  private readonly typed: TypedNumber;

  constructor(private readonly desk: Desk) {
    this.typed = new TypedNumber(desk, () => this.selectedFeatures()[0]);
  }

  private selectedFeatures(): Feature[] {
    return this.desk.features().filter((feature) => this.desk.selected().has(feature.key));
  }

  private hit(at: GroundPointer): Hit | null {
    return hitTest(this.desk.features(), this.desk.selected(), pointOf(at), at.pixel_m);
  }

  down(at: GroundPointer): void {
    this.typed.finish();
    this.pixel_m = at.pixel_m;
    const hit = this.hit(at);
    const wasSelected = hit !== null && this.desk.selected().has(hit.feature.key);
    this.held = { hit, from: at, features: [], points: null, gesture: null, wasSelected };
    if (!hit) return;
    if (at.ctrl && (hit.part === "segment" || hit.part === "middle")) return this.insert(hit, at);
    if (!wasSelected) this.desk.select(at.shift ? [...this.desk.selected(), hit.feature.key] : [hit.feature.key]);
    if (hit.part === "point") this.choosePoint(hit.feature, hit.index, at.shift);
  }

  private choosePoint(feature: Feature, index: number, more: boolean): void {
    const name = `${feature.key} ${index}`;
    const points = this.desk.selectedPoints();
    if (points.has(name)) return;
    this.desk.select(more ? this.desk.selected() : [feature.key], more ? [...points, name] : [name]);
  }

  private insert(hit: Hit & { part: "segment" | "middle" }, at: GroundPointer): void {
    const step = roundingStep(tolerance(this.desk.fitting(at)));
    const place = roundedPoint(pointOf(at), step);
    const { feature, segment, share } = hit;
    const points = [...feature.points.slice(0, segment + 1), place, ...feature.points.slice(segment + 1)];
    const gesture = this.desk.begin("point added");
    const held = this.held!;
    held.gesture = gesture;
    // From here on the new point is what the hand holds; edits are those of the line without it.
    const moving = (now: GroundPointer): Edit[] => insertPoint(
      feature, segment, share, roundedPoint(pointOf(now), step),
    );
    this.inserting = moving;
    gesture.live(() => moving(at));
    this.desk.select([feature.key], [`${feature.key} ${segment + 1}`]);
    held.features = [{ ...feature, points }];
  }

  private inserting: ((now: GroundPointer) => Edit[]) | null = null;

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    const held = this.held;
    if (!at || !held) return;
    if (this.inserting) {
      const { inserting } = this;
      return held.gesture!.live(() => inserting(at));
    }
    if (!held.gesture && distance(pointOf(at), pointOf(held.from)) <= kClick_px * at.pixel_m) return;
    if (!held.hit) return this.box(held.from, at);
    if (!held.gesture && (held.hit.part === "middle")) return this.insert(held.hit, at);
    this.drag(held, at);
  }

  private grab(held: Held): void {
    held.features = this.selectedFeatures();
    const points = this.desk.selectedPoints();
    if (held.hit!.part === "point" && held.hit!.feature.points.length > 1) {
      const chosen = new Map<string, Set<number>>();
      for (const name of points) {
        const [key, index] = [name.slice(0, name.lastIndexOf(" ")), Number(name.slice(name.lastIndexOf(" ") + 1))];
        chosen.set(key, (chosen.get(key) ?? new Set()).add(index));
      }
      held.points = chosen;
    }
    held.gesture = this.desk.begin(held.points ? "point moved" : "moved");
  }

  private drag(held: Held, at: GroundPointer): void {
    if (!held.gesture) this.grab(held);
    const [dx, dy] = [at.x - held.from.x, at.y - held.from.y];
    const step = roundingStep(tolerance(this.desk.fitting(at)));
    held.gesture!.live(() => held.features.flatMap((feature) => this.movedEdits(feature, held.points, dx, dy, step)));
  }

  private movedEdits(feature: Feature, points: Held["points"], dx: number, dy: number, step: number): Edit[] {
    if (!points) return moveFeature(feature, dx, dy, step);
    const chosen = points.get(feature.key);
    if (!chosen) return [];
    if (feature.geometry === "vector" && chosen.has(0)) return moveFeature(feature, dx, dy, step);
    return setPoints(
      feature, feature.points.map(([x, y], i) => (chosen.has(i) ? roundedPoint([x + dx, y + dy], step) : [x, y])),
    );
  }

  private box(from: GroundPointer, at: GroundPointer): void {
    const [a, b] = [pointOf(from), pointOf(at)];
    const corners: Point[] = [a, [b[0], a[1]], b, [a[0], b[1]]];
    this.desk.draw(
      [
        { shape: "area", points: corners, role: "guide" },
        { shape: "line", points: corners, role: "guide", closed: true, width_px: 1 },
      ],
    );
  }

  up(at: GroundPointer): void {
    const held = this.held;
    this.held = null;
    this.inserting = null;
    this.desk.draw([]);
    if (!held) return;
    if (held.gesture) {
      void held.gesture.finish();
      return this.desk.end();
    }
    const moved = distance(pointOf(at), pointOf(held.from)) > kClick_px * at.pixel_m;
    if (!held.hit) {
      const found = moved ? insideBox(this.desk.features(), pointOf(held.from), pointOf(at)).map((f) => f.key) : [];
      return this.desk.select(at.shift ? [...this.desk.selected(), ...found] : found);
    }
    if (moved || !held.wasSelected) return;
    const { feature } = held.hit;
    if (at.shift && held.hit.part !== "point") this.desk.select(
      [...this.desk.selected()].filter((key) => key !== feature.key),
    );
    else if (!at.shift && held.hit.part !== "point") this.desk.select([feature.key]);
  }

  cancel(): void {
    const gesture = this.held?.gesture;
    this.held = this.inserting = null;
    this.typed.cancel();
    this.desk.draw([]);
    if (!gesture) return;
    void gesture.cancel();
    this.desk.end();
  }

  leave(): void {
    this.typed.finish();
    this.cancel();
  }

  /** A double click on a line makes a point there. */
  double(at: GroundPointer): void {
    const hit = this.hit(at);
    if (hit?.part !== "segment" && hit?.part !== "middle") return;
    this.held = { hit, from: at, features: [], points: null, gesture: null, wasSelected: true };
    this.insert(hit, at);
    this.up(at);
  }

  hover(at: GroundPointer | null): void {
    if (!at || this.held) return;
    this.pixel_m = at.pixel_m;
    const hit = this.hit(at);
    this.cursor = !hit ? "default" : hit.part === "point" || hit.part === "middle" ? "pointer" : "move";
    const over: OverlayShape[] = [];
    if (hit && hit.part !== "inside" && hit.feature.points.length > 1 && !this.desk.selected().has(hit.feature.key)) {
      over.push(
        { shape: "line", points: hit.feature.points, role: "selected", width_px: 2, closed: isClosed(hit.feature) },
      );
    }
    if (hit?.part === "point") over.push(
      { shape: "dot", at: hit.feature.points[hit.index]!, role: "selected", handle: true },
    );
    if (hit?.part === "middle" || hit?.part === "segment") {
      if (this.desk.selected().has(hit.feature.key)) over.push({ shape: "dot", at: hit.at, role: "handle" });
    }
    this.desk.draw(over);
  }

  key(pressed: PenKey): boolean {
    if (this.typed.key(pressed)) return true;
    const { key, shift, ctrl } = pressed;
    if (key === "Escape") return this.escape();
    if (key === "a" && ctrl) return this.selectAll();
    const features = this.selectedFeatures();
    if (features.length === 0 || ctrl) return false;
    if (key === "Delete" || key === "Backspace") return this.remove(features);
    const arrow = kArrows[key];
    if (arrow) return this.nudge(features, arrow, shift ? 10 : 1);
    if (key === "s" || key === "S") return this.once("smoothed", this.smoothEdits(features));
    return false;
  }

  private escape(): boolean {
    if (this.held?.gesture) this.cancel();
    else if (this.desk.selected().size > 0) this.desk.select([]);
    else return false;
    return true;
  }

  private selectAll(): boolean {
    this.desk.select(this.desk.features().map((feature) => feature.key));
    return true;
  }

  /** One edit by a key; keys that follow each other quickly are one entry of the history. */
  private once(what: string, edits: Edit[], joined = false): boolean {
    if (edits.length === 0) return false;
    const now = Date.now();
    const goesOn = joined && now - this.lastKey.at < 700 ? this.lastKey.gesture : undefined;
    const gesture = this.desk.begin(what, goesOn);
    this.lastKey = { at: joined ? now : 0, gesture: gesture.id };
    void gesture.finish(() => edits);
    this.desk.end();
    return true;
  }

  private smoothEdits(features: readonly Feature[]): Edit[] {
    const step = roundingStep(this.pixel_m || 1);
    return features
      .filter((f) => f.points.length > 2 && f.geometry !== "vector")
      .flatMap((f) => setPoints(f, smoothed(f.points, isClosed(f)).map((p) => roundedPoint(p, step))));
  }

  private remove(features: readonly Feature[]): boolean {
    const points = this.desk.selectedPoints();
    const single = features.filter((feature) => feature.points.some((_, i) => points.has(`${feature.key} ${i}`)));
    const what = single.length > 0 && single.some((f) => f.points.length > 1) ? "point deleted" : "deleted";
    const edits = single.length > 0 ? removePoints(single, (f, i) => points.has(`${f.key} ${i}`))
      : removeFeatures(features);
    this.desk.select(what === "point deleted" ? features.map((f) => f.key) : []);
    return this.once(what, edits);
  }

  private nudge(features: readonly Feature[], [x, y]: Point, times: number): boolean {
    const by = Math.max(this.pixel_m || this.desk.domain().cell_m, 1e-3) * times;
    const step = roundingStep(by);
    const points = this.desk.selectedPoints();
    const chosen = new Map(
      features.map((f) => [f.key, new Set([...f.points.keys()].filter((i) => points.has(`${f.key} ${i}`)))]),
    );
    const some = [...chosen.values()].some((set) => set.size > 0);
    return this.once(
      "nudged", features.flatMap((f) => this.movedEdits(f, some ? chosen : null, x * by, y * by, step)), true,
    );
  }
}
