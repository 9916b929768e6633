// Every gesture of the session, the newest first; a click goes there, by undo and redo.
import { useSignal } from "@preact/signals";
import { Circle, CircleDot, Users } from "lucide-preact";
import { useStudio } from "./shell";

export function HistoryPanel() {
  const studio = useStudio();
  const { history, done } = studio.document.value;
  const going = useSignal(false);
  const goTo = async (count: number): Promise<void> => {
    if (going.value) return;
    going.value = true;
    const steps = count - studio.document.value.done;
    for (let i = 0; i < Math.abs(steps); ++i) {
      if (!(await (steps < 0 ? studio.undo() : studio.redo()))) break;
    }
    going.value = false;
  };
  if (history.length === 0) {
    return <p class="empty">Every stroke and every slider will be listed here, and a click takes you back to it.</p>;
  }
  const rows = history.map((gesture, i) => ({ ...gesture, count: i + 1 })).reverse();
  return (
    <ol class="history" aria-label="History, the newest first" aria-busy={going.value}>
      {rows.map(({ label, window, count }) => (
        <HistoryRow key={count} label={label} count={count} done={done} other={window !== studio.window} go={goTo} />
      ))}
      <HistoryRow label="As it was opened" count={0} done={done} other={false} go={goTo} />
    </ol>
  );
}

interface HistoryRowProps {
  label: string;
  count: number;
  done: number;
  other: boolean;
  go: (count: number) => Promise<void>;
}

function HistoryRow({ label, count, done, other, go }: HistoryRowProps) {
  const current = count === done;
  const [step, what] = splitLabel(label);
  return (
    <li>
      <button
        class={`plain history-row ${count > done ? "undone" : ""}`} aria-current={current ? "step" : undefined}
        onClick={() => void go(count)}
      >
        {current ? <CircleDot aria-hidden /> : <Circle aria-hidden class="faint" />}
        <span class="history-number muted">{count === 0 ? "" : count}</span>
        {step && <span class="history-step">{step}</span>}
        <span class="history-what">{what}</span>
        {other && <span class="history-other" title="Made in another window"><Users aria-hidden />another window</span>}
      </button>
    </li>
  );
}

/** "reef: subsidence 0.2 → 0.4" by its step and what was done. */
export function splitLabel(label: string): [string, string] {
  const found = /^([A-Za-z0-9_]+): (.+)$/s.exec(label);
  return found ? [found[1]!, found[2]!] : ["", label];
}
