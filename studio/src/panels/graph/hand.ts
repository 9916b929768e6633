// What the pointer does in the graph: pan, draw and move wires, drop a node on a wire.
import { useRef, useState } from "preact/hooks";
import type { PortInfo } from "../../api/types";
import type { Studio } from "../../document/studio";
import type { AddRequest } from "../steps/adding";
import { type GraphModel, type GraphNode, type GraphWire, type Point, portPoint, wireDistance,
  wireRun } from "./geometry";
import { type PanZoom, toGraph } from "./pan_zoom";
import { type LooseWire, type Target, bestPort, betweenEdits, connectEdits, disconnectEdits,
  fittingPorts } from "./wiring";

export interface Hand {
  panning: boolean;
  fits: ReadonlySet<string> | null;
  /** The wire in the hand, from left to right. */
  loose: { from: Point; to: Point; kind: string } | null;
  held: { id: string; by: Point } | null;
  /** The wire into which a held node would come. */
  over: GraphWire | null;
  background(event: PointerEvent): void;
  port(event: PointerEvent, node: GraphNode, side: "in" | "out", port: PortInfo): void;
  grab(event: PointerEvent, node: GraphNode): void;
}

type State =
  | { what: "nothing" }
  | { what: "pan" }
  | { what: "wire"; wire: LooseWire; fits: ReadonlyMap<string, Target>; at: Point }
  | { what: "node"; node: GraphNode; by: Point; over: GraphWire | null };

const NEAR = 14;

/** Follows the pointer until it is let go (true), or Escape or a cancelled pointer ends it (false). */
function follow(move: (event: PointerEvent) => void, end: (event: PointerEvent | null) => void): void {
  const finish = (event: PointerEvent | null) => {
    document.removeEventListener("pointermove", move);
    document.removeEventListener("pointerup", up);
    document.removeEventListener("pointercancel", cancel);
    document.removeEventListener("keydown", escape, true);
    end(event);
  };
  const up = (event: PointerEvent) => finish(event);
  const cancel = () => finish(null);
  const escape = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    finish(null);
  };
  document.addEventListener("pointermove", move);
  document.addEventListener("pointerup", up);
  document.addEventListener("pointercancel", cancel);
  document.addEventListener("keydown", escape, true);
}

export function useHand(studio: Studio, root: { current: HTMLElement | null }, model: GraphModel, view: PanZoom,
                        setView: (view: PanZoom) => void, search: (request: AddRequest, px: number, py: number) =>
                          void): Hand {
  const [state, setState] = useState<State>({ what: "nothing" });
  const latest = useRef({ model, view });
  latest.current = { model, view };
  const place = (event: PointerEvent): Point => {
    const box = root.current!.getBoundingClientRect();
    return toGraph(latest.current.view, event.clientX - box.left, event.clientY - box.top);
  };
  const pan = (event: PointerEvent) => {
    const start = { x: event.clientX, y: event.clientY, view: latest.current.view };
    event.preventDefault();
    setState({ what: "pan" });
    follow((moved) => setView({ ...start.view, x: start.view.x + moved.clientX - start.x,
      y: start.view.y + moved.clientY - start.y }),
      () => setState({ what: "nothing" }));
  };
  const drawWire = (event: PointerEvent, wire: LooseWire) => {
    const fits = fittingPorts(wire, latest.current.model);
    const start = [event.clientX, event.clientY] as const;
    let moved = false;
    event.preventDefault();
    event.stopPropagation();
    follow((now) => {
      moved ||= Math.hypot(now.clientX - start[0], now.clientY - start[1]) > 4;
      if (moved) setState({ what: "wire", wire, fits, at: place(now) });
    }, (up) => {
      setState({ what: "nothing" });
      if (up && moved) dropWire(studio, latest.current.model, wire, fits, up, search);
    });
  };
  const grab = (event: PointerEvent, node: GraphNode) => {
    if (event.button !== 0 || !event.shiftKey) return;
    const start = place(event);
    event.stopPropagation();
    let over: GraphWire | null = null;
    follow((now) => {
      const at = place(now);
      over = wireUnder(studio, latest.current.model, node, at);
      setState({ what: "node", node, by: [at[0] - start[0], at[1] - start[1]], over });
    }, (up) => {
      setState({ what: "nothing" });
      const change = up && over ? between(studio, node, over, latest.current.model) : null;
      if (change) void studio.edit(change.edits, change.label);
    });
  };
  return {
    ...shownOf(state, model),
    background(event) {
      const target = event.target as Element;
      if (event.button === 1
        || (event.button === 0 && !target.closest(".node, .wire, .graph-tools, .graph-search"))) pan(event);
    },
    port(event, node, side, port) {
      const wire = event.button === 0 ? takenUp(node, side, port, latest.current.model) : null;
      if (wire) drawWire(event, wire);
    },
    grab,
  };
}

function shownOf(state: State, model: GraphModel): Pick<Hand, "panning" | "fits" | "loose" | "held" | "over"> {
  return {
    panning: state.what === "pan",
    fits: state.what === "wire" ? new Set(state.fits.keys()) : null,
    loose: state.what === "wire" ? looseLine(state.wire, state.at, model) : null,
    held: state.what === "node" ? { id: state.node.id, by: state.by } : null,
    over: state.what === "node" ? state.over : null,
  };
}

/** The wire that begins at a port; a connected input's is taken off it. */
function takenUp(node: GraphNode, side: "in" | "out", port: PortInfo, model: GraphModel): LooseWire | null {
  const origin = side === "in" ? model.connections.get(node.id)?.get(port.name) : undefined;
  if (!origin || !("step" in origin)) return { step: node.id, side, port };
  const made = model.byId.get(origin.step)?.op?.out.find((output) => output.name === origin.port);
  return made ? { step: origin.step, side: "out", port: made, off: { to: node.id, input: port.name } } : null;
}

function looseLine(wire: LooseWire, at: Point, model: GraphModel): Hand["loose"] {
  const node = model.byId.get(wire.step);
  if (!node) return null;
  const end = portPoint(node, wire.side, wire.port.name);
  return wire.side === "out" ? { from: end, to: at, kind: wire.port.kind }
    : { from: at, to: end, kind: wire.port.kind };
}

function between(studio: Studio, node: GraphNode, wire: GraphWire, model: GraphModel) {
  return betweenEdits(node, wire, model, studio.document.value.recipe, (name) => studio.operator(name));
}

function wireUnder(studio: Studio, model: GraphModel, node: GraphNode, at: Point): GraphWire | null {
  let found: GraphWire | null = null;
  let least = NEAR;
  for (const wire of model.wires) {
    const run = wireRun(model, wire);
    if (!run || !between(studio, node, wire, model)) continue;
    const away = wireDistance(run, at);
    if (away < least) [least, found] = [away, wire];
  }
  return found;
}

/** On a port that fits: connected. On a node: with its best port. Over nothing: taken off, or operators are offered. */
function dropWire(studio: Studio, model: GraphModel, wire: LooseWire, fits: ReadonlyMap<string, Target>,
  event: PointerEvent,
                  search: (request: AddRequest, px: number, py: number) => void): void {
  const under = document.elementFromPoint(event.clientX, event.clientY);
  const key = under?.closest<HTMLElement>("[data-port]")?.dataset["port"];
  const node = model.byId.get(under?.closest<HTMLElement>("[data-node]")?.dataset["node"] ?? "");
  const { recipe } = studio.document.value;
  const operators = (name: string) => studio.operator(name);
  let target = key !== undefined ? fits.get(key) : undefined;
  if (!target && node) {
    const port = bestPort(wire, node, model);
    if (port) target = { step: node.id, port };
  }
  if (target) {
    if (wire.off && wire.off.to === target.step && wire.off.input === target.port.name) return;
    const { edits, label } = connectEdits(wire, target, recipe, operators);
    void studio.edit(edits, label);
  } else if (!node && wire.off) {
    const { edits, label } = disconnectEdits(wire.off.to, wire.off.input, recipe, operators);
    void studio.edit(edits, label);
  } else if (!node && under?.closest(".graph")) {
    const end = { step: wire.step, port: wire.port };
    search(wire.side === "out" ? { after: wire.step, from: end } : { after: null, to: end }, event.clientX,
      event.clientY);
  }
}
