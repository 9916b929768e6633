// What each input of a step is connected to, with the recipe's shorthand written out: as src/seamount/recipe/shorthand.h.
import type { Json, OperatorInfo, PortInfo, Recipe, Schema, Step } from "../api/types";
import { isObject } from "./pointer";

export interface Connection {
  input: PortInfo;
  /** Null: open, or what stands there is no source. */
  from: { step: string; port: string } | { file: string } | null;
}

export function operatorOf(schema: Schema, op: string): OperatorInfo | undefined {
  return schema.operators.find((operator) => operator.name === op);
}

export function stepOf(recipe: Recipe, id: string): Step | undefined {
  return recipe.steps.find((step) => step.id === id);
}

/** The only one that fits; undefined for none and for several. */
function onlyOne<T>(items: readonly T[], fits: (item: T) => boolean): T | undefined {
  const found = items.filter(fits);
  return found.length === 1 ? found[0] : undefined;
}

/** The output that is meant for an input of this name and kind. */
export function meantOutput(producer: OperatorInfo, input: string, kind: string): PortInfo | undefined {
  const same = producer.out.find((port) => port.name === input && port.kind === kind);
  return same ?? onlyOne(producer.out, (port) => port.kind === kind);
}

/** The input that an output is meant for: that of its name and kind, the only one of the kind, or the only required. */
export function meantInput(consumer: OperatorInfo, output: PortInfo): PortInfo | undefined {
  const same = consumer.in.find((port) => port.name === output.name && port.kind === output.kind);
  const only = same ?? onlyOne(consumer.in, (port) => port.kind === output.kind);
  return only ?? onlyOne(consumer.in, (port) => port.kind === output.kind && port.required);
}

class Reader {
  constructor(private recipe: Recipe, private schema: Schema, private consumer: OperatorInfo) {}

  private producer(id: string): OperatorInfo | undefined {
    const step = stepOf(this.recipe, id);
    return step && operatorOf(this.schema, step.op);
  }

  /** A source as it stands at an input: "step.port", "step", {file}. */
  source(input: PortInfo, source: Json | undefined): Connection["from"] {
    if (isObject(source) && typeof source["file"] === "string") return { file: source["file"] };
    if (typeof source !== "string") return null;
    const dot = source.indexOf(".");
    if (dot >= 0) return { step: source.slice(0, dot), port: source.slice(dot + 1) };
    const producer = this.producer(source);
    const output = producer && meantOutput(producer, input.name, input.kind);
    return output ? { step: source, port: output.name } : null;
  }

  /** "in": "isle": outputs go to the inputs of the same name and kind; of a row, those with its suffix. */
  whole(id: string, suffix: string): Map<string, Connection["from"]> {
    const found = new Map<string, Connection["from"]>();
    for (const output of this.producer(id)?.out ?? []) {
      const input = this.consumer.in.find((port) => port.name === output.name + suffix && port.kind === output.kind);
      if (input) found.set(input.name, { step: id, port: output.name });
    }
    return found;
  }

  /** "in": "isle.terrain". */
  one(source: string): Map<string, Connection["from"]> {
    const dot = source.indexOf(".");
    const from = { step: source.slice(0, dot), port: source.slice(dot + 1) };
    const output = this.producer(from.step)?.out.find((port) => port.name === from.port);
    const input = output && meantInput(this.consumer, output);
    return new Map(input ? [[input.name, from]] : []);
  }

  /** Without "in" an operator that needs an input takes the step before; one that needs any of them takes the first. */
  before(id: string): Map<string, Connection["from"]> {
    const { needs_one = false } = this.consumer;
    if (!needs_one && !this.consumer.in.some((port) => port.required)) return new Map();
    const found = this.whole(id, "");
    if (!needs_one) return found;
    const first = this.consumer.in.find((port) => found.has(port.name));
    return new Map(first ? [[first.name, found.get(first.name)!]] : []);
  }

  all(step: Step): Map<string, Connection["from"]> {
    const inputs = step.in as Json | undefined;
    if (isObject(inputs)) {
      return new Map(this.consumer.in.map((port) => [port.name, this.source(port, inputs[port.name])]));
    }
    if (typeof inputs === "string") return inputs.includes(".") ? this.one(inputs) : this.whole(inputs, "");
    if (Array.isArray(inputs)) {
      const rows = inputs.map((id, i) => this.whole(String(id), i === 0 ? "" : `_${i + 1}`));
      return new Map(rows.flatMap((row) => [...row]));
    }
    const before = this.recipe.steps[this.recipe.steps.indexOf(step) - 1];
    return before ? this.before(before.id) : new Map();
  }
}

/** Every input of the step in the operator's order; empty for an unknown operator. */
export function connectionsOf(recipe: Recipe, schema: Schema, step: Step): Connection[] {
  const consumer = operatorOf(schema, step.op);
  if (!consumer) return [];
  const found = new Reader(recipe, schema, consumer).all(step);
  return consumer.in.map((input) => ({ input, from: found.get(input.name) ?? null }));
}
