// Edits that put a step into the graph: which of its inputs are connected, how that is written most briefly, and what
// has to be written out so that nothing else changes.
import type { Edit, Json, OperatorInfo, PortInfo, Recipe, Step } from "../../api/types";
import { type Connections, type Operators, type Origin, connectedBefore, connectionsOf, meantConnections, outputOf,
         inEdit, sameConnections, writtenIn } from "./connections";

export interface Insertion {
  id: string;
  edits: Edit[];
}

/** Last parts of operators' names that do not say what is made. */
const VERBS = new Set(["build", "run", "grow", "import"]);

/** An id that no step has, from the operator's name: "coral", "coral_2", "erosion". */
export function freeId(wanted: string, recipe: Recipe): string {
  const taken = new Set(recipe.steps.map((step) => step.id));
  const [family = "", name = family] = wanted.split(".");
  const base = (VERBS.has(name) ? family : name).replace(/[^A-Za-z0-9_-]/g, "_").slice(0, 60) || "step";
  if (!taken.has(base)) return base;
  for (let number = 2; ; ++number) if (!taken.has(`${base}_${number}`)) return `${base}_${number}`;
}

/** Of `producer` first what has the input's name and kind; for required inputs also what only is of its kind. */
function fitting(producer: OperatorInfo, input: PortInfo): PortInfo | undefined {
  const same = outputOf(producer, input.name);
  if (same?.kind === input.kind) return same;
  return input.required ? producer.out.find((port) => port.kind === input.kind) : undefined;
}

/** What a new step after the steps up to `index` reads: of the one that it follows what fits, and for required inputs
 * that are still open, of the nearest before that makes what is needed. */
export function connectedNew(op: OperatorInfo, recipe: Recipe, index: number, operators: Operators): Connections {
  const found = new Map<string, Origin>();
  const earlier = recipe.steps.slice(0, index).reverse();
  const first = earlier[0] && operators(earlier[0].op);
  const begins = !op.in.some((port) => port.required);
  if (earlier[0] && first && !begins) {
    for (const input of op.in) {
      const port = fitting(first, input);
      if (port) found.set(input.name, { step: earlier[0].id, port: port.name });
    }
  } else if (earlier[0] && first) {
    const input = bestOptional(op, first);
    if (input) for (const [name, origin] of input(earlier[0].id)) found.set(name, origin);
  }
  for (const input of op.in) {
    if (!input.required || found.has(input.name)) continue;
    for (const step of earlier) {
      const producer = operators(step.op);
      const port = producer && fitting(producer, input);
      if (!port) continue;
      found.set(input.name, { step: step.id, port: port.name });
      break;
    }
  }
  return found;
}

/** Of an operator that needs no input: what it takes of a step that makes it by the same name ("contours"). Operators
 * that make what they would take (terrain.noise) begin anew. */
function bestOptional(op: OperatorInfo, producer: OperatorInfo): ((id: string) => [string, Origin][]) | null {
  const meant = meantConnections(op, producer).filter((input) => input.kind !== "field" && input.kind !== "report");
  if (meant.length === 0) return null;
  return (id) => meant.map((input) => [input.name, { step: id, port: input.name }]);
}

/** Steps and outputs at `index` that read "the step before" or "the last step" and would read something else: their
 * connections written out. */
function keepers(recipe: Recipe, index: number, inserted: OperatorInfo, follow: boolean, id: string,
                 operators: Operators): Edit[] {
  const edits: Edit[] = [];
  const next = recipe.steps[index];
  const nextOp = next && operators(next.op);
  if (next && nextOp && next.in === undefined) {
    const before = connectionsOf(recipe, index, operators);
    const after = connectedBefore(nextOp, { id, op: inserted.name }, (name) => operators(name));
    const keeps = follow && before.size > 0 && [...before.keys()].every((port) => after.has(port));
    if (!keeps && before.size + after.size > 0)
      edits.push({ do: "set", pointer: `/steps/${next.id}/in`, value: writtenOut(nextOp, before, recipe, operators) });
  }
  const last = recipe.steps[recipe.steps.length - 1];
  if (index !== recipe.steps.length || !last) return edits;
  const lastKind = operators(last.op)?.out[0]?.kind;
  (recipe.outputs ?? []).forEach((output, i) => {
    if (output.from !== undefined || (follow && inserted.out.some((port) => port.kind === lastKind))) return;
    edits.push({ do: "set", pointer: `/outputs/${i}/from`, value: last.id });
  });
  return edits;
}

function writtenOut(op: OperatorInfo, wanted: Connections, recipe: Recipe, operators: Operators): Json {
  return (writtenIn(op, wanted, undefined, recipe, operators) ?? {}) as Json;
}

/** A new step of an operator after the step `after` (null: at the end); `wanted` instead of what fits by itself. */
export function insertStep(op: OperatorInfo, after: string | null, recipe: Recipe, operators: Operators,
                           wanted?: Connections): Insertion {
  const at = after === null ? -1 : recipe.steps.findIndex((step) => step.id === after);
  const index = at === -1 ? recipe.steps.length : at + 1;
  const id = freeId(op.name, recipe);
  const connections = wanted ?? connectedNew(op, recipe, index, operators);
  const step: Step = { id, op: op.name };
  const written = writtenIn(op, connections, recipe.steps[index - 1], recipe, operators);
  if (written !== undefined) step.in = written;
  const edits = keepers(recipe, index, op, true, id, operators);
  edits.push({ do: "insert", list: "/steps", index, value: step as unknown as Json });
  return { id, edits };
}

/** A step put into one wire: it reads what the wire carried, and the wire's end reads it. Null: it does not fit. */
export function insertIntoWire(op: OperatorInfo, origin: { step: string; port: string }, to: string, input: PortInfo,
                               recipe: Recipe, operators: Operators): Insertion | null {
  const taken = op.in.find((port) => port.name === input.name && port.kind === input.kind)
    ?? op.in.find((port) => port.kind === input.kind && port.required)
      ?? op.in.find((port) => port.kind === input.kind);
  const made = op.out.find((port) => port.name === input.name && port.kind === input.kind)
    ?? op.out.find((port) => port.kind === input.kind);
  if (!taken || !made) return null;
  const index = recipe.steps.findIndex((step) => step.id === origin.step) + 1;
  const connections = new Map(connectedNew(op, recipe, index, operators));
  connections.set(taken.name, origin);
  const insertion = insertStep(op, origin.step, recipe, operators, connections);
  insertion.edits.push(readNew(insertion, op, made.name, to, input.name, index, recipe, operators));
  return insertion;
}

/** The edit that lets an input read a step that is just put in at `index`. */
export function readNew(insertion: Insertion, op: OperatorInfo, output: string, to: string, input: string,
  index: number, recipe: Recipe,
                        operators: Operators): Edit {
  const steps = [...recipe.steps.slice(0, index), { id: insertion.id, op: op.name }, ...recipe.steps.slice(index)];
  const wanted = new Map(connectionsOf(recipe, recipe.steps.findIndex((step) => step.id === to), operators));
  wanted.set(input, { step: insertion.id, port: output });
  return inEdit(to, wanted, { ...recipe, steps }, operators);
}

/** A copy of a step right after it, which reads the same; what read the original still does. */
export function duplicateStep(id: string, recipe: Recipe, operators: Operators): Insertion | null {
  const at = recipe.steps.findIndex((step) => step.id === id);
  const original = recipe.steps[at];
  const op = original && operators(original.op);
  if (!original || !op) return null;
  const copy: Step = { ...structuredClone(original), id: freeId(id.replace(/_\d+$/, ""), recipe) };
  const wanted = connectionsOf(recipe, at, operators);
  const written = writtenIn(op, wanted, original, recipe, operators);
  if (original.in === undefined) {
    delete copy.in;
    if (written !== undefined && !sameConnections(wanted, new Map())) copy.in = written;
    else if (wanted.size === 0 && connectedBefore(op, original, operators).size > 0) copy.in = {};
  }
  const edits = keepers(recipe, at + 1, op, false, copy.id, operators);
  edits.push({ do: "insert", list: "/steps", index: at + 1, value: copy as unknown as Json });
  return { id: copy.id, edits };
}

export type Fit = "follows" | "upstream" | "begins" | "other";

/** How an operator stands to the selected one: it takes of its outputs what it needs; of all steps' outputs (kinds
 * `made`) it can be given that; it needs nothing; or none of these. */
export function fitAfter(op: OperatorInfo, selected: OperatorInfo | undefined,
  made: ReadonlySet<string> = new Set()): Fit {
  const takes = selected && op.in.some((input) =>
    selected.out.some((port) => port.kind === input.kind && (input.required || port.name === input.name)));
  const required = op.in.filter((input) => input.required);
  if (takes && required.every((input) => selected.out.some((port) => port.kind === input.kind))) return "follows";
  if (required.length === 0) return "begins";
  return required.every((input) => made.has(input.kind)) ? "upstream" : "other";
}
