// How far a step's result is, as a sign and in words.
import type { JSX } from "preact";
import { CircleAlert, CircleCheck, CircleDashed, CircleSlash, CircleX, Clock, History,
  LoaderCircle } from "lucide-preact";
import type { Standing, StepState } from "../../api/types";
import { secondsText } from "../params/words";

const WORDS: { readonly [standing in Standing]: string } = {
  fresh: "done", stale: "out of date", queued: "waiting", running: "running", failed: "failed",
    blocked: "waits for a failed step",
  incomplete: "an input is open", bypassed: "left out",
};

export function standingText(state: StepState | undefined): string {
  if (!state) return "not yet computed";
  if (state.standing === "running") return state.fraction > 0 ? `running, ${Math.round(100 * state.fraction)} %`
    : "running";
  if (state.standing === "fresh") {
    const time = secondsText(state.seconds);
    return state.cached ? "done, kept" : time ? time : "done";
  }
  return WORDS[state.standing];
}

function Sign({ standing }: { standing: Standing | undefined }): JSX.Element {
  switch (standing) {
    case "fresh": return <CircleCheck />;
    case "stale": return <History />;
    case "queued": return <Clock />;
    case "running": return <LoaderCircle class="turning" />;
    case "failed": return <CircleX />;
    case "blocked": return <CircleAlert />;
    case "incomplete": return <CircleDashed />;
    case "bypassed": return <CircleSlash />;
    default: return <CircleDashed />;
  }
}

/** `brief`: the sign alone; the words are read out. */
export function StandingSign({ state, brief = false }: { state: StepState | undefined; brief?: boolean }): JSX.Element {
  const text = standingText(state);
  return (
    <span class={`standing ${state?.standing ?? "stale"}`} data-help={state?.message || undefined}>
      <Sign standing={state?.standing} /><span class={brief ? "unseen" : "standing-text"}>{text}</span>
    </span>
  );
}

export function Progress({ state }: { state: StepState | undefined }): JSX.Element | null {
  if (state?.standing !== "running") return null;
  return <span class="progress" role="progressbar" aria-label={`${state.id} is computed`}
    aria-valuenow={Math.round(100 * state.fraction)} aria-valuemin={0} aria-valuemax={100}>
    <span style={{ width: `${Math.max(3, 100 * state.fraction)}%` }} /></span>;
}
