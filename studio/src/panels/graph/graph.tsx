// The graph of the steps, laid out by depth: wires by dragging from port to port, what does not fit is dim. A wire
// that is let go over nothing offers operators that fit it; a node that is dropped on a wire with Shift comes in
// between.
import type { JSX } from "preact";
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import { Maximize, Plus, ZoomIn, ZoomOut } from "lucide-preact";
import type { Studio } from "../../document/studio";
import { HelpTips } from "../params/help_tip";
import { AddStep } from "../steps/add_step";
import type { AddRequest } from "../steps/adding";
import { duplicate, removeStep, toggleBypass } from "../steps/step_edits";
import { type GraphModel, type GraphWire, graphOf, neighbour, wireKey, wirePath, wireRun } from "./geometry";
import { useHand } from "./hand";
import { kindClass } from "./kind_mark";
import { Node } from "./node";
import { type PanZoom, fitted, zoomedAt } from "./pan_zoom";
import { disconnectEdits, portKey } from "./wiring";

interface Searching {
  request: AddRequest;
  left: number;
  top: number;
}

export function Graph({ studio }: { studio: Studio }): JSX.Element {
  const root = useRef<HTMLDivElement>(null);
  const { recipe } = studio.document.value;
  const model = useMemo(() => graphOf(recipe, (name) => studio.operator(name)), [recipe, studio.schema]);
  const [view, setView, fit] = usePanZoom(root, model);
  const [searching, setSearching] = useState<Searching | null>(null);
  const search = (request: AddRequest, px: number, py: number) => {
    const box = root.current!.getBoundingClientRect();
    setSearching({ request, left: Math.max(8, Math.min(px - box.left, box.width - 308)),
      top: Math.max(8, Math.min(py - box.top, box.height - 230)) });
  };
  const hand = useHand(studio, root, model, view, setView, search);
  const states = new Map(studio.engine.value.steps.map((state) => [state.id, state]));
  const connected = useMemo(() =>
    new Set(model.wires.flatMap((wire) =>
    [portKey(wire.from, "out", wire.output), portKey(wire.to, "in", wire.input)])), [model]);
  const fits = hand.fits;
  const selected = studio.selected.value;
  return (
    <div class={`graph${hand.panning ? " panning" : ""}`} ref={root} role="group" aria-label="Graph of the steps"
      onPointerDown={hand.background} onDblClick={(event) => {
      if ((event.target as Element).closest(".node, .add-step, .graph-tools, .wire")) return;
      search({ after: selected }, event.clientX, event.clientY);
    }}>
      <div class="graph-plane" style={{ transform: `translate(${view.x}px, ${view.y}px) scale(${view.scale})` }}>
        <svg class="graph-wires" width="1" height="1">
          {model.wires.map((wire) => <Wire key={wireKey(wire)} studio={studio} wire={wire} model={model}
            dim={fits !== null} over={hand.over !== null && wireKey(hand.over) === wireKey(wire)}
            onSearch={(event) => search({ after: wire.from, into: wire }, event.clientX, event.clientY)} />)}
        </svg>
        {model.nodes.map((node) => <Node key={node.id} studio={studio} node={node} state={states.get(node.id)}
          connected={connected} fits={fits}
          focusable={node.id === (selected ?? model.nodes[0]?.id)} shift={hand.held?.id === node.id ? hand.held.by
          : null}
          onPort={(event, side, port) => hand.port(event, node, side, port)} onGrab={(event) => hand.grab(event, node)}
          onKeyDown={(event) => onNodeKey(event, studio, model, node.id, root)} />)}
        {hand.loose && <svg class="graph-wires loose" width="1"
          height="1"><path class={`wire-loose ${kindClass(hand.loose.kind)}`}
          d={wirePath({ ...hand.loose, crossings: [], aside: 0 })} /></svg>}
      </div>
      {model.nodes.length === 0 && <p class="empty">Nothing yet. Double click to add a step.</p>}
      <div class="graph-tools">
        <button type="button" class="plain icon small" aria-label="Add step" data-help="Add step (double click)"
          onClick={(event) => search({ after: selected }, event.clientX - 320, event.clientY + 20)}><Plus /></button>
        <button type="button" class="plain icon small" aria-label="Zoom in"
          onClick={() => setView(zoomedAt(view, middle(root, 0), middle(root, 1), 1.25))}><ZoomIn /></button>
        <button type="button" class="plain icon small" aria-label="Zoom out"
          onClick={() => setView(zoomedAt(view, middle(root, 0), middle(root, 1), 0.8))}><ZoomOut /></button>
        <button type="button" class="plain icon small" aria-label="Fit all" data-help="Fit all (Home)"
          onClick={fit}><Maximize /></button>
      </div>
      {searching && <div class="graph-search" style={{ left: `${searching.left}px`, top: `${searching.top}px` }}>
        <AddStep studio={studio} request={searching.request} onDone={() => setSearching(null)} /></div>}
      <HelpTips within={root} />
    </div>
  );
}

function middle(root: { current: HTMLElement | null }, axis: 0 | 1): number {
  return (axis === 0 ? root.current?.clientWidth ?? 0 : root.current?.clientHeight ?? 0) / 2;
}

/** Fits all when it is first seen and when steps come or go, as long as nobody has moved the view. */
function usePanZoom(root: { current: HTMLElement | null }, model: GraphModel): [PanZoom, (view: PanZoom) => void,
  () => void] {
  const [view, setView] = useState<PanZoom>({ x: 20, y: 20, scale: 1 });
  const own = useRef(false);
  const latest = useRef({ view, model });
  latest.current = { view, model };
  const fit = () => {
    own.current = false;
    const box = root.current;
    if (box && box.clientWidth > 0) setView(fitted(latest.current.model.layout,
      { width: box.clientWidth, height: box.clientHeight }));
  };
  useLayoutEffect(() => { if (!own.current) fit(); }, [model.layout.width, model.layout.height]);
  useEffect(() => {
    const box = root.current;
    if (!box) return;
    const observer = new ResizeObserver(() => { if (!own.current) fit(); });
    observer.observe(box);
    const onWheel = (event: WheelEvent) => {
      if ((event.target as Element).closest(".add-step")) return;
      event.preventDefault();
      const place = box.getBoundingClientRect();
      own.current = true;
      setView(zoomedAt(latest.current.view, event.clientX - place.left, event.clientY - place.top,
        Math.exp(-event.deltaY / 500)));
    };
    box.addEventListener("wheel", onWheel, { passive: false });
    return () => {
      observer.disconnect();
      box.removeEventListener("wheel", onWheel);
    };
  }, []);
  const move = (next: PanZoom) => {
    own.current = true;
    setView(next);
  };
  return [view, move, fit];
}

/** Arrows go from node to node, Delete removes, B leaves out, Ctrl+D copies. */
function onNodeKey(event: KeyboardEvent, studio: Studio, model: GraphModel, id: string,
  root: { current: HTMLElement | null }): void {
  const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
  if (/^Arrow/.test(event.key) && plain) {
    const next = neighbour(model, id, event.key);
    if (next === null) return;
    studio.selected.value = next;
    root.current?.querySelector<HTMLElement>(`[data-node="${CSS.escape(next)}"] .node-head`)?.focus();
  } else if ((event.key === "Delete" || event.key === "Backspace") && plain) void removeStep(studio, id);
  else if (event.key.toLowerCase() === "b" && plain) toggleBypass(studio, id);
  else if (event.key.toLowerCase() === "d" && (event.ctrlKey || event.metaKey)) void duplicate(studio, id);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

interface WireProps {
  studio: Studio;
  wire: GraphWire;
  model: GraphModel;
  dim: boolean;
  over: boolean;
  onSearch(event: MouseEvent): void;
}

function Wire({ studio, wire, model, dim, over, onSearch }: WireProps): JSX.Element | null {
  const run = wireRun(model, wire);
  if (!run) return null;
  const path = wirePath(run);
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== "Delete" && event.key !== "Backspace") return;
    event.preventDefault();
    event.stopPropagation();
    const { edits, label } = disconnectEdits(wire.to, wire.input, studio.document.value.recipe,
      (name) => studio.operator(name));
    void studio.edit(edits, label);
  };
  return (
    <g class={`wire ${kindClass(wire.kind)}${dim ? " dim" : ""}${over ? " over" : ""}`} tabIndex={0} role="button"
      aria-label={`${wire.from}.${wire.output} to ${wire.to}.${wire.input}; Delete disconnects`}
      onKeyDown={onKeyDown} onDblClick={(event) => { event.stopPropagation(); onSearch(event); }}>
      <path class="wire-hit" d={path} /><path class="wire-line" d={path} />
    </g>
  );
}
