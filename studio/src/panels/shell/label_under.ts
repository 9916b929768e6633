// The region under a place: from the labels that come with the shown terrain, coarsely, as nobody points finer.
import { effect, signal } from "@preact/signals";
import type { Studio } from "../../document/studio";
import type { Raster } from "../../viewport/types";

const kLevel = 1;
export const kLabels = ["mountain", "beach", "lagoon", "reef", "abyss"];

const labels = signal<Raster | null>(null);

/** The name of the label at a place; null beside the raster and where nothing is labelled. */
export function labelAt(raster: Raster, x: number, y: number): string | null {
  const { west, north, cell_m, columns, rows } = raster.frame;
  const column = Math.floor((x - west) / cell_m), row = Math.floor((north - y) / cell_m);
  if (column < 0 || row < 0 || column >= columns || row >= rows) return null;
  return kLabels[raster.values[row * columns + column]!] ?? null;
}

export function labelUnder(x: number, y: number): string | null {
  return labels.value && labelAt(labels.value, x, y);
}

/** The labels that the step of a terrain makes beside it. */
function labelsBeside(studio: Studio, terrain: string | null): string | null {
  const id = terrain?.split(".")[0] ?? "";
  const step = studio.step(id);
  const port = step && studio.operator(step.op)?.out.find((one) => one.kind === "labels");
  return port ? `${id}.${port.name}` : null;
}

/** Keeps the labels of what is shown until the returned function is called. */
export function followLabels(studio: Studio): () => void {
  let newest = "";
  const ends = [
    effect(() => {
      const source = labelsBeside(studio, studio.shown.value.terrain);
      studio.want("labels under the pointer", source === null ? [] : [source]);
      const key = source === null ? "" : studio.values.value.get(source)?.key ?? "";
      if (key === newest) return;
      newest = key;
      if (source === null || key === "") {
        labels.value = null;
        return;
      }
      void studio.raster(source, kLevel).then((raster) => {
        if (newest === key) labels.value = raster;
      });
    }),
  ];
  return () => {
    for (const end of ends) end();
    studio.want("labels under the pointer", []);
  };
}
