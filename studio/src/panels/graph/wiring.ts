// Drawing a wire from port to port: what it may end on, and the edits that connect. Cycles cannot be made: what depends
// on a step is never offered to it.
import type { Edit, OperatorInfo, PortInfo, Recipe } from "../../api/types";
import { type Operators, connectingEdits, downstream } from "./connections";
import type { GraphModel, GraphNode, GraphWire } from "./geometry";

/** A wire in the hand: one end holds to a port, the other looks for one. */
export interface LooseWire {
  step: string;
  side: "in" | "out";
  port: PortInfo;
  /** Taken off this input, which is disconnected if the wire is let go over nothing. */
  off?: { to: string; input: string };
}

export interface Target {
  step: string;
  port: PortInfo;
}

export function portKey(step: string, side: "in" | "out", port: string): string {
  return `${step}/${side}/${port}`;
}

/** Ports on which a loose wire may end, by key; of nodes also what they do not show. */
export function fittingPorts(wire: LooseWire, model: GraphModel): ReadonlyMap<string, Target> {
  const found = new Map<string, Target>();
  const below = downstream(wire.step, model.connections);
  for (const node of model.nodes) {
    if (node.id === wire.step) continue;
    if (wire.side === "out") {
      if (downstream(node.id, model.connections).has(wire.step)) continue;
      for (const port of node.op?.in ?? []) if (port.kind === wire.port.kind) found.set(portKey(node.id, "in",
        port.name), { step: node.id, port });
    } else if (!below.has(node.id)) {
      for (const port of node.op?.out ?? []) if (port.kind === wire.port.kind) found.set(portKey(node.id, "out",
        port.name), { step: node.id, port });
    }
  }
  return found;
}

/** Where a wire ends that is dropped on a node, not on one of its ports: an open input first, of its name at best. */
export function bestPort(wire: LooseWire, node: GraphNode, model: GraphModel): PortInfo | null {
  const fits = [...fittingPorts(wire, model).values()].filter((target) => target.step === node.id)
    .map((target) => target.port);
  const taken = model.connections.get(node.id);
  const score = (port: PortInfo) => (taken?.has(port.name) && wire.side === "out"
    ? 0 : 4) + (port.name === wire.port.name ? 2 : 0) + (port.required ? 1 : 0);
  return fits.sort((a, b) => score(b) - score(a))[0] ?? null;
}

/** Edits that connect a loose wire with a port. */
export function connectEdits(wire: LooseWire, target: Target, recipe: Recipe, operators: Operators): { edits: Edit[];
  label: string } {
  const [from, to] = wire.side === "out" ? [{ step: wire.step, port: wire.port }, target]
    : [target, { step: wire.step, port: wire.port }];
  const off = wire.off ? [{ step: wire.off.to, input: wire.off.input, origin: null }] : [];
  const on = { step: to.step, input: to.port.name, origin: { step: from.step, port: from.port.name } };
  return { edits: connectingEdits([...off, on], recipe, operators),
    label: `${to.step}: ${to.port.name} from ${from.step}.${from.port.name}` };
}

export function disconnectEdits(step: string, input: string, recipe: Recipe, operators: Operators): { edits: Edit[];
  label: string } {
  return { edits: connectingEdits([{ step, input, origin: null }], recipe, operators),
    label: `${step}: ${input} disconnected` };
}

/** A node that is dropped on a wire comes in between: null where it does not fit or would close a circle. */
export function betweenEdits(node: GraphNode, wire: GraphWire, model: GraphModel, recipe: Recipe,
                             operators: Operators): { edits: Edit[]; label: string } | null {
  const op: OperatorInfo | undefined = node.op;
  if (!op || wire.from === node.id || wire.to === node.id) return null;
  const below = downstream(node.id, model.connections);
  if (below.has(wire.from) || downstream(wire.to, model.connections).has(node.id)) return null;
  const of = (ports: readonly PortInfo[]) => ports.find((port) => port.name === wire.input && port.kind === wire.kind)
    ?? ports.find((port) => port.kind === wire.kind && port.required) ?? ports.find((port) => port.kind === wire.kind);
  const taken = of(op.in);
  const made = of(op.out);
  if (!taken || !made) return null;
  return {
    edits: connectingEdits([{ step: node.id, input: taken.name, origin: { step: wire.from, port: wire.output } },
      { step: wire.to, input: wire.input, origin: { step: node.id, port: made.name } }], recipe, operators),
    label: `${node.id} between ${wire.from} and ${wire.to}`,
  };
}
