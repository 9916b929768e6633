// The line at the foot: panels to open, the place under the pointer, the map's scale, and long jobs.
import { X } from "lucide-preact";
import { ActionButton } from "./keys";
import { mapScale, pointed } from "./parts";
import { useStudio } from "./shell";
import { numberText } from "./words";

const kPlaces = [
  { id: "panel.graph", text: "Graph" },
  { id: "panel.text", text: "Recipe" },
  { id: "panel.history", text: "History" },
  { id: "panel.timeline", text: "Timeline" },
];

export function StatusLine() {
  return (
    <footer class="status-line">
      <nav class="status-tabs" aria-label="Panels">
        {kPlaces.map(({ id, text }) => <ActionButton key={id} id={id} text={text} />)}
      </nav>
      <Missing />
      <div class="bar-space" />
      <Jobs />
      <Pointed />
    </footer>
  );
}

/** Alone, so that a moving pointer draws nothing else anew. */
function Pointed() {
  const at = pointed.value;
  const pixel_m = mapScale.value;
  return (
    <div class="status-place" aria-hidden={at === null}>
      {at && (
        <>
          <span class="status-number"><span class="muted">x</span> {numberText(at.x)}</span>
          <span class="status-number"><span class="muted">y</span> {numberText(at.y)}</span>
          <span class="status-number wide">
            {at.height === null ? <span class="muted">no ground</span> : `${numberText(at.height, 1)} m`}
          </span>
          {at.label && <span class="status-label"><span class={`region-swatch ${at.label}`} />{at.label}</span>}
        </>
      )}
      {pixel_m !== null && <span class="status-number muted">1 px = {scaleText(pixel_m)}</span>}
    </div>
  );
}

function scaleText(pixel_m: number): string {
  return pixel_m >= 1000 ? `${numberText(pixel_m / 1000, 1)} km` : `${numberText(pixel_m, pixel_m < 10 ? 1 : 0)} m`;
}

function Missing() {
  const { missing } = useStudio().document.value;
  if (missing.length === 0) return null;
  const words = missing.length === 1 ? "1 input is open" : `${missing.length} inputs are open`;
  return <span class="status-missing" title={missing.map((one) => one.message).join("\n")}>{words}</span>;
}

function Jobs() {
  const studio = useStudio();
  const running = studio.jobs.value.filter((job) => job.state === "running");
  return (
    <>
      {running.map((job) => (
        <div key={job.job} class="status-job">
          <span>{job.what}</span>
          <progress max={1} value={job.fraction} aria-label={job.what} />
          <button
            class="plain icon"
            aria-label={`Stop ${job.what}`}
            onClick={() => void studio.api.cancel(job.job).catch(() => undefined)}
          >
            <X />
          </button>
        </div>
      ))}
    </>
  );
}
