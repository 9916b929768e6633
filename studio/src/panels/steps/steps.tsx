// The steps of the document as cards in order, with what adds one, and the outputs below.
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Plus, SlidersHorizontal } from "lucide-preact";
import type { Recipe } from "../../api/types";
import { registerActions } from "../../actions/registry";
import type { Studio } from "../../document/studio";
import { type Operators, allConnections } from "../graph/connections";
import { HelpTips } from "../params/help_tip";
import { AddStep } from "./add_step";
import { adding } from "./adding";
import { OutputList } from "./outputs";
import { StepCard } from "./step_card";
import { stepActions } from "./step_actions";
import { moveStep } from "./step_edits";

/** Of each step the steps that it reads, unless that is just the one before. */
function readsOf(recipe: Recipe, operators: Operators): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const [id, connections] of allConnections(recipe, operators)) {
    const at = recipe.steps.findIndex((step) => step.id === id);
    const read = [...new Set([...connections.values()].map((origin) => ("step" in origin ? origin.step : "a file")))];
    found.set(id, read.length === 1 && read[0] === recipe.steps[at - 1]?.id ? [] : read);
  }
  return found;
}

interface Grab {
  id: string;
  y: number;
  moved: boolean;
  to: number;
}

export function Steps({ studio }: { studio: Studio }): JSX.Element {
  const root = useRef<HTMLDivElement>(null);
  const { recipe } = studio.document.value;
  const states = new Map(studio.engine.value.steps.map((state) => [state.id, state]));
  const reads = readsOf(recipe, (name) => studio.operator(name));
  const [grab, setGrab] = useDrag(studio, root);
  useEffect(() => registerActions(stepActions(studio)), [studio]);
  const at = grab ? recipe.steps.findIndex((step) => step.id === grab.id) : -1;
  const drop = (index: number) => (!grab?.moved || grab.to !== index || index === at ? null : index < at
    ? "before" as const : "after" as const);
  return (
    <div class="steps" ref={root}>
      <header class="panel-head"><h2>Steps</h2><span class="muted">{recipe.steps.length || ""}</span>
        <button type="button" class="plain icon small" aria-pressed={studio.selected.value === null}
          aria-label="Document" data-help="The document: size, cells, seed, variables"
          onClick={() => { studio.selected.value = null; }}><SlidersHorizontal /></button>
        <button type="button" class="compact" aria-haspopup="dialog" aria-expanded={adding.value !== null}
          data-help="Add a step after the selected one (Shift+A)"
          onClick={() => { adding.value = adding.value ? null : { after: studio.selected.value }; }}>
          <Plus />Add step</button></header>
      {adding.value && <AddStep studio={studio} request={adding.value} onDone={() => { adding.value = null; }} />}
      {recipe.steps.length === 0 && <p class="empty">Nothing yet. Add a step, or open an example.</p>}
      <ol class="step-list" aria-label="Steps"
        onPointerDown={(event) => { if (event.target === event.currentTarget) studio.selected.value = null; }}>
        {recipe.steps.map((step, i) => <StepCard key={step.id} studio={studio} step={step} index={i}
          op={studio.operator(step.op)} state={states.get(step.id)}
          reads={reads.get(step.id) ?? []} drop={drop(i)} dragged={grab?.moved === true && grab.id === step.id}
          onGrab={(event) => setGrab(step.id, event)} />)}
      </ol>
      <OutputList studio={studio} />
      <HelpTips within={root} />
    </div>
  );
}

/** A card is dragged by its name; Escape lets it be. */
function useDrag(studio: Studio, root: { current: HTMLElement | null }): [Grab | null,
  (id: string, event: PointerEvent) => void] {
  const [grab, setGrab] = useState<Grab | null>(null);
  const held = useRef<Grab | null>(null);
  const update = (next: Grab | null) => {
    held.current = next;
    setGrab(next);
  };
  const start = (id: string, event: PointerEvent) => {
    if (event.button !== 0) return;
    const card = event.currentTarget as HTMLElement;
    update({ id, y: event.clientY, moved: false, to: -1 });
    const move = (moved: PointerEvent) => {
      const now = held.current;
      if (!now || (!now.moved && Math.abs(moved.clientY - now.y) < 5)) return;
      if (!now.moved) card.setPointerCapture(event.pointerId);
      update({ ...now, moved: true, to: indexAt(root.current, moved.clientY) });
    };
    const end = (ended: Event) => {
      const now = held.current;
      for (const name of ["pointerup", "pointercancel"]) document.removeEventListener(name, end);
      document.removeEventListener("pointermove", move);
      document.removeEventListener("keydown", escape);
      update(null);
      if (now?.moved && ended.type === "pointerup" && now.to >= 0) moveStep(studio, id, now.to);
    };
    const escape = (key: KeyboardEvent) => { if (key.key === "Escape") end(key); };
    for (const name of ["pointerup", "pointercancel"]) document.addEventListener(name, end);
    document.addEventListener("pointermove", move);
    document.addEventListener("keydown", escape);
  };
  return [grab, start];
}

function indexAt(root: HTMLElement | null, y: number): number {
  const cards = [...(root?.querySelectorAll<HTMLElement>("[data-step]") ?? [])];
  const found = cards.findIndex((card) => y < card.getBoundingClientRect().bottom);
  return found === -1 ? cards.length - 1 : found;
}
