// A curve drawn through knots: knots are dragged, added by a click, taken out by Delete or by dragging them off, and
// set exactly below. Names and colours mark what lies along x, such as the regions of an island.
import type { JSX } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { NumberField } from "../params/number_field";
import { newGesture } from "../params/scope";
import { amountText, numberText } from "../params/words";
import { type View, MARGIN, curvePath, fromPixel, keyStep, ticks, toPixel, viewedValues } from "./curve_view";
import { type CurveBounds, added, moved, removed, split } from "./knots";
import { type CurveKind, type Knot, curveFunction } from "./monotone";

export interface CurveEditorProps {
  label: string;
  knots: readonly Knot[];
  kind: CurveKind;
  bounds: CurveBounds;
  unit: string;
  /** What lies between whole numbers along x. */
  bands?: readonly { name: string; colour: string }[] | undefined;
  xName: string;
  onChange(knots: Knot[], gesture: string): void;
}

interface Grip {
  gesture: string;
  index: number;
  knots: readonly Knot[];
  view: View;
  off: boolean;
}

const HEIGHT = 152;
const OFF_PX = 36;

function useWidth(): [{ current: HTMLDivElement | null }, number] {
  const element = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(290);
  useLayoutEffect(() => {
    const box = element.current;
    if (!box) return;
    const observer = new ResizeObserver(() => setWidth(Math.max(160, box.clientWidth)));
    observer.observe(box);
    return () => observer.disconnect();
  }, []);
  return [element, width];
}

export function CurveEditor(props: CurveEditorProps): JSX.Element {
  const { knots, bounds, kind, unit } = props;
  const [box, width] = useWidth();
  const [selected, setSelected] = useState(0);
  const grip = useRef<Grip | null>(null);
  const view: View = grip.current ? { ...grip.current.view, width } : { x: bounds.x, y: viewedValues(knots, bounds),
    width, height: HEIGHT };
  const index = Math.min(selected, knots.length - 1);
  const hold = useGrip(props, grip, view, setSelected);
  const change = (next: Knot[], at = index) => {
    props.onChange(next, newGesture());
    setSelected(at);
    requestAnimationFrame(() => box.current?.querySelectorAll<SVGElement>(".knot")[at]?.focus());
  };
  const onKeyDown = (event: KeyboardEvent, at: number) => {
    const next = keyed(event, knots, at, bounds, view, kind);
    if (!next) return;
    event.preventDefault();
    event.stopPropagation();
    change(next.knots, next.index);
  };
  const knot = knots[index];
  return (
    <div class="curve">
      <div ref={box} class="curve-box">
        <svg width={width} height={HEIGHT} role="group" aria-label={props.label} class={grip.current?.off ? "off" : ""}
          onPointerDown={hold.down} onPointerMove={hold.move} onPointerUp={hold.up} onPointerCancel={hold.cancel}>
          <Axes view={view} unit={unit} bands={props.bands} />
          <path class="curve-line" d={curvePath(view, curveFunction(knots, kind))} />
          {knots.map((at, i) => {
            const [cx, cy] = toPixel(view, at);
            return <circle key={i} class={`knot${i === index ? " selected" : ""}`} cx={cx} cy={cy}
              r={i === index ? 5.5 : 4.5} tabIndex={i === index ? 0 : -1}
              role="button" data-knot={i} aria-label={`Knot ${i + 1}: ${numberText(at[0])}, ${amountText(at[1], unit)}`}
              onFocus={() => setSelected(i)} onKeyDown={(event) => onKeyDown(event, i)} />;
          })}
        </svg>
      </div>
      {knot && <div class="curve-values">
        <NumberField label={`Knot ${index + 1}, ${props.xName}`} value={knot[0]} unit="" prefix={props.xName}
          min={bounds.x[0]} max={bounds.x[1]}
          onChange={(x, gesture) => props.onChange(moved(knots, index, [x, knot[1]], bounds), gesture)} />
        <NumberField label={`Knot ${index + 1}, value`} value={knot[1]} unit={unit} {...finite(bounds.y)}
          usual={knot[1]}
          onChange={(y, gesture) => props.onChange(moved(knots, index, [knot[0], y], bounds), gesture)} />
      </div>}
    </div>
  );
}

function finite([low, high]: readonly [number, number]): { min?: number; max?: number } {
  return { ...(Number.isFinite(low) ? { min: low } : {}), ...(Number.isFinite(high) ? { max: high } : {}) };
}

/** Arrows move, Delete takes out, Insert or plus adds a knot beside. */
function keyed(event: KeyboardEvent, knots: readonly Knot[], at: number, bounds: CurveBounds, view: View,
               kind: CurveKind): { knots: Knot[]; index: number } | null {
  const knot = knots[at]!;
  const dx = keyStep(view.x, event.shiftKey);
  const dy = keyStep(view.y, event.shiftKey);
  const to = (x: number, y: number) => ({ knots: moved(knots, at, [knot[0] + x, knot[1] + y], bounds), index: at });
  switch (event.key) {
    case "ArrowUp": return to(0, dy);
    case "ArrowDown": return to(0, -dy);
    case "ArrowLeft": return event.ctrlKey ? { knots: [...knots], index: Math.max(0, at - 1) } : to(-dx, 0);
    case "ArrowRight": return event.ctrlKey ? { knots: [...knots], index: Math.min(knots.length - 1, at + 1) }
      : to(dx, 0);
    case "Delete": case "Backspace":
      return knots.length > 1 ? { knots: removed(knots, at), index: Math.max(0, at - 1) } : null;
    case "Insert": case "+": return split(knots, at, bounds, kind);
    default: return null;
  }
}

function useGrip(props: CurveEditorProps, grip: { current: Grip | null }, view: View, select: (index: number) => void) {
  const latest = useRef(props);
  latest.current = props;
  const [, redraw] = useState(0);
  useEffect(() => () => { grip.current = null; }, []);
  const place = (event: PointerEvent): [number, number] => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const end = () => {
    grip.current = null;
    redraw((n) => n + 1);
  };
  return {
    down(event: PointerEvent) {
      if (event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      const gesture = newGesture();
      const [px, py] = place(event);
      const near = nearest(latest.current.knots, view, px, py);
      if (near !== null) {
        grip.current = { gesture, index: near, knots: latest.current.knots, view, off: false };
        select(near);
        return;
      }
      const next = added(latest.current.knots, fromPixel(view, px, py), latest.current.bounds);
      if (!next) return;
      grip.current = { gesture, index: next.index, knots: next.knots, view, off: false };
      latest.current.onChange(next.knots, gesture);
      select(next.index);
    },
    move(event: PointerEvent) {
      const held = grip.current;
      if (!held) return;
      const [px, py] = place(event);
      const { bounds, onChange } = latest.current;
      held.off = held.knots.length > 1 && (px < -OFF_PX || py < -OFF_PX || px > view.width + OFF_PX
        || py > view.height + OFF_PX);
      if (held.off) onChange(removed(held.knots, held.index), held.gesture);
      else onChange(moved(held.knots, held.index, fromPixel(held.view, px, py), bounds), held.gesture);
    },
    up: end,
    cancel() {
      if (grip.current) latest.current.onChange([...grip.current.knots], grip.current.gesture);
      end();
    },
  };
}

function nearest(knots: readonly Knot[], view: View, px: number, py: number): number | null {
  let found: number | null = null;
  let least = 11;
  knots.forEach((knot, i) => {
    const [x, y] = toPixel(view, knot);
    const away = Math.hypot(px - x, py - y);
    if (away < least) [least, found] = [away, i];
  });
  return found;
}

function Axes({ view, unit, bands }: { view: View; unit: string; bands: CurveEditorProps["bands"] }): JSX.Element {
  const bottom = view.height - MARGIN.bottom;
  const right = view.width - MARGIN.right;
  const zero = view.y[0] < 0 && view.y[1] > 0 ? toPixel(view, [0, 0])[1] : null;
  const xTicks = bands ? bands.map((_, i) => i).concat(bands.length) : ticks(view.x, 5);
  return (
    <g class="curve-axes">
      {zero !== null && unit === "m" && <rect class="curve-sea" x={MARGIN.left} y={zero} width={right - MARGIN.left}
        height={Math.max(0, bottom - zero)} />}
      {ticks(view.y, 4).map((y) => {
        const at = toPixel(view, [0, y])[1];
        return <g key={y}><line class={y === 0 ? "zero" : ""} x1={MARGIN.left} x2={right} y1={at} y2={at} />
          <text x={MARGIN.left - 8} y={at + 3.5} text-anchor="end">{numberText(y)}</text></g>;
      })}
      {xTicks.map((x) => {
        const at = toPixel(view, [x, 0])[0];
        return <g key={x}><line x1={at} x2={at} y1={MARGIN.top} y2={bottom} />
          {!bands && <text x={at} y={view.height - 6} text-anchor="middle">{numberText(x)}</text>}</g>;
      })}
      {bands?.map((band, i) => {
        const from = toPixel(view, [i, 0])[0];
        const to = toPixel(view, [i + 1, 0])[0];
        return <g key={band.name}><rect x={from + 0.5} y={bottom + 1} width={to - from - 1} height={3}
          style={{ fill: band.colour }} />
          <text x={(from + to) / 2} y={view.height - 5} text-anchor="middle">{band.name}</text></g>;
      })}
    </g>
  );
}
