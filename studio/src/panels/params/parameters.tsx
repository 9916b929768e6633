// The panel of the selected step: what it reads, its parameters as the schema describes them, its seed. Without a
// selection: the document.
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Search, TriangleAlert } from "lucide-preact";
import type { Json, OperatorInfo, ParamInfo, Step } from "../../api/types";
import type { Studio } from "../../document/studio";
import { FamilyIcon } from "../steps/family_icon";
import { AboutText, DomainPanel } from "./domain_panel";
import { HelpTips } from "./help_tip";
import { Inputs } from "./inputs";
import { hovered, ParamList } from "./param_row";
import { resetField, scopeOf } from "./scope";
import { SeedRow } from "./seed_row";

const LONG = 14;

function countParams(params: readonly ParamInfo[]): number {
  return params.reduce((sum, info) => sum + 1 + (info.kind === "group" ? countParams(info.tools?.[0]?.params ?? [])
    : 0), 0);
}

export function Parameters({ studio }: { studio: Studio }): JSX.Element {
  const root = useRef<HTMLDivElement>(null);
  const id = studio.selected.value;
  const step = id === null ? undefined : studio.document.value.recipe.steps.find((candidate) => candidate.id === id);
  const op = step && studio.operator(step.op);
  useBackspace();
  return (
    <div class="params" ref={root}>
      {step && op ? <StepParameters key={step.id} studio={studio} step={step} op={op} />
        : step ? <p class="empty">There is no operator "{step.op}".</p>
        : <><header class="params-head"><h2>Document</h2></header><DomainPanel studio={studio} /></>}
      <HelpTips within={root} />
    </div>
  );
}

/** Backspace resets the parameter under the pointer or the one with the focus, whichever was gone to last, unless
 * something is being typed. */
function useBackspace(): void {
  useEffect(() => {
    const reset = (event: KeyboardEvent): void => {
      if (event.key !== "Backspace" || !hovered.field || event.defaultPrevented) return;
      const target = event.target instanceof HTMLElement ? event.target : null;
      if (target?.matches("input, textarea, select, [contenteditable]")) return;
      event.preventDefault();
      event.stopPropagation();
      resetField(hovered.field);
    };
    const before = (event: KeyboardEvent): void => {
      if (hovered.last) reset(event);
    };
    const focused = (): void => {
      hovered.last = false;
    };
    document.addEventListener("keydown", before, true);
    document.addEventListener("keydown", reset);
    document.addEventListener("focusin", focused);
    return () => {
      document.removeEventListener("keydown", before, true);
      document.removeEventListener("keydown", reset);
      document.removeEventListener("focusin", focused);
    };
  }, []);
}

function StepParameters({ studio, step, op }: { studio: Studio; step: Step; op: OperatorInfo }): JSX.Element {
  const [search, setSearch] = useState("");
  const [told, setTold] = useState(false);
  const scope = scopeOf(studio, step.id, step.id, `/steps/${step.id}/params`, op.params,
    step.params as Json | undefined);
  const long = countParams(op.params) >= LONG;
  const missing = studio.document.value.missing.filter((diagnostic) => isOf(studio, diagnostic.pointer, step));
  return (
    <>
      <header class="params-head">
        <FamilyIcon op={op.name} />
        <h2 class="ellipsis">{step.id}</h2>
        <button type="button" class="plain params-op" aria-expanded={told} data-help={op.summary}
          onClick={() => setTold(!told)}>{op.name}</button>
      </header>
      {told && <OperatorPage op={op} />}
      <div class="params-body" data-fields>
        {missing.map((diagnostic) => <p class="problem"
          key={diagnostic.pointer}><TriangleAlert />{diagnostic.message}</p>)}
        <Inputs studio={studio} step={step} op={op} />
        {long && (
          <div class="params-search"><Search />
            <input type="search" placeholder="Search parameters" aria-label="Search parameters" value={search}
              onInput={(event) => setSearch(event.currentTarget.value)}
              onKeyDown={(event) => {
                if (event.key === "Escape") setSearch("");
                event.stopPropagation();
              }} /></div>
        )}
        <ParamList scope={scope} search={search} />
        {op.stochastic && search === "" && <SeedRow studio={studio} owner={step.id} pointer={`/steps/${step.id}/seed`}
          seed={step.seed} derived />}
        {search === "" && <AboutText studio={studio} pointer={`/steps/${step.id}/about`} owner={step.id}
          text={step.about} placeholder="A note on this step" />}
      </div>
    </>
  );
}

/** Whether a diagnostic's place, by index or id, lies in the step. */
function isOf(studio: Studio, pointer: string, step: Step): boolean {
  const [, list, token] = pointer.split("/");
  return list === "steps" && (token === step.id || studio.document.value.recipe.steps[Number(token)]?.id === step.id);
}

/** What the reference says of the operator. */
function OperatorPage({ op }: { op: OperatorInfo }): JSX.Element {
  return (
    <div class="operator-page">
      <p>{op.summary}.</p>
      {op.in.length > 0 && <dl>
        <dt>Takes</dt>{op.in.map((port) => <dd key={port.name}><b>{port.name}</b> {port.kind}{port.required ? ""
        : ", optional"}: {port.help}</dd>)}</dl>}
      <dl><dt>Makes</dt>{op.out.map((port) => <dd key={port.name}>
        <b>{port.name}</b> {port.kind}: {port.help}</dd>)}</dl>
      {op.source && <p class="muted">After {op.source}</p>}
    </div>
  );
}
