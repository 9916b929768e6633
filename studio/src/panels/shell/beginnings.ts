// Documents that begin with a pen in the hand.
import type { Json, Step } from "../../api/types";
import type { OpenedStudio } from "../../document/open_studio";
import { openDocument } from "./files";
import { bigView } from "./layout";
import { askToDraw } from "./parts";
import { showToast } from "./toasts";

interface Beginning {
  width_m: number;
  cell_m: number;
  step: Step;
  /** The parameter that is drawn first. */
  draw: string;
  hint: string;
}

async function begin(studio: OpenedStudio, { width_m, cell_m, step, draw, hint }: Beginning): Promise<void> {
  const param = studio.operator(step.op)?.params.find((one) => one.name === draw);
  if (!param) {
    showToast({ kind: "error", text: `This studio has no ${step.op} to begin with` });
    return;
  }
  if (!(await openDocument(studio, { blank: true, width_m, height_m: width_m, cell_m }))) return;
  if (
    !(await studio.edit([{ do: "insert", list: "/steps", value: step as unknown as Json }], `${step.id}: added`))
  ) return;
  studio.selected.value = step.id;
  bigView.value = "map";
  askToDraw(studio, step.id, param);
  showToast({ kind: "note", text: hint });
}

export function beginCoast(studio: OpenedStudio): Promise<void> {
  return begin(studio, {
    width_m: 16_000, cell_m: 32, step: { id: "isle", op: "island.build" }, draw: "areas",
    hint: "Draw the coast on the map: one stroke around the island",
  });
}

export function beginStrokes(studio: OpenedStudio): Promise<void> {
  return begin(studio, {
    width_m: 20_000, cell_m: 40, step: { id: "range", op: "learned.sketch" }, draw: "ridges",
    hint: "Draw ridges on the map: the mountains follow",
  });
}
