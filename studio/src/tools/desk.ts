// What a pen works with: the document, the drawn things, the settings, and a way to put a new thing into the recipe.
import type { Json, Recipe } from "../api/types";
import type { Studio } from "../document/studio";
import type { GroundPointer, OverlayShape, PenTarget } from "../viewport/types";
import { addStep, freshId } from "./adding";
import { create, newItem, type Creation } from "./changes";
import type { Feature } from "./features";
import type { FitOptions } from "./fit";
import type { Gesture } from "./gesture";
import type { Point } from "./geometry";
import type { Offer } from "./offers";
import { numberAt, type Domain, type Path } from "./place";
import { slotsOf, type Part, type Slot } from "./slots";

export interface PenKey {
  key: string;
  ctrl: boolean;
  shift: boolean;
}

/** A tool at work. */
export interface Pen extends PenTarget {
  /** True: the key was meant for it. */
  key?(pressed: PenKey): boolean;
  /** The wheel was turned with Alt or Shift, by notches up. True: it was meant for the pen. */
  wheel?(notches: number): boolean;
  /** Another tool is taken: what is half drawn ends. */
  leave?(): void;
}

export interface Desk {
  readonly studio: Studio;
  readonly offer: Offer;
  recipe(): Recipe;
  step(): string | null;
  domain(): Domain;
  features(): readonly Feature[];
  fitting(at: GroundPointer): FitOptions;
  /** Begins a gesture, or goes on with the one of this name; until its end the tool stays. */
  begin(what: string, name?: string): Gesture;
  /** Selects the step that the gesture itself has made; by anybody else it would end the gesture. */
  goTo(step: string | null): void;
  /** The gesture is over. `then`: the tool that goes on. */
  end(then?: string): void;
  draw(shapes: readonly OverlayShape[]): void;
  say(text: string): void;
  select(keys: Iterable<string>, points?: Iterable<string>): void;
  selected(): ReadonlySet<string>;
  selectedPoints(): ReadonlySet<string>;
  /** Members that are chosen for the next thing of a slot. */
  members(slot: Slot): { [name: string]: Json };
  reach(): number;
  /** Shows the ground along a line from the side; null: not any more. */
  profile(line: readonly Point[] | null): void;
}

export const pointOf = (at: GroundPointer): Point => [at.x, at.y];

function nested(path: Path, value: Json): { [name: string]: Json } {
  const [first, ...rest] = path;
  return { [String(first)]: rest.length === 0 ? value : nested(rest, value) };
}

function pointsValue(part: Part, points: readonly Point[]): Json {
  const pairs = points.map(([x, y]) => [x, y]);
  if (part.as === "polygons") return [pairs];
  return part.as === "point" ? pairs[0]! : pairs;
}

/** Parameters of a step that holds nothing but one drawn thing. */
function paramsWith(slot: Slot, part: Part, points: readonly Point[], members: { [name: string]: Json }): { [name: string]: Json } {
  return slot.list
    ? nested(slot.list, [newItem(slot, part, points, members)])
    : nested(part.path, pointsValue(part, points));
}

/** A thing while it is drawn: put into the recipe once, set again with every frame, in one gesture. */
export class Drawing {
  readonly gesture: Gesture;
  private creation: Creation | null = null;
  private added: string | null = null;
  private readonly before: string | null;

  constructor(private readonly desk: Desk, readonly slot: Slot, readonly part: Part, what: string) {
    this.before = desk.step();
    this.gesture = desk.begin(what);
  }

  private edits(points: readonly Point[], members: { [name: string]: Json }) {
    if (this.creation && !this.gesture.wasRefused) return this.creation.again(points, members);
    return this.first(points, members);
  }

  private first(points: readonly Point[], members: { [name: string]: Json }) {
    const { desk, slot, part } = this;
    const recipe = desk.recipe();
    const { adds } = desk.offer;
    if (!adds || adds.existing) {
      const step = adds?.existing ?? this.before!;
      this.creation = create(recipe, step, slot, part, points, members);
      return this.creation.first;
    }
    this.added = freshId(recipe, adds.op);
    const params = paramsWith(slot, part, points, members);
    const edits = addStep(recipe, desk.studio.schema, adds, this.added, params);
    const empty: Recipe = { ...recipe, steps: [{ id: this.added, op: adds.op }] };
    const there = create(empty, this.added, slot, part, points, members);
    this.creation = there;
    return edits;
  }

  private selectAdded(): void {
    const id = this.added ?? this.desk.offer.adds?.existing ?? null;
    if (id !== null && this.desk.studio.step(id)) this.desk.goTo(id);
  }

  live(points: readonly Point[], members: { [name: string]: Json }): void {
    this.gesture.live(() => {
      queueMicrotask(() => this.selectAdded());
      return this.edits(points, members);
    });
  }

  /** Ends it; the new thing is selected. */
  async finish(points: readonly Point[], members: { [name: string]: Json }): Promise<boolean> {
    const answer = this.gesture.finish(() => this.edits(points, members));
    this.selectAdded();
    const key = this.creation?.key;
    const drawn = this.slot.brush ? [] : this.desk.features().filter((f) => f.key === key || f.key.startsWith(`${key}/`) || f.key.startsWith(`${key}#`));
    this.desk.select(drawn.map((feature) => feature.key));
    this.desk.end(this.desk.offer.adds ? `slot:${this.slot.id}` : undefined);
    return answer;
  }

  cancel(): void {
    const { begun } = this.gesture;
    void this.gesture.cancel();
    if (begun && this.added) this.desk.goTo(this.before);
    this.desk.end();
  }
}

/** Another tool of the same list, which the hand calls by a modifier: lower for raise, smooth for any. */
export function siblingSlot(desk: Desk, slot: Slot, tool: string): Slot | undefined {
  const operator = desk.studio.operator(slot.op);
  return operator && slotsOf(operator).find((other) => other.tool === tool && other.list?.join() === slot.list?.join());
}

/** Iteration after which an edit of a scene is done: the last one, unless another was chosen. */
export function withIteration(desk: Desk, slot: Slot, members: { [name: string]: Json }): { [name: string]: Json } {
  if (!slot.members.some((member) => member.name === "after") || typeof members["after"] === "number") return members;
  const step = desk.step();
  const iterations = (step === null ? undefined : numberAt(desk.recipe(), step, ["iterations"])) ?? 30;
  return slot.tool === "add" ? members : { ...members, after: Math.max(0, iterations - 1) };
}
