// Edits that put a step for a tool into the recipe: behind the selected one, where all that read it read the new step;
// before one of its inputs; or alone.
import type { Edit, Json, Output, Recipe, Schema, Source, Step } from "../api/types";
import { connectionsOf, meantOutput, operatorOf, stepOf, type Connection } from "../document/connections";
import type { Addition } from "./offers";
import { token } from "./place";

export function freshId(recipe: Recipe, op: string): string {
  const word = op.split(".").pop()!.replace(/[^A-Za-z0-9_-]/g, "_");
  const taken = new Set(recipe.steps.map((step) => step.id));
  for (let number = 1; ; ++number) {
    const id = number === 1 ? word : `${word}_${number}`;
    if (!taken.has(id)) return id;
  }
}

const sourceOf = (from: Connection["from"]): Source | null =>
  from === null ? null : "file" in from ? from : `${from.step}.${from.port}`;

/** All connected inputs, written out. */
function writtenOut(connections: readonly Connection[]): { [port: string]: Source } {
  const entries = connections.map(({ input, from }) => [input.name, sourceOf(from)] as const);
  return Object.fromEntries(entries.filter((entry): entry is [string, Source] => entry[1] !== null));
}

const same = (a: Connection[], b: Connection[]) => JSON.stringify(writtenOut(a)) === JSON.stringify(writtenOut(b));

/** What of `step` the new one passes on, and under which name: each of its inputs with an output of the same kind. */
function replacements(schema: Schema, step: Step, op: string): Map<string, string> {
  const [producer, added] = [operatorOf(schema, step.op)!, operatorOf(schema, op)!];
  const result = new Map<string, string>();
  for (const input of added.in) {
    const from = meantOutput(producer, input.name, input.kind);
    const to = added.out.find((port) => port.kind === input.kind && (port.name === input.name || input.required));
    if (from && to && (input.required || from.name === input.name)) result.set(from.name, to.name);
  }
  return result;
}

/** Edits that connect the readers of `step` to the new step, where it passes on what they read; and those that keep what
 * others read where shorthand ("the step before") would now mean another step. */
function reconnect(before: Recipe, after: Recipe, schema: Schema, step: string, id: string, ports: Map<string, string>): Edit[] {
  const edits: Edit[] = [];
  for (const reader of before.steps) {
    const wanted = connectionsOf(before, schema, reader).map(({ input, from }): Connection => {
      const port = from && "step" in from && from.step === step ? ports.get(from.port) : undefined;
      return { input, from: port === undefined ? from : { step: id, port } };
    });
    const now = connectionsOf(after, schema, stepOf(after, reader.id)!);
    if (same(wanted, now)) continue;
    const row = Array.isArray((reader.in as { [port: string]: Json } | undefined)?.["terrain"]);
    if (!row) edits.push({ do: "set", pointer: `/steps/${token(reader.id)}/in`, value: writtenOut(wanted) as Json });
  }
  (before.outputs ?? []).forEach((output: Output, i) => {
    for (const member of ["from", "labels"] as const) {
      const source = output[member];
      if (typeof source !== "string") continue;
      const [name, port] = source.split(".");
      const to = name !== step ? undefined : port === undefined ? (member === "from" ? "" : undefined) : ports.get(port);
      if (to === undefined || (to === "" && !ports.has("terrain"))) continue;
      edits.push({ do: "set", pointer: `/outputs/${i}/${member}`, value: to === "" ? id : `${id}.${to}` });
    }
  });
  return edits;
}

function inserted(recipe: Recipe, index: number, step: Step): Recipe {
  return { ...recipe, steps: [...recipe.steps.slice(0, index), step, ...recipe.steps.slice(index)] };
}

function behind(recipe: Recipe, schema: Schema, at: Step, step: Step): Edit[] {
  const index = recipe.steps.indexOf(at) + 1;
  const added = operatorOf(schema, step.op)!;
  const producer = operatorOf(schema, at.op)!;
  const inputs: { [port: string]: Source } = {};
  for (const input of added.in) {
    const from = producer.out.find((port) => port.name === input.name && port.kind === input.kind)
      ?? (input.required ? meantOutput(producer, input.name, input.kind) : undefined);
    if (from) inputs[input.name] = `${at.id}.${from.name}`;
  }
  const whole: Step = { ...step, in: inputs };
  const after = inserted(recipe, index, whole);
  const ports = replacements(schema, at, step.op);
  return [
    { do: "insert", list: "/steps", index, value: whole as unknown as Json },
    ...reconnect(recipe, after, schema, at.id, step.id, ports),
  ];
}

/** The terrain that a step is about, to give what is painted for it the same frame. */
function groundOf(recipe: Recipe, schema: Schema, step: Step): Source | null {
  const ground = connectionsOf(recipe, schema, step).find(({ input, from }) => input.kind === "terrain" && from);
  return ground ? sourceOf(ground.from) : null;
}

function before(recipe: Recipe, schema: Schema, at: Step, port: string, step: Step): Edit[] {
  const index = recipe.steps.indexOf(at);
  const added = operatorOf(schema, step.op)!;
  const connections = connectionsOf(recipe, schema, at);
  const target = connections.find(({ input }) => input.name === port)!;
  const inputs: { [port: string]: Source } = {};
  const passed = added.in.find((input) => input.kind === target.input.kind);
  const held = sourceOf(target.from);
  if (passed && held !== null) inputs[passed.name] = held;
  const ground = added.in.some((input) => input.name === "terrain") ? groundOf(recipe, schema, at) : null;
  if (ground !== null) inputs["terrain"] = ground;
  const out = added.out.find((output) => output.kind === target.input.kind)!;
  const whole: Step = { ...step, in: inputs };
  const wired = { ...writtenOut(connections), [port]: `${step.id}.${out.name}` };
  return [
    { do: "insert", list: "/steps", index, value: whole as unknown as Json },
    { do: "set", pointer: `/steps/${token(at.id)}/in`, value: wired as Json },
  ];
}

/** Outputs that say no source are of the last step: what that is must be written before another one follows. */
function keptOutputs(recipe: Recipe): Edit[] {
  const last = recipe.steps[recipe.steps.length - 1];
  return (recipe.outputs ?? []).flatMap((output, i): Edit[] =>
    output.from !== undefined || !last ? [] : [{ do: "set", pointer: `/outputs/${i}/from`, value: last.id }]);
}

/** What is painted for an input is where nobody has painted: nothing is known, or all is alike. */
const kUnpainted: { [input: string]: { [name: string]: Json } } = { levelset: { unknown: true }, probability: { base: 0.5 } };

/** Edits that add the step with these parameters. */
export function addStep(recipe: Recipe, schema: Schema, adds: Addition, id: string, params: { [name: string]: Json }): Edit[] {
  const ground = adds.op === "terrain.paint" ? kUnpainted[adds.input ?? ""] ?? {} : {};
  const step: Step = { id, op: adds.op, params: { ...ground, ...params } };
  const at = adds.at === undefined ? undefined : stepOf(recipe, adds.at);
  if (!at || adds.where === "alone") return [...keptOutputs(recipe), { do: "insert", list: "/steps", value: step as unknown as Json }];
  return adds.where === "behind" ? behind(recipe, schema, at, step) : before(recipe, schema, at, adds.input!, step);
}
