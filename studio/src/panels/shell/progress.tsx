// What the engine is at, once it has been at it for a while: which step, how far, how long still, and a way to stop it.
import { useSignal } from "@preact/signals";
import { X } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import type { EngineState } from "../../api/types";
import { Estimate } from "./estimate";
import { useStudio } from "./shell";
import { durationText } from "./words";

/** What takes less is not worth a movement on the screen. */
const kPatience_ms = 700;

function runningStep(engine: EngineState): string | null {
  const running = engine.steps.filter((step) => step.standing === "running");
  return running.length === 1 ? running[0]!.id : running.length > 1 ? `${running.length} steps` : null;
}

export function Progress() {
  const studio = useStudio();
  const engine = studio.engine.value;
  const patient = useSignal(true);
  const estimate = useRef(new Estimate());
  const working = !engine.settled;
  useEffect(() => {
    patient.value = true;
    if (!working) return;
    estimate.current = new Estimate();
    const timer = setTimeout(() => (patient.value = false), kPatience_ms);
    return () => clearTimeout(timer);
  }, [working]);
  if (!working || patient.value) return null;
  const left = estimate.current.left_s(engine.fraction, performance.now());
  const step = runningStep(engine);
  const percent = Math.round(engine.fraction * 100);
  return (
    <div class="engine-progress">
      <span class="progress-text">
        {step ?? "Working"}
        {left !== null && left >= 2 && <span class="muted"> {durationText(left)} left</span>}
      </span>
      <progress max={100} value={percent} aria-label="Computing" />
      <span class="progress-percent muted">{percent} %</span>
      <button class="plain icon" aria-label="Stop computing" title="Stop computing until the next change"
        onClick={() => void studio.api.cancel().catch(() => undefined)}>
        <X />
      </button>
    </div>
  );
}
