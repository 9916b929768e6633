// The picture of a step on its card: of what is there already, nothing is computed for it. Pictures of results that are
// out of date stay, dimmed, until there is a new one.
import type { JSX } from "preact";
import { effect } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { Activity, Box, FileText, Image, Navigation, Route, Shapes, Trees, Waypoints } from "lucide-preact";
import type { OperatorInfo } from "../../api/types";
import type { Studio } from "../../document/studio";
import { pictureOf } from "./thumbnail_pixels";

const PICTURED = ["terrain", "image", "labels", "field"];

/** The output that a step's picture is of. */
export function picturedSource(id: string, op: OperatorInfo | undefined): { source: string; kind: string } | null {
  for (const kind of PICTURED) {
    const port = op?.out.find((candidate) => candidate.kind === kind);
    if (port) return { source: `${id}.${port.name}`, kind };
  }
  return null;
}

/** Which pictures are on the screen; of these, what is fresh is wanted. */
class Wanted {
  private readonly shown = new Map<string, number>();
  private asked = "";

  constructor(private readonly studio: Studio) {
    effect(() => {
      studio.engine.value;
      this.ask();
    });
  }

  show(source: string, by: 1 | -1): void {
    const count = (this.shown.get(source) ?? 0) + by;
    if (count > 0) this.shown.set(source, count);
    else this.shown.delete(source);
    this.ask();
  }

  private ask(): void {
    const fresh = new Set(this.studio.engine.peek().steps.filter((step) => step.standing === "fresh")
      .map((step) => step.id));
    const sources = [...this.shown.keys()].filter((source) => fresh.has(source.split(".")[0]!)).sort();
    const asked = sources.join("\n");
    if (asked === this.asked) return;
    this.asked = asked;
    this.studio.want("thumbnails", sources);
  }
}

const wantedBy = new WeakMap<Studio, Wanted>();
function wantedOf(studio: Studio): Wanted {
  let wanted = wantedBy.get(studio);
  if (!wanted) wantedBy.set(studio, (wanted = new Wanted(studio)));
  return wanted;
}

const OTHER: { readonly [kind: string]: () => JSX.Element } = {
  image: () => <Image />, current: () => <Navigation />, things: () => <Box />, objects: () => <Trees />,
    catalogue: () => <FileText />,
  drawing: () => <Route />, tin: () => <Waypoints />, contours: () => <Activity />,
};

const WIDTH = 128;
const HEIGHT = 80;
/** Pictures that are made again wait for the large views. */
const AFTER_VIEWS_ms = 150;

/** Draws the newest value of the source; false: there is none that can be drawn. */
async function draw(studio: Studio, source: string, kind: string, canvas: HTMLCanvasElement): Promise<boolean> {
  const value = studio.values.peek().get(source);
  const context = canvas.getContext("2d");
  if (!value || !context) return false;
  if (kind === "image") {
    const blob = await studio.api.picture(value.key);
    if (blob.size === 0) return false;
    const bitmap = await createImageBitmap(blob);
    const scale = Math.max(WIDTH / bitmap.width, HEIGHT / bitmap.height);
    context.drawImage(bitmap, (WIDTH - bitmap.width * scale) / 2, (HEIGHT - bitmap.height * scale) / 2,
      bitmap.width * scale, bitmap.height * scale);
    bitmap.close();
    return true;
  }
  if (!value.frame) return false;
  const level = Math.max(0, Math.floor(Math.log2(Math.min(value.frame.columns / WIDTH, value.frame.rows / HEIGHT))));
  const raster = await studio.raster(source, level);
  if (!raster) return false;
  context.putImageData(new ImageData(pictureOf(raster, kind, WIDTH, HEIGHT), WIDTH, HEIGHT), 0, 0);
  return true;
}

export function Thumbnail({ studio, id, op, stale }: { studio: Studio; id: string; op: OperatorInfo | undefined;
  stale: boolean }): JSX.Element {
  const pictured = picturedSource(id, op);
  const source = pictured?.source ?? "";
  const canvas = useRef<HTMLCanvasElement>(null);
  const [drawn, setDrawn] = useState("");
  const value = studio.values.value.get(source);
  // Coarse results come in a row while a pen draws: they are for the views.
  const key = value === undefined || (value.coarse && drawn !== "") ? "" : value.key;
  useEffect(() => {
    const element = canvas.current;
    if (!element || source === "") return;
    const wanted = wantedOf(studio);
    let shown = false;
    const observer = new IntersectionObserver((entries) => {
      const seen = entries[entries.length - 1]?.isIntersecting ?? false;
      if (seen !== shown) wanted.show(source, seen ? 1 : -1);
      shown = seen;
    });
    observer.observe(element);
    return () => {
      observer.disconnect();
      if (shown) wanted.show(source, -1);
    };
  }, [studio, source]);
  useEffect(() => {
    const element = canvas.current;
    if (!element || !pictured || key === "" || key === drawn) return;
    let current = true;
    const timer = setTimeout(() => {
      draw(studio, source, pictured.kind, element).then((done) => { if (done && current) setDrawn(key); },
        () => undefined);
    }, drawn === "" ? 0 : AFTER_VIEWS_ms);
    return () => {
      current = false;
      clearTimeout(timer);
    };
  }, [studio, source, key]);
  const Icon = OTHER[op?.out[0]?.kind ?? ""] ?? (() => <Shapes />);
  return (
    <span class={`thumbnail${stale ? " stale" : ""}`} aria-hidden="true">
      {pictured && <canvas ref={canvas} width={WIDTH} height={HEIGHT} class={drawn ? "" : "empty"} />}
      {(!pictured || !drawn) && <Icon />}
    </span>
  );
}
