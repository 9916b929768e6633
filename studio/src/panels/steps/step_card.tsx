// A step as a card of the list: picture, name, operator, how far it is, and what can be done to it.
import type { JSX } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { CircleSlash, Copy, Pin, Trash2, TriangleAlert } from "lucide-preact";
import type { OperatorInfo, Step, StepState } from "../../api/types";
import type { Studio } from "../../document/studio";
import { FamilyIcon } from "./family_icon";
import { Progress, StandingSign } from "./standing";
import { duplicate, idProblem, isPinned, moveStep, removeStep, renameStep, toggleBypass,
  togglePin } from "./step_edits";
import { Thumbnail } from "./thumbnail";

interface StepCardProps {
  studio: Studio;
  step: Step;
  index: number;
  op: OperatorInfo | undefined;
  state: StepState | undefined;
  /** Steps that it reads, but for the one before it. */
  reads: readonly string[];
  drop: "before" | "after" | null;
  dragged: boolean;
  onGrab(event: PointerEvent): void;
}

export function StepCard(props: StepCardProps): JSX.Element {
  const { studio, step, op, state } = props;
  const [naming, setNaming] = useState(false);
  const selected = studio.selected.value === step.id;
  const stale = state !== undefined && state.standing !== "fresh";
  const classes = ["step-card", selected && "selected", step.bypass && "bypassed", state?.standing === "failed"
    && "failed",
    props.drop && `drop-${props.drop}`, props.dragged && "dragged"].filter(Boolean).join(" ");
  const onKeyDown = (event: KeyboardEvent) => onCardKey(event, props, () => setNaming(true));
  const card = useRef<HTMLLIElement>(null);
  useEffect(() => { if (selected) card.current?.scrollIntoView({ block: "nearest" }); }, [selected]);
  return (
    <li class={classes} data-step={step.id} ref={card}>
      <div class="step-main">
        <Thumbnail studio={studio} id={step.id} op={op} stale={stale} />
        {naming ? <NameInput studio={studio} id={step.id} onDone={() => setNaming(false)} /> : (
          <button type="button" class="plain step-select" aria-pressed={selected}
            tabIndex={selected || (studio.selected.value === null && props.index === 0) ? 0 : -1}
            aria-label={`${step.id}, ${step.op}`} onPointerDown={props.onGrab}
            onClick={() => { studio.selected.value = step.id; }} onDblClick={() => setNaming(true)}
            onKeyDown={onKeyDown}>
            <FamilyIcon op={step.op} /><span class="step-id ellipsis">{step.id}</span>
          </button>
        )}
        <StandingSign state={state} />
        <span class="step-op ellipsis" title={op?.summary}>{step.op}{props.reads.length > 0
          && <span class="step-reads"> ← {props.reads.join(", ")}</span>}</span>
        <CardActions studio={studio} id={step.id} bypassed={step.bypass === true} />
      </div>
      <Progress state={state} />
      {state?.message && (state.standing === "failed" || state.standing === "incomplete")
        && <p class="problem"><TriangleAlert />{plainMessage(state.message)}</p>}
      {selected && state?.notes.map((note) => <p class="note" key={note}>{note}</p>)}
    </li>
  );
}

/** The card says which step it is: "step 'high' (contour.heights): " goes. */
export function plainMessage(message: string): string {
  const plain = message.replace(/^step '[^']*' \([^)]*\): /, "");
  return plain.charAt(0).toUpperCase() + plain.slice(1);
}

export function CardActions({ studio, id, bypassed }: { studio: Studio; id: string; bypassed: boolean }): JSX.Element {
  const pinned = isPinned(studio, id);
  return (
    <span class="step-actions">
      <button type="button" class="plain icon small" aria-pressed={bypassed} aria-label={`Leave ${id} out`}
        data-help="Leave it out: what it reads is passed on"
        onClick={() => toggleBypass(studio, id)}><CircleSlash /></button>
      <button type="button" class="plain icon small" aria-pressed={pinned} aria-label={`Pin ${id}`}
        data-help="Show this step whatever is selected"
        onClick={() => togglePin(studio, id)}><Pin /></button>
      <button type="button" class="plain icon small" aria-label={`Duplicate ${id}`} data-help="Duplicate"
        onClick={() => void duplicate(studio, id)}><Copy /></button>
      <button type="button" class="plain icon small" aria-label={`Remove ${id}`}
        data-help="Remove; what read it reads what it read"
        onClick={() => void removeStep(studio, id)}><Trash2 /></button>
    </span>
  );
}

/** Arrows select, Alt+arrows move, F2 renames, Delete removes, Ctrl+D copies, B leaves out, P pins. */
function onCardKey(event: KeyboardEvent, { studio, step, index }: StepCardProps, rename: () => void): void {
  const { steps } = studio.document.value.recipe;
  const focusOn = (id: string | undefined) => {
    if (id === undefined) return;
    studio.selected.value = id;
    const list = (event.currentTarget as HTMLElement).closest("ol");
    const focus = () => list?.querySelector<HTMLElement>(`[data-step="${CSS.escape(id)}"] .step-select`)?.focus();
    focus();
    requestAnimationFrame(focus);  // a card that was moved has lost it
  };
  const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
  const by = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
  if (by !== 0 && event.altKey) {
    moveStep(studio, step.id, index + by);
    focusOn(step.id);
  } else if (by !== 0) focusOn(steps[index + by]?.id);
  else if (event.key === "Home") focusOn(steps[0]?.id);
  else if (event.key === "End") focusOn(steps[steps.length - 1]?.id);
  else if (event.key === "F2") rename();
  else if (event.key === "Delete" && plain) void removeStep(studio, step.id);
  else if (event.key.toLowerCase() === "d" && (event.ctrlKey || event.metaKey)) void duplicate(studio, step.id);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

function NameInput({ studio, id, onDone }: { studio: Studio; id: string; onDone(): void }): JSX.Element {
  const [name, setName] = useState(id);
  const input = useRef<HTMLInputElement>(null);
  const done = useRef(false);
  useLayoutEffect(() => {
    input.current?.focus();
    input.current?.select();
  }, []);
  const problem = idProblem(studio, id, name);
  const finish = (keep: boolean) => {
    if (done.current) return;
    done.current = true;
    if (keep) void renameStep(studio, id, name);
    onDone();
  };
  return (
    <span class="step-naming">
      <input ref={input} type="text" aria-label={`New name of ${id}`} aria-invalid={problem !== ""} value={name}
        spellcheck={false}
        onInput={(event) => setName(event.currentTarget.value)} onBlur={() => finish(problem === "")}
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === "Enter" && problem === "") finish(true);
          if (event.key === "Escape") finish(false);
        }} />
      {problem && <span class="number-hint wrong" role="alert">{problem}</span>}
    </span>
  );
}
