// A development page: the tools over a plain map, the recipe beside it.
import { render } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Recipe } from "../../api/types";
import { openStudio } from "../../document/open_studio";
import type { Studio } from "../../document/studio";
import { toolKey, ToolOptions, ToolRail } from "..";
import { DrawingServer } from "./server";
import { SvgMap } from "./svg_map";

const recipe: Recipe = {
  seamount: 1,
  domain: { width_m: 24000, height_m: 24000, cell_m: 60 },
  steps: [
    { id: "isle", op: "island.build", params: { areas: [[[-5000, -3000], [4000, -4000], [6000, 2000], [0, 5000], [-6000, 3000]]] } },
    { id: "wind", op: "island.wind", in: "isle", params: { strokes: [{ points: [[-9000, 2000], [0, 500], [8000, 3000]], width_m: 1200, strength_m: 700 }] } },
    { id: "reef", op: "island.coral", in: "wind" },
    { id: "sketch", op: "learned.sketch", params: { ridges: [{ points: [[-6000, -4500], [0, 700], [5500, 4700]] }], heights: [{ x_m: 0, y_m: 700, height_m: 1700 }] } },
    { id: "grown", op: "contour.grow" },
    { id: "lines", op: "contour.extract", in: "grown" },
    { id: "edited", op: "contour.edit", in: "lines" },
    { id: "life", op: "ecosystem.grow", in: { terrain: "reef.terrain" } },
    { id: "shaped", op: "terrain.sculpt", in: { terrain: "reef.terrain" } },
    { id: "painted", op: "classify.paint", in: { labels: "reef.labels" } },
    { id: "mask", op: "terrain.mask", in: { terrain: "reef.terrain" } },
  ],
};

function Page({ studio }: { studio: Studio }) {
  const place = useRef<HTMLDivElement>(null);
  const [map, setMap] = useState<SvgMap | null>(null);
  useEffect(() => setMap(new SvgMap(place.current!, 24000)), []);
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (event.target instanceof HTMLInputElement && event.target.type === "text") return;
      if (toolKey(studio, event)) event.preventDefault();
    };
    document.addEventListener("keydown", press);
    return () => document.removeEventListener("keydown", press);
  }, []);
  const step = studio.step(studio.selected.value ?? "");
  return (
    <div style={{ display: "grid", gridTemplateColumns: "44px 1fr 320px", gridTemplateRows: "auto 1fr", height: "100%" }}>
      <div style={{ gridRow: "1 / 3" }}><ToolRail studio={studio} viewport={map} /></div>
      <ToolOptions studio={studio} />
      <div style={{ gridRow: "1 / 3", gridColumn: 3, overflow: "auto", padding: "8px", background: "var(--panel)" }}>
        {recipe.steps.map((one) => one.id).concat(studio.document.value.recipe.steps.filter((s) => !recipe.steps.some((r) => r.id === s.id)).map((s) => s.id)).map((id) => (
          <button key={id} data-step={id} aria-pressed={studio.selected.value === id} onClick={() => (studio.selected.value = id)}>{id}</button>
        ))}
        <pre style={{ whiteSpace: "pre-wrap", fontSize: "11px" }}>{JSON.stringify(step?.params ?? {}, null, 1)}</pre>
      </div>
      <div ref={place} style={{ minHeight: 0, background: "radial-gradient(circle, #4a5a45 0 18%, #2b4d5c 40%, #1a2d38 70%)" }} />
    </div>
  );
}

const studio = await openStudio(new DrawingServer(structuredClone(recipe)));
Object.assign(window, { studio });
studio.selected.value = "isle";
render(<Page studio={studio} />, document.getElementById("app")!);
