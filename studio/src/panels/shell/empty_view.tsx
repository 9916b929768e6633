// What stands in the views while there is no ground to show: why, and what to do about it.
import { runAction } from "../../actions/registry";
import { viewport } from "./parts";
import { useStudio } from "./shell";

export function EmptyView() {
  const studio = useStudio();
  const { steps } = studio.document.value.recipe;
  const { terrain } = studio.shown.value;
  const id = terrain?.split(".")[0];
  const standing = studio.engine.value.steps.find((step) => step.id === id);
  if (steps.length === 0) {
    return (
      <div class="empty-sheet">
        <div class="empty-view">
          <h2>An empty sheet</h2>
          <p class="muted">Add a first step, drop a file on the window, or begin with an example.</p>
          <div class="bar-group">
            <button class="primary" onClick={() => runAction("step.add")}>Add a step</button>
            <button onClick={() => runAction("file.examples")}>Examples</button>
          </div>
        </div>
      </div>
    );
  }
  if (terrain === null) {
    return <div class="empty-view"><h2>No ground here</h2><p class="muted">Neither this step nor any before or after it makes a terrain.</p></div>;
  }
  if (studio.values.value.has(terrain)) return null;
  const failed = standing && ["failed", "blocked", "incomplete"].includes(standing.standing);
  if (failed) {
    const broken = studio.engine.value.steps.find((step) => step.standing === "failed" || step.standing === "incomplete");
    return (
      <div class="empty-view">
        <h2>{broken ? `${broken.id} could not be computed` : "Nothing could be computed"}</h2>
        <p class="muted">{broken?.message || "An input is still open."}</p>
        {broken && <div class="bar-group"><button onClick={() => (studio.selected.value = broken.id)}>Show {broken.id}</button></div>}
      </div>
    );
  }
  return viewport.value?.drawn.value ? null : <div class="empty-view late"><p class="muted">Computing…</p></div>;
}
