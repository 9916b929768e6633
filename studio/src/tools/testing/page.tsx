// A development page: the tools over the views, the steps and the recipe beside them. With a token in the address it
// works on the real server, else on the one in the page.
import { render } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { createClient, takeToken } from "../../api/client";
import type { Recipe } from "../../api/types";
import { openStudio } from "../../document/open_studio";
import type { Studio } from "../../document/studio";
import { Viewport } from "../../viewport/viewport";
import { listenToKeys } from "../../actions/registry";
import { toolKey, ToolOptions, ToolRail } from "..";
import { DrawingServer } from "./server";

const recipe: Recipe = {
  seamount: 1,
  domain: { width_m: 24000, height_m: 24000, cell_m: 60 },
  steps: [
    {
      id: "isle", op: "island.build",
      params: { areas: [[[-5000, -3000], [4000, -4000], [6000, 2000], [0, 5000], [-6000, 3000]]] },
    },
    {
      id: "wind", op: "island.wind", in: "isle",
      params: { strokes: [{ points: [[-9000, 2000], [0, 500], [8000, 3000]], width_m: 1200, strength_m: 700 }] },
    },
    { id: "reef", op: "island.coral", in: "wind" },
    {
      id: "sketch", op: "learned.sketch",
      params: {
        ridges: [{ points: [[-6000, -4500], [0, 700], [5500, 4700]] }], heights: [{ x_m: 0, y_m: 700, height_m: 1700 }],
      },
    },
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
  const map = useRef<HTMLDivElement>(null);
  const world = useRef<HTMLDivElement>(null);
  const [viewport, setViewport] = useState<Viewport | null>(null);
  useEffect(() => {
    const made = new Viewport(map.current!, world.current!, studio);
    Object.assign(window, { viewport: made });
    setViewport(made);
    return listenToKeys(document, (event) => toolKey(studio, event));
  }, []);
  const step = studio.step(studio.selected.value ?? "");
  return (
    <div
      style={{ display: "grid", gridTemplateColumns: "44px 1fr 300px", gridTemplateRows: "auto 1fr", height: "100%" }}
    >
      <div style={{ gridRow: "1 / 3" }}>
        <ToolRail studio={studio} viewport={viewport} />
      </div>
      <ToolOptions studio={studio} />
      <div style={{ gridRow: "1 / 3", gridColumn: 3, overflow: "auto", padding: "8px", background: "var(--panel)" }}>
        {studio.document.value.recipe.steps.map(({ id }) => (
          <button
            key={id}
            data-step={id}
            aria-pressed={studio.selected.value === id}
            onClick={() => (studio.selected.value = id)}
          >
            {id}
          </button>
        ))}
        <pre style={{ whiteSpace: "pre-wrap", fontSize: "11px" }}>{studio.message.value?.text}</pre>
        <pre style={{ whiteSpace: "pre-wrap", fontSize: "11px" }}>{JSON.stringify(step?.params ?? {}, null, 1)}</pre>
      </div>
      <div style={{ position: "relative", minHeight: 0 }}>
        <div ref={map} data-map="" style={{ position: "absolute", inset: 0 }} />
        <div
          ref={world}
          style={{ position: "absolute", right: "12px", bottom: "12px", width: "280px", height: "200px" }}
        />
      </div>
    </div>
  );
}

async function begin(): Promise<void> {
  const token = takeToken(location, history, sessionStorage);
  const studio = await openStudio(token ? createClient(token) : new DrawingServer(structuredClone(recipe)));
  Object.assign(window, { studio });
  studio.selected.value = studio.document.value.recipe.steps[0]?.id ?? null;
  render(<Page studio={studio} />, document.getElementById("app")!);
}

void begin();
