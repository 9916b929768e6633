// What is connected to what: the recipe's "in" with all its shorthand (docs/guide/recipes.md) as one map per step, and
// the same shorthand written where it says what is wanted.
import type { Edit, Json, OperatorInfo, PortInfo, Recipe, Source, Step } from "../../api/types";

export type Origin = { step: string; port: string } | { file: string };
/** By input port. */
export type Connections = ReadonlyMap<string, Origin>;
export type Operators = (name: string) => OperatorInfo | undefined;

const only = <T>(items: T[]): T | undefined => (items.length === 1 ? items[0] : undefined);

export function outputOf(producer: OperatorInfo, name: string): PortInfo | undefined {
  return producer.out.find((port) => port.name === name);
}

/** The output that a step's id alone means for an input: of the same name and kind, else the only one of its kind. */
export function meantOutput(producer: OperatorInfo, input: PortInfo): PortInfo | undefined {
  const same = outputOf(producer, input.name);
  return same?.kind === input.kind ? same : only(producer.out.filter((port) => port.kind === input.kind));
}

/** Inputs that "in": "step" connects: those for which there is an output of the same name and kind. */
export function meantConnections(consumer: OperatorInfo, producer: OperatorInfo): PortInfo[] {
  return consumer.in.filter((input) => outputOf(producer, input.name)?.kind === input.kind);
}

/** The input that "in": "step.port" is meant for. */
function meantInput(consumer: OperatorInfo, output: PortInfo): PortInfo | undefined {
  const fit = consumer.in.filter((input) => input.kind === output.kind);
  return fit.find((input) => input.name === output.name) ?? only(fit) ?? only(fit.filter((input) => input.required));
}

export function takesStepBefore(op: OperatorInfo): boolean {
  return op.needs_one === true || op.in.some((port) => port.required);
}

/** What a step without "in" reads of the step before it. */
export function connectedBefore(op: OperatorInfo, before: Step | undefined, operators: Operators): Connections {
  const found = new Map<string, Origin>();
  const producer = before && operators(before.op);
  if (!before || !producer || !takesStepBefore(op)) return found;
  for (const input of meantConnections(op, producer)) {
    if (op.needs_one === true && found.size > 0) break;
    found.set(input.name, { step: before.id, port: input.name });
  }
  return found;
}

function readSource(source: Source, input: PortInfo, recipe: Recipe, operators: Operators): Origin | undefined {
  if (typeof source !== "string") return { file: source.file };
  const [id = "", port] = source.split(".");
  const step = recipe.steps.find((candidate) => candidate.id === id);
  const producer = step && operators(step.op);
  if (!producer) return port === undefined ? undefined : { step: id, port };
  const meant = port ?? meantOutput(producer, input)?.name;
  return meant === undefined ? undefined : { step: id, port: meant };
}

function connectedWhole(op: OperatorInfo, text: string, recipe: Recipe, operators: Operators): Connections {
  const [id = "", port] = text.split(".");
  const step = recipe.steps.find((candidate) => candidate.id === id);
  const producer = step && operators(step.op);
  const found = new Map<string, Origin>();
  if (!producer) return found;
  if (port === undefined) {
    for (const input of meantConnections(op, producer)) found.set(input.name, { step: id, port: input.name });
    return found;
  }
  const output = outputOf(producer, port);
  const input = output && meantInput(op, output);
  if (input) found.set(input.name, { step: id, port });
  return found;
}

/** "in": ["one", "two"]: each step gives a row of inputs: "terrain", "terrain_2". */
function connectedRows(op: OperatorInfo, rows: string[], recipe: Recipe, operators: Operators): Connections {
  const found = new Map<string, Origin>();
  rows.forEach((id, row) => {
    const step = recipe.steps.find((candidate) => candidate.id === id);
    const producer = step && operators(step.op);
    for (const output of producer?.out ?? []) {
      const name = row === 0 ? output.name : `${output.name}_${row + 1}`;
      if (op.in.some((input) => input.name === name && input.kind === output.kind))
        found.set(name, { step: id, port: output.name });
    }
  });
  return found;
}

export function connectionsOf(recipe: Recipe, index: number, operators: Operators): Connections {
  const step = recipe.steps[index];
  const op = step && operators(step.op);
  if (!step || !op) return new Map();
  if (step.in === undefined) return connectedBefore(op, recipe.steps[index - 1], operators);
  if (typeof step.in === "string") return connectedWhole(op, step.in, recipe, operators);
  if (Array.isArray(step.in)) return connectedRows(op, step.in, recipe, operators);
  const found = new Map<string, Origin>();
  for (const [name, source] of Object.entries(step.in)) {
    const input = op.in.find((port) => port.name === name);
    const first = Array.isArray(source) ? source[0] : source;
    const origin = input && first !== undefined ? readSource(first, input, recipe, operators) : undefined;
    if (origin) found.set(name, origin);
  }
  return found;
}

/** Of every step, by its id. */
export function allConnections(recipe: Recipe, operators: Operators): ReadonlyMap<string, Connections> {
  return new Map(recipe.steps.map((step, index) => [step.id, connectionsOf(recipe, index, operators)]));
}

/** Steps that read from `id`, directly or through others; with `id` itself. */
export function downstream(id: string, all: ReadonlyMap<string, Connections>): ReadonlySet<string> {
  const reached = new Set([id]);
  for (let before = 0; before < reached.size; ) {
    before = reached.size;
    for (const [step, connections] of all) {
      for (const origin of connections.values()) if ("step" in origin && reached.has(origin.step)) reached.add(step);
    }
  }
  return reached;
}

export interface Offer {
  step: string;
  port: PortInfo;
}

/** Outputs that an input of `id` can read: of its kind, and of no step that depends on this one. */
export function offersFor(id: string, input: PortInfo, recipe: Recipe, operators: Operators): Offer[] {
  const after = downstream(id, allConnections(recipe, operators));
  return recipe.steps.filter((step) => !after.has(step.id)).flatMap((step) =>
    (operators(step.op)?.out ?? []).filter((port) => port.kind === input.kind)
      .map((port) => ({ step: step.id, port })));
}

export function sameOrigin(a: Origin | undefined, b: Origin | undefined): boolean {
  if (!a || !b) return a === b;
  if ("file" in a || "file" in b) return "file" in a && "file" in b && a.file === b.file;
  return a.step === b.step && a.port === b.port;
}

export function sameConnections(a: Connections, b: Connections): boolean {
  return a.size === b.size && [...a].every(([port, origin]) => sameOrigin(origin, b.get(port)));
}

/** "step" where that means the same, else "step.port". */
function writtenSource(origin: Origin, input: PortInfo, recipe: Recipe, operators: Operators): Source {
  if ("file" in origin) return { file: origin.file };
  const producer = recipe.steps.find((step) => step.id === origin.step);
  const op = producer && operators(producer.op);
  return op && meantOutput(op, input)?.name === origin.port ? origin.step : `${origin.step}.${origin.port}`;
}

/** "in" as briefly as it can be written for a step that comes after `before`; undefined: it is left out. */
export function writtenIn(op: OperatorInfo, wanted: Connections, before: Step | undefined, recipe: Recipe,
                          operators: Operators): Step["in"] {
  if (sameConnections(wanted, connectedBefore(op, before, operators))) return undefined;
  const steps = new Set([...wanted.values()].map((origin) => ("step" in origin ? origin.step : "")));
  const single = only([...steps]);
  if (single && sameConnections(wanted, connectedWhole(op, single, recipe, operators))) return single;
  const written: { [port: string]: Source } = {};
  for (const input of op.in) {
    const origin = wanted.get(input.name);
    if (origin) written[input.name] = writtenSource(origin, input, recipe, operators);
  }
  return written;
}

/** The edit that gives a step these connections, as they are written where it stands in `recipe`. */
export function inEdit(id: string, wanted: Connections, recipe: Recipe, operators: Operators): Edit {
  const at = recipe.steps.findIndex((step) => step.id === id);
  const op = operators(recipe.steps[at]?.op ?? "");
  const written = op && writtenIn(op, wanted, recipe.steps[at - 1], recipe, operators);
  const pointer = `/steps/${id}/in`;
  return written === undefined ? { do: "set", pointer } : { do: "set", pointer, value: written as Json };
}

/** Edits that connect inputs anew; null: an input is left open. What else the steps read stays. */
export function connectingEdits(changes: readonly { step: string; input: string; origin: Origin | null }[],
  recipe: Recipe,
                                operators: Operators): Edit[] {
  const wanted = new Map<string, Map<string, Origin>>();
  for (const { step, input, origin } of changes) {
    const at = recipe.steps.findIndex((candidate) => candidate.id === step);
    const connections = wanted.get(step) ?? new Map(connectionsOf(recipe, at, operators));
    if (origin) connections.set(input, origin);
    else connections.delete(input);
    wanted.set(step, connections);
  }
  return [...wanted].map(([step, connections]) => inEdit(step, connections, recipe, operators));
}
