// A field for one number: drag to change it (Ctrl in whole steps, Shift fine), double click or Enter to type, arrows
// and the wheel (with Ctrl where it has not the focus) to step, Backspace to reset. The filled part shows where in its
// range it lies.
import type { JSX } from "preact";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { newGesture } from "./scope";
import { bounded, dragged, evenStep, firstGuess, pixelStep, rounded, scaleOf } from "./scale";
import { numberText } from "./words";
import { NumberInput } from "./number_input";
import { unitText } from "./units";

export interface NumberFieldProps {
  label: string;
  /** null: derived. */
  value: number | null;
  unit: string;
  min?: number | undefined;
  max?: number | undefined;
  integer?: boolean;
  /** What it usually is, for the slider's scale. */
  usual?: number | null;
  help?: string | undefined;
  /** Not stated: shown more quietly. */
  quiet?: boolean;
  /** In front of the number: "x". */
  prefix?: string;
  /** `before`: what it was when the gesture began. */
  onChange(value: number, gesture: string, before: number | null): void;
  onReset?: ((gesture?: string) => void) | undefined;
}

interface Gesture {
  id: string;
  start: number | null;
  x: number;
  width: number;
  moved: boolean;
  pointer: number;
}

const BURST_MS = 500;

export function NumberField(props: NumberFieldProps): JSX.Element {
  const { value, integer = false, min, max, unit } = props;
  const element = useRef<HTMLDivElement>(null);
  const [typing, setTyping] = useState<string | null>(null);
  const usual = props.usual ?? null;
  const scale = useMemo(() => min !== undefined && max !== undefined && max > min
    ? scaleOf({ min, max, usual, unit, integer }) : null, [min, max, usual, unit, integer]);
  const bounds = { ...(min === undefined ? {} : { min }), ...(max === undefined ? {} : { max }), integer };
  const current = value ?? firstGuess(scale, min, max);
  const step = useSteps(props, bounds, (coarse) => {
    const width = element.current?.clientWidth || 160;
    const pixel = pixelStep(current, scale, width, integer);
    return coarse === "coarse" ? evenStep(pixel * 10) : coarse === "fine" && !integer ? evenStep(pixel / 10) : pixel;
  }, current);
  useWheel(element, step);
  const drag = useDrag(props,
    (gesture, event) => dragged({ start: gesture.start ?? current, dx: event.clientX - gesture.x,
    width: gesture.width, snap: event.ctrlKey || event.metaKey, fine: event.shiftKey }, scale, bounds));
  const onKeyDown = (event: KeyboardEvent) => onFieldKey(event, { step, setTyping, props, drag });
  const edit = (text = value === null ? "" : numberText(value)) => setTyping(text);
  if (typing !== null) {
    return <NumberInput label={props.label} text={typing} unit={unit} bounds={bounds}
      onDone={(typed) => {
        setTyping(null);
        if (typed !== null && typed !== value) props.onChange(typed, newGesture(), value);
        requestAnimationFrame(() => { if (document.activeElement === document.body) element.current?.focus(); });
      }} />;
  }
  const share = scale && value !== null ? scale.share(value) : null;
  const origin = scale && min !== undefined && min < 0 && max !== undefined && max > 0 ? scale.share(0) : 0;
  return (
    <div ref={element} class={`number-field${props.quiet ? " quiet" : ""}${drag.active ? " dragging" : ""}`}
      role="spinbutton"
      tabIndex={0} data-number-field aria-label={props.label} aria-description={props.help}
      aria-valuemin={min} aria-valuemax={max} aria-valuenow={value ?? undefined}
      aria-valuetext={value === null ? "auto" : `${numberText(value)} ${unit}`}
      onPointerDown={drag.down} onPointerMove={drag.move} onPointerUp={drag.up} onPointerCancel={drag.cancel}
      onDblClick={() => edit()} onKeyDown={onKeyDown} onEdit={() => edit()}>
      {share !== null && <span class="number-fill"
        style={{ left: `${100 * Math.min(share, origin)}%`, width: `${100 * Math.abs(share - origin)}%` }} />}
      {props.prefix && <span class="number-prefix">{props.prefix}</span>}
      <span class="number-text">{value === null ? "auto" : numberText(value)}</span>
      {value !== null && unit !== "" && <span class="number-unit">{unitText(unit)}</span>}
    </div>
  );
}

declare module "preact" {
  namespace JSX {
    interface HTMLAttributes<RefType extends EventTarget = EventTarget> {
      onEdit?: (event: CustomEvent) => void;
      readonly refTypeOfEdit?: RefType;
    }
  }
}

type Step = (direction: number, how: "coarse" | "plain" | "fine") => void;

/** Steps by keys and wheel; those within half a second are one gesture. */
function useSteps(props: NumberFieldProps, bounds: { min?: number; max?: number; integer: boolean },
                  size: (how: "coarse" | "plain" | "fine") => number, current: number): Step {
  const burst = useRef<{ id: string; before: number | null; at: number } | null>(null);
  return (direction, how) => {
    const now = performance.now();
    if (!burst.current || now - burst.current.at > BURST_MS) burst.current = { id: newGesture(), before: props.value,
      at: now };
    burst.current.at = now;
    const amount = size(how);
    const next = bounded(rounded(current + direction * amount, amount), bounds);
    if (next !== props.value) props.onChange(next, burst.current.id, burst.current.before);
  };
}

/** The wheel steps a field that has the focus, any other with Ctrl only; the page does not zoom then, nor the panel scroll. */
function useWheel(element: { current: HTMLDivElement | null }, step: Step): void {
  const latest = useRef(step);
  latest.current = step;
  useEffect(() => {
    const field = element.current;
    if (!field) return;
    const onWheel = (event: WheelEvent) => {
      if (!event.ctrlKey && document.activeElement !== field) return;
      event.preventDefault();
      latest.current(event.deltaY < 0 ? 1 : -1, event.shiftKey ? "fine" : "plain");
    };
    field.addEventListener("wheel", onWheel, { passive: false });
    return () => field.removeEventListener("wheel", onWheel);
  });
}

interface DragHandlers {
  active: boolean;
  down(event: PointerEvent): void;
  move(event: PointerEvent): void;
  up(event: PointerEvent): void;
  cancel(): void;
}

/** One gesture from pointer down to up; at most one change a frame. */
function useDrag(props: NumberFieldProps, valueAt: (gesture: Gesture, event: PointerEvent) => number): DragHandlers {
  const gesture = useRef<Gesture | null>(null);
  const frame = useRef<{ id: number; event: PointerEvent } | null>(null);
  const [active, setActive] = useState(false);
  const latest = useRef({ props, valueAt });
  latest.current = { props, valueAt };
  const apply = () => {
    const pending = frame.current;
    frame.current = null;
    if (!pending || !gesture.current?.moved) return;
    const next = latest.current.valueAt(gesture.current, pending.event);
    if (next !== latest.current.props.value) latest.current.props.onChange(next, gesture.current.id,
      gesture.current.start);
  };
  const end = () => {
    if (frame.current) cancelAnimationFrame(frame.current.id);
    apply();
    gesture.current = null;
    setActive(false);
  };
  return {
    active,
    down(event) {
      if (event.button !== 0) return;
      const target = event.currentTarget as HTMLElement;
      target.setPointerCapture(event.pointerId);
      gesture.current = { id: newGesture(), start: props.value, x: event.clientX,
        width: Math.max(80, target.clientWidth), moved: false, pointer: event.pointerId };
    },
    move(event) {
      const now = gesture.current;
      if (!now) return;
      if (!now.moved && Math.abs(event.clientX - now.x) < 3) return;
      if (!now.moved) setActive(true);
      now.moved = true;
      if (frame.current) frame.current.event = event;
      else frame.current = { id: requestAnimationFrame(apply), event };
    },
    up: end,
    cancel() {
      const now = gesture.current;
      if (frame.current) cancelAnimationFrame(frame.current.id);
      frame.current = null;
      gesture.current = null;
      setActive(false);
      if (!now?.moved) return;
      if (now.start === null) props.onReset?.(now.id);
      else props.onChange(now.start, now.id, now.start);
    },
  };
}

interface KeyContext {
  step: Step;
  setTyping(text: string): void;
  props: NumberFieldProps;
  drag: DragHandlers;
}

function onFieldKey(event: KeyboardEvent, { step, setTyping, props, drag }: KeyContext): void {
  const how = event.shiftKey ? "fine" : event.ctrlKey ? "coarse" : "plain";
  const { value, min, max } = props;
  const jump = (to: number | undefined) => { if (to !== undefined && to !== value) props.onChange(to, newGesture(),
    value); };
  const actions: { [key: string]: () => void } = {
    ArrowUp: () => step(1, how), ArrowRight: () => step(1, how), ArrowDown: () => step(-1, how),
      ArrowLeft: () => step(-1, how),
    PageUp: () => step(1, "coarse"), PageDown: () => step(-1, "coarse"), Home: () => jump(min), End: () => jump(max),
    Enter: () => setTyping(value === null ? "" : numberText(value)),
      F2: () => setTyping(value === null ? "" : numberText(value)),
    Backspace: () => props.onReset?.(), Delete: () => props.onReset?.(),
  };
  const action = event.altKey ? undefined : actions[event.key];
  if (action) action();
  else if (event.key === "Escape" && drag.active) drag.cancel();
  else if (/^[0-9.,(−-]$/.test(event.key) && !event.ctrlKey && !event.metaKey && !event.altKey) setTyping(event.key);
  else return;
  event.preventDefault();
  event.stopPropagation();
}
