// 'Add step': a search over all operators, those that fit the selected step first. The chosen one comes after it and is
// connected to what fits.
import type { JSX } from "preact";
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import { Search, X } from "lucide-preact";
import type { OperatorInfo } from "../../api/types";
import type { Studio } from "../../document/studio";
import type { Origin } from "../graph/connections";
import { type Fit, connectedNew, fitAfter, insertIntoWire, insertStep, readNew } from "../graph/insert";
import type { AddRequest } from "./adding";
import { FamilyIcon } from "./family_icon";
import { findOperators, takesAndMakes } from "./search";

const RANK: { readonly [fit in Fit]: number } = { follows: 0, upstream: 1, begins: 2, other: 3 };

/** Of a loose wire: what can take it up. */
function fitsWire(op: OperatorInfo, { from, to, into }: AddRequest): boolean {
  if (into) return op.in.some((port) => port.kind === into.kind) && op.out.some((port) => port.kind === into.kind);
  if (from) return op.in.some((port) => port.kind === from.port.kind);
  if (to) return op.out.some((port) => port.kind === to.port.kind);
  return true;
}

async function add(studio: Studio, op: OperatorInfo, request: AddRequest): Promise<void> {
  const { recipe } = studio.document.value;
  const operators = (name: string) => studio.operator(name);
  const { from, to, into } = request;
  const end = into && studio.operator(studio.step(into.to)?.op ?? "")?.in.find((port) => port.name === into.input);
  if (into && end) {
    const between = insertIntoWire(op, { step: into.from, port: into.output }, into.to, end, recipe, operators);
    if (between && await studio.edit(between.edits,
      `${between.id} added between ${into.from} and ${into.to}`)) studio.selected.value = between.id;
    return;
  }
  const after = from?.step ?? request.after;
  let wanted: Map<string, Origin> | undefined;
  if (from) {
    const index = recipe.steps.findIndex((step) => step.id === from.step) + 1;
    wanted = new Map(connectedNew(op, recipe, index, operators));
    const port = op.in.find((input) => input.name === from.port.name && input.kind === from.port.kind)
      ?? op.in.find((input) => input.kind === from.port.kind);
    if (port) wanted.set(port.name, { step: from.step, port: from.port.name });
  }
  const insertion = insertStep(op, after, recipe, operators, wanted);
  const { id, edits } = insertion;
  const made = to && (op.out.find((port) => port.name === to.port.name && port.kind === to.port.kind)
    ?? op.out.find((port) => port.kind === to.port.kind));
  const index = after === null ? recipe.steps.length : recipe.steps.findIndex((step) => step.id === after) + 1;
  if (to && made) edits.push(readNew(insertion, op, made.name, to.step, to.port.name, index, recipe, operators));
  if (await studio.edit(edits, `${id} added`)) studio.selected.value = id;
}

export function AddStep({ studio, request, onDone }: { studio: Studio; request: AddRequest;
  onDone(): void }): JSX.Element {
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const steps = studio.document.value.recipe.steps;
  const after = request.from?.step ?? request.after ?? steps[steps.length - 1]?.id;
  const selected = after === undefined ? undefined : studio.operator(studio.step(after)?.op ?? "");
  const made = useMemo(() =>
    new Set(steps.flatMap((step) => (studio.operator(step.op)?.out ?? []).map((port) => port.kind))), [steps]);
  const fit = (op: OperatorInfo) => fitAfter(op, selected, made);
  const found = useMemo(() => findOperators(query, studio.schema.operators.filter((op) => fitsWire(op, request)),
    (op) => RANK[fit(op)]),
    [query, selected, studio.schema, request, made]);
  useLayoutEffect(() => {
    const before = document.activeElement;
    input.current?.focus();
    return () => { if (before instanceof HTMLElement && before.isConnected) before.focus(); };
  }, []);
  useEffect(() => list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" }),
    [at, query]);
  const choose = (op: OperatorInfo | undefined) => {
    if (!op) return;
    onDone();
    void add(studio, op, request);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === "Escape") onDone();
    else if (event.key === "Enter") choose(found[at]);
    else if (event.key === "ArrowDown") setAt(Math.min(found.length - 1, at + 1));
    else if (event.key === "ArrowUp") setAt(Math.max(0, at - 1));
    else if (event.key === "PageDown") setAt(Math.min(found.length - 1, at + 6));
    else if (event.key === "PageUp") setAt(Math.max(0, at - 6));
    else if (event.key !== "Tab") return event.stopPropagation();
    else onDone();
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div class="add-step" role="dialog" aria-label="Add step">
      <div class="add-search"><Search />
        <input ref={input} type="text" role="combobox" aria-expanded="true" aria-controls="add-step-list"
          aria-activedescendant={found[at] ? `add-${at}` : undefined}
          aria-label="Search operators" placeholder={after ? `Add after ${after}…` : "Add a step…"} value={query}
          spellcheck={false} autocomplete="off"
          onInput={(event) => { setQuery(event.currentTarget.value); setAt(0); }} onKeyDown={onKeyDown} />
        <button type="button" class="plain icon small" aria-label="Close" onClick={onDone}><X /></button></div>
      <ul id="add-step-list" ref={list} role="listbox" aria-label="Operators">
        {found.flatMap((op, i) => [
          ...(query === "" && (i === 0 || fit(found[i - 1]!) !== fit(op))
            ? [<li key={fit(op)} class="add-group" role="presentation">{HEADS[fit(op)](after)}</li>] : []),
          <Choice key={op.name} id={`add-${i}`} op={op} chosen={i === at} fit={fit(op)} onChoose={() => choose(op)}
            onPoint={() => setAt(i)} />,
        ])}
        {found.length === 0 && <li class="empty" role="option" aria-selected="false">Nothing is called so.</li>}
      </ul>
    </div>
  );
}

const HEADS: { readonly [fit in Fit]: (after: string | undefined) => string } = {
  follows: (after) => `Reads ${after ?? "it"}`, upstream: () => "Reads earlier steps", begins: () => "Begins anew",
    other: () => "Needs something else",
};

interface ChoiceProps {
  id: string;
  op: OperatorInfo;
  chosen: boolean;
  fit: Fit;
  onChoose(): void;
  onPoint(): void;
}

function Choice({ id, op, chosen, fit, onChoose, onPoint }: ChoiceProps): JSX.Element {
  const { takes, makes } = takesAndMakes(op);
  return (
    <li id={id} role="option" aria-selected={chosen} class={`add-choice ${fit}`} onClick={onChoose}
      onPointerMove={() => { if (!chosen) onPoint(); }}>
      <FamilyIcon op={op.name} />
      <span class="add-words"><span class="add-name">{op.name}</span><span class="add-summary">{op.summary}</span>
        <span class="add-ports">{takes} → {makes}</span></span>
    </li>
  );
}
