// The panel of events: those of the selected step, or of the first step that can have some.
import type { JSX } from "preact";
import { useRef } from "preact/hooks";
import type { Json, OperatorInfo, ParamInfo, Step } from "../../api/types";
import type { Studio } from "../../document/studio";
import { HelpTips } from "../params/help_tip";
import { AddItem } from "../params/item_list";
import { addTool, itemsOf } from "../params/list_edits";
import { fieldOf, scopeOf } from "../params/scope";
import { EventLines, hasTimes } from "./event_lines";

function eventsOf(op: OperatorInfo | undefined): ParamInfo | undefined {
  return op?.params.find(hasTimes);
}

/** The step whose events are shown. */
export function stepWithEvents(studio: Studio): Step | undefined {
  const { steps } = studio.document.value.recipe;
  const has = (step: Step) => eventsOf(studio.operator(step.op)) !== undefined;
  return steps.find((step) => step.id === studio.selected.value && has(step)) ?? steps.find(has);
}

export function Timeline({ studio }: { studio: Studio }): JSX.Element {
  const root = useRef<HTMLDivElement>(null);
  const step = stepWithEvents(studio);
  const op = step && studio.operator(step.op);
  const info = eventsOf(op);
  if (!step || !op || !info) {
    const able = studio.schema.operators.filter((operator) => eventsOf(operator)).map((operator) => operator.name);
    return <p class="empty">No step has events{able.length > 0
      ? `: add ${able.join(" or ")} to let storms, currents and a changing sea shape what grows` : ""}.</p>;
  }
  const field = fieldOf(scopeOf(studio, step.id, step.id, `/steps/${step.id}/params`, op.params,
    step.params as Json | undefined), info);
  return (
    <div class="timeline-panel" ref={root}>
      <div class="items-head">
        <button type="button" class="plain compact" aria-pressed={studio.selected.value === step.id}
          onClick={() => { studio.selected.value = step.id; }}>{step.id}</button>
        <span class="muted items-count">{itemsOf(field).length === 0 ? "No events yet" : ""}</span>
        <AddItem field={field} onAdd={(tool) => { studio.selected.value = step.id; addTool(field, tool); }} />
      </div>
      <EventLines field={field} />
      <HelpTips within={root} />
    </div>
  );
}
