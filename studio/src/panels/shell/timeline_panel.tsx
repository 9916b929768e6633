// The time line of the dock: the events of the selected step, or of the first step that has any.
import type { Json, ParamInfo, Step } from "../../api/types";
import { fieldOf, scopeOf } from "../params/scope";
import { hasTimes, Timeline } from "../timeline/timeline";
import { useStudio } from "./shell";

export function TimelinePanel() {
  const studio = useStudio();
  const events = (step: Step): ParamInfo | undefined => (
    studio.operator(step.op)?.params.find((param) => param.kind === "tools" && hasTimes(param))
  );
  const { steps } = studio.document.value.recipe;
  const chosen = steps.find((step) => step.id === studio.selected.value && events(step)) ?? steps.find(events);
  const info = chosen && events(chosen);
  if (!chosen || !info) {
    return <p class="empty">Steps that grow life have events: the ground rises, a storm comes, a current turns. Here they are in order.</p>;
  }
  const params = studio.operator(chosen.op)!.params;
  const scope = scopeOf(studio, chosen.id, chosen.id, `/steps/${chosen.id}/params`, params, chosen.params as Json | undefined);
  const field = fieldOf(scope, info);
  return (
    <div class="timeline-panel">
      <h3>{chosen.id}</h3>
      {Array.isArray(field.value) && field.value.length > 0
        ? <Timeline field={field} />
        : <p class="empty">No event yet. Tools and parameters of this step add some.</p>}
    </div>
  );
}
