// The panel under the views: graph, recipe text, history or timeline.
import { X } from "lucide-preact";
import { lazy } from "./lazy";
import { Divider } from "./divider";
import { HistoryPanel } from "./history_panel";
import { dockHeight, dockOpen, dockTab } from "./layout";
import type { DockTab } from "./layout";
import { Graph, Timeline } from "./parts";
import { useStudio } from "./shell";

const TextPane = lazy(() => import("./text_pane").then((module) => module.TextPane));

const kTitles: { [tab in DockTab]: string } = {
  graph: "Graph", text: "Recipe", history: "History", timeline: "Timeline",
};

export function Dock() {
  const studio = useStudio();
  if (!dockOpen.value) return null;
  const tab = dockTab.value;
  const most = Math.max(160, innerHeight - 260);
  const height = Math.min(dockHeight.value, most);
  return (
    <section class="dock" aria-label={kTitles[tab]} style={{ height: `${height}px` }}>
      <Divider
        label="Height of the panel"
        upright={false}
        value={height}
        low={120}
        high={most}
        step={-16}
        moved={(value) => (dockHeight.value = value)}
        dragged={(event) => (dockHeight.value = Math.min(most, Math.max(120, innerHeight - 24 - event.clientY)))}
      />
      <div class="dock-tabs" role="tablist" aria-label="Panels" onKeyDown={chooseByArrows}>
        {(Object.keys(kTitles) as DockTab[]).map((name) => (
          <button
            key={name}
            role="tab"
            class="plain"
            aria-selected={name === tab}
            tabIndex={name === tab ? 0 : -1}
            onClick={() => (dockTab.value = name)}
          >
            {kTitles[name]}
          </button>
        ))}
        <div class="bar-space" />
        <button
          class="plain icon"
          aria-label="Close the panel"
          title="Close the panel"
          onClick={() => (dockOpen.value = false)}
        >
          <X />
        </button>
      </div>
      <div class="dock-content" role="tabpanel" aria-label={kTitles[tab]}>
        {tab === "graph" && <Graph studio={studio} />}
        {tab === "timeline" && <Timeline studio={studio} />}
        {tab === "history" && <HistoryPanel />}
        {tab === "text" && <TextPane />}
      </div>
    </section>
  );
}

function chooseByArrows(event: KeyboardEvent): void {
  const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (by === 0) return;
  const tabs = Object.keys(kTitles) as DockTab[];
  dockTab.value = tabs[(tabs.indexOf(dockTab.value) + by + tabs.length) % tabs.length]!;
  const list = event.currentTarget as HTMLElement;
  requestAnimationFrame(() => list.querySelector<HTMLElement>("[aria-selected=true]")?.focus());
}
