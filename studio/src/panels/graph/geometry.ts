// The graph in the plane: which ports a node shows, how large it is, where ports lie, how wires run. Pure.
import type { OperatorInfo, PortInfo, Recipe } from "../../api/types";
import { type Connections, type Operators, allConnections } from "./connections";
import { type Crossing, type Layout, layOut, wireName } from "./layout";

export const NODE_WIDTH = 164;
const HEAD = 44;
const ROW = 17;
const FOOT = 5;
/** So many ports are always shown; of more only those that are connected or must be. */
const FEW = 4;

export interface GraphNode {
  id: string;
  opName: string;
  op: OperatorInfo | undefined;
  ins: PortInfo[];
  outs: PortInfo[];
  /** Ports that are not shown. */
  hiddenIns: number;
  x: number;
  y: number;
  height: number;
}

export interface GraphWire {
  from: string;
  output: string;
  to: string;
  input: string;
  kind: string;
}

export interface GraphModel {
  nodes: GraphNode[];
  byId: ReadonlyMap<string, GraphNode>;
  wires: GraphWire[];
  connections: ReadonlyMap<string, Connections>;
  layout: Layout;
}

export function wireKey(wire: GraphWire): string {
  return `${wire.to}.${wire.input}`;
}

function wiresOf(recipe: Recipe, all: ReadonlyMap<string, Connections>, operators: Operators): GraphWire[] {
  const wires: GraphWire[] = [];
  for (const step of recipe.steps) {
    for (const [input, origin] of all.get(step.id) ?? []) {
      if (!("step" in origin)) continue;
      const kind = operators(step.op)?.in.find((port) => port.name === input)?.kind ?? "";
      wires.push({ from: origin.step, output: origin.port, to: step.id, input, kind });
    }
  }
  return wires;
}

export function graphOf(recipe: Recipe, operators: Operators): GraphModel {
  const connections = allConnections(recipe, operators);
  const wires = wiresOf(recipe, connections, operators);
  const nodes = recipe.steps.map((step): GraphNode => {
    const op = operators(step.op);
    const all = op?.in ?? [];
    const ins = all.length <= FEW
      ? all : all.filter((port) => port.required || connections.get(step.id)?.has(port.name));
    const made = op?.out ?? [];
    const used = (port: PortInfo) => wires.some((wire) => wire.from === step.id && wire.output === port.name);
    const outs = made.length <= FEW ? made : made.filter((port, i) => i === 0 || used(port));
    const rows = Math.max(ins.length + (ins.length < all.length ? 1 : 0), outs.length);
    return { id: step.id, opName: step.op, op, ins, outs, hiddenIns: all.length - ins.length, x: 0, y: 0,
      height: HEAD + rows * ROW + FOOT };
  });
  const layout = layOut(nodes.map((node) => ({ id: node.id, width: NODE_WIDTH, height: node.height })), wires,
    { columnGap: 56, rowGap: 22 });
  const placed = nodes.map((node) => ({ ...node, ...pick(layout.places.get(node.id)) }));
  return { nodes: placed, byId: new Map(placed.map((node) => [node.id, node])), wires, connections, layout };
}

function pick(place: { x: number; y: number } | undefined): { x: number; y: number } {
  return { x: place?.x ?? 0, y: place?.y ?? 0 };
}

export type Point = readonly [number, number];

/** Middle of a port; one that is not shown lies at the last row. */
export function portPoint(node: GraphNode, side: "in" | "out", port: string): Point {
  const ports = side === "in" ? node.ins : node.outs;
  const at = ports.findIndex((candidate) => candidate.name === port);
  const row = at === -1 ? ports.length : at;
  return [node.x + (side === "in" ? 0 : NODE_WIDTH), node.y + HEAD + row * ROW + ROW / 2];
}

export function portTop(row: number): number {
  return HEAD + row * ROW;
}

/** Control points of a wire: level at both ends. */
function controls([x1, y1]: Point, [x2, y2]: Point): [Point, Point, Point, Point] {
  const reach = Math.max(20, Math.abs(x2 - x1) / 2);
  return [[x1, y1], [x1 + reach, y1], [x2 - reach, y2], [x2, y2]];
}

/** What a wire runs through, from port to port; wires side by side keep a little apart on long ways. */
export interface WireRun {
  from: Point;
  to: Point;
  crossings: readonly Crossing[];
  aside: number;
}

export function wireRun(model: GraphModel, wire: GraphWire): WireRun | null {
  const [from, to] = [model.byId.get(wire.from), model.byId.get(wire.to)];
  if (!from || !to) return null;
  const alike = model.wires.filter((other) => other.from === wire.from && other.to === wire.to);
  const aside = 4 * (alike.indexOf(wire) - (alike.length - 1) / 2);
  const crossings = model.layout.crossings.get(wireName(wire)) ?? [];
  return { from: portPoint(from, "out", wire.output), to: portPoint(to, "in", wire.input), crossings, aside };
}

/** The bends of a run: from port to layer to layer to port. */
function bends({ from, to, crossings, aside }: WireRun): [Point, Point][] {
  const found: [Point, Point][] = [];
  let at = from;
  for (const { left, right, y } of crossings) {
    found.push([at, [left, y + aside]]);
    at = [right, y + aside];
  }
  return [...found, [at, to]];
}

export function wirePath(run: WireRun): string {
  return bends(run).map(([from, to], i) => {
    const [a, b, c, d] = controls(from, to);
    return `${i === 0 ? "M" : "L"}${a[0]} ${a[1]}C${b[0]} ${b[1]} ${c[0]} ${c[1]} ${d[0]} ${d[1]}`;
  }).join("");
}

/** Distance of a place from a wire. */
export function wireDistance(run: WireRun, [x, y]: Point): number {
  let least = Infinity;
  for (const [from, to] of bends(run)) {
    const [a, b, c, d] = controls(from, to);
    for (let i = 0; i <= 24; ++i) {
      const t = i / 24;
      const s = 1 - t;
      const on = (k: 0 | 1) => s * s * s * a[k] + 3 * s * s * t * b[k] + 3 * s * t * t * c[k] + t * t * t * d[k];
      least = Math.min(least, Math.hypot(on(0) - x, on(1) - y));
    }
  }
  for (const { left, right, y: level } of run.crossings)
    if (x >= left && x <= right) least = Math.min(least, Math.abs(level + run.aside - y));
  return least;
}

/** The node that an arrow key leads to: the nearest of those that lie more in its direction than beside it. */
export function neighbour(model: GraphModel, id: string, key: string): string | null {
  const from = model.byId.get(id);
  if (!from) return model.nodes[0]?.id ?? null;
  const middle = (node: GraphNode): Point => [node.x + NODE_WIDTH / 2, node.y + node.height / 2];
  const [x, y] = middle(from);
  let found: string | null = null;
  let least = Infinity;
  for (const node of model.nodes) {
    if (node.id === id) continue;
    const [dx, dy] = [middle(node)[0] - x, middle(node)[1] - y];
    const [along, beside] = key === "ArrowLeft" ? [-dx, dy] : key === "ArrowRight" ? [dx, dy] : key === "ArrowUp"
      ? [-dy, dx] : [dy, dx];
    if (along <= 0 || Math.abs(beside) > along * 2.5) continue;
    const cost = along + 2 * Math.abs(beside);
    if (cost < least) [least, found] = [cost, node.id];
  }
  return found;
}
