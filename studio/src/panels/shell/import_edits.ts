// What becomes of a file that was put into the window: the edits that its kind and the document suggest.
import type { Edit, Json, Recipe, Schema } from "../../api/types";
import { connectionsOf, operatorOf, stepOf } from "../../document/connections";
import { baseName, freeId } from "./words";

export interface ImportPlan {
  edits: Edit[];
  label: string;
  /** Step to look at afterwards. */
  select: string;
  /** What was done, in words. */
  told: string;
}

/** The first input of the selected step that is open and takes the kind. */
function openInput(
  schema: Schema, recipe: Recipe, selected: string | null, kind: string,
): { step: string; port: string } | null {
  const step = selected === null ? undefined : stepOf(recipe, selected);
  if (!step) return null;
  const open = connectionsOf(recipe, schema, step).find(({ input, from }) => from === null && input.kind === kind);
  return open ? { step: step.id, port: open.input.name } : null;
}

/** A step that begins with the file: at the top, where it changes nothing of what follows. */
function beginning(
  recipe: Recipe, wanted: string, op: string, more: { [member: string]: Json }, file: string,
): ImportPlan {
  const id = freeId(wanted, recipe.steps.map((step) => step.id));
  return {
    edits: [{ do: "insert", list: "/steps", index: 0, value: { id, op, ...more } }],
    label: `${id}: ${baseName(file)} imported`,
    select: id,
    told: `${baseName(file)} is the step ${id}`,
  };
}

/** Null: nothing in the studio begins with such a file. */
export function importPlan(
  schema: Schema, recipe: Recipe, selected: string | null, file: string, kind: string,
): ImportPlan | null {
  const has = (op: string): boolean => operatorOf(schema, op) !== undefined;
  const input = kind === "terrain" ? null : openInput(schema, recipe, selected, kind);
  if (input) {
    return {
      edits: [{ do: "set", pointer: `/steps/${input.step}/in/${input.port}`, value: { file } }],
      label: `${input.step}: ${input.port} from ${baseName(file)}`,
      select: input.step,
      told: `${baseName(file)} is the ${input.port} of ${input.step}`,
    };
  }
  const wanted = baseName(file).replace(/\.[^.]*$/, "").replace(/^[0-9a-f]{16,}[-_.]?/, "") || kind;
  if (kind === "drawing" && recipe.steps.length === 0 && has("island.build")) {
    return beginning(recipe, "isle", "island.build", { params: { coast: file } }, file);
  }
  if (kind === "labels" && has("island.build")) return beginning(
    recipe, wanted, "island.build", { in: { labels: { file } } }, file,
  );
  if (has(`${kind}.import`)) return beginning(recipe, wanted, `${kind}.import`, { params: { file } }, file);
  const importer = schema.operators.find((operator) => (
    operator.name.endsWith(".import") && operator.out.some((port) => port.kind === kind)
    && operator.params.some((param) => param.name === "file")
  ));
  return importer ? beginning(recipe, wanted, importer.name, { params: { file } }, file) : null;
}
