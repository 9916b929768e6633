// The right panel: step cards above the selected step's parameters.
import { useRef } from "preact/hooks";
import { Divider } from "./divider";
import { stepsShare } from "./layout";
import { Parameters, Steps } from "./parts";
import { useStudio } from "./shell";

export function SidePanel() {
  const studio = useStudio();
  const panel = useRef<HTMLElement>(null);
  return (
    <aside class="side-panel" ref={panel} aria-label="Steps and parameters">
      <section class="side-part" aria-label="Steps" style={{ flexBasis: `${stepsShare.value * 100}%` }}>
        <Steps studio={studio} />
      </section>
      <Divider
        label="Height of the steps" upright={false} value={stepsShare.value} low={0.1} high={0.9} step={0.03}
        moved={(value) => (stepsShare.value = value)}
        dragged={(event) => {
          const box = panel.current!.getBoundingClientRect();
          stepsShare.value = Math.min(0.9, Math.max(0.1, (event.clientY - box.top) / box.height));
        }}
      />
      <section class="side-part rest" aria-label="Parameters"><Parameters studio={studio} /></section>
    </aside>
  );
}
