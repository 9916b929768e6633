// The seed: of the document, or of a step that has one of its own. Dice give another.
import type { JSX } from "preact";
import { Dices, RotateCcw } from "lucide-preact";
import type { Studio } from "../../document/studio";
import { NumberField } from "./number_field";

const MOST = 999999;
const HELP = "Of everything random in this step; auto: it follows from the document's seed and the step's name";

interface SeedRowProps {
  studio: Studio;
  owner: string;
  pointer: string;
  seed: number | undefined;
  /** Of a step without one it follows from the document's and its id. */
  derived: boolean;
}

export function SeedRow({ studio, owner, pointer, seed, derived }: SeedRowProps): JSX.Element {
  const set = (value: number | undefined, gesture?: string) => {
    const label = `${owner}: seed ${seed ?? "auto"} → ${value ?? "auto"}`;
    void studio.edit([value === undefined ? { do: "set", pointer } : { do: "set", pointer, value }], label, gesture);
  };
  const reset = () => { if (seed !== undefined && derived) set(undefined); };
  return (
    <div class={`param${seed !== undefined && derived ? " changed" : ""}`}>
      <span class="param-title"
        data-help={derived ? HELP : "Of everything random"}>Seed</span>
      <div class="param-control seed">
        <NumberField label="Seed" value={seed ?? (derived ? null : 0)} unit="" min={0} integer
          quiet={seed === undefined}
          onChange={(value, gesture) => set(value, gesture)} onReset={reset} />
        <button type="button" class="plain icon" aria-label="Another seed"
          data-help="Roll the dice: another of its kind"
          onClick={() => set(1 + Math.floor(Math.random() * MOST))}><Dices /></button>
      </div>
      {seed !== undefined && derived ? <button type="button" class="plain icon small param-reset"
        aria-label="Reset seed" data-help="Back to auto" onClick={reset}><RotateCcw /></button>
        : <span class="param-reset" />}
    </div>
  );
}
