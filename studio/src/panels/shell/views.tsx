// The 3D view and the map: side by side, one in the other's corner, or one alone.
import { ArrowLeftRight } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { ClassLegend } from "./class_legend";
import { Divider } from "./divider";
import { arrangement, bigView, splitShare, swapViews } from "./layout";
import { EmptyView } from "./empty_view";
import { PictureView } from "./picture_view";
import { startViews } from "./parts";
import { useStudio } from "./shell";

function placeOf(view: "map" | "world"): string {
  if (arrangement.value === "split") return "half";
  if (view === bigView.value) return "whole";
  return arrangement.value === "inset" ? "inset" : "away";
}

export function Views() {
  const studio = useStudio();
  const area = useRef<HTMLDivElement>(null);
  const map = useRef<HTMLDivElement>(null);
  const world = useRef<HTMLDivElement>(null);
  useEffect(() => startViews(map.current!, world.current!, studio), [studio]);
  const small = bigView.value === "map" ? "3D view" : "map";
  const split = arrangement.value === "split";
  const share = `${Math.round(splitShare.value * 1000) / 10}%`;
  return (
    <div class={`views ${arrangement.value}`} ref={area} data-views style={{ "--split": share }}>
      <section class={`view ${placeOf("world")}`} aria-label="3D view" ref={world} />
      {split && (
        <Divider
          label="Width of the 3D view" upright value={splitShare.value} low={0.15} high={0.85} step={0.02}
          moved={(value) => (splitShare.value = value)}
          dragged={(event) => {
            const box = area.current!.getBoundingClientRect();
            splitShare.value = Math.min(0.85, Math.max(0.15, (event.clientX - box.left) / box.width));
          }}
        />
      )}
      <section class={`view ${placeOf("map")}`} aria-label="Map" ref={map}><ClassLegend /></section>
      <EmptyView />
      <PictureView />
      {arrangement.value === "inset" && (
        <button class="inset-swap icon" aria-label={`Make the ${small} big`} title={`Make the ${small} big (V)`} onClick={swapViews}>
          <ArrowLeftRight aria-hidden />
        </button>
      )}
    </div>
  );
}
