// A distribution as bars that are painted: from the lowest (left) to the highest (right), how much there is of each.
import type { JSX } from "preact";
import { useRef, useState } from "preact/hooks";
import { ChartArea } from "lucide-preact";
import { type Field, newGesture, setField } from "../params/scope";
import { numberText, titleOf } from "../params/words";
import { painted } from "./histogram";

const FIRST = 16;

export function HistogramEditor({ field }: { field: Field }): JSX.Element {
  const values = Array.isArray(field.value) ? field.value.filter((item): item is number => typeof item === "number")
    : [];
  const [at, setAt] = useState(0);
  const stroke = useRef<{ gesture: string; bar: number; share: number; values: number[]; top: number } | null>(null);
  const title = titleOf(field.info.name);
  if (values.length === 0) {
    return (
      <div class="curve-none"><span class="muted">none</span>
        <button type="button" class="plain compact" aria-label={`Paint ${title.toLowerCase()}`}
          onClick={() => setField(field, Array.from({ length: FIRST }, (_, i) => Number((1 - i / FIRST).toFixed(3))))}>
          <ChartArea />Paint heights</button></div>
    );
  }
  const top = stroke.current?.top ?? Math.max(1e-9, ...values) * 1.1;
  const where = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const bar = Math.floor(((event.clientX - box.left) / box.width) * values.length);
    return { bar: Math.min(values.length - 1, Math.max(0, bar)),
      share: Math.min(1, Math.max(0, 1 - (event.clientY - box.top) / box.height)) };
  };
  const paint = (event: PointerEvent) => {
    const now = stroke.current;
    if (!now) return;
    const to = where(event);
    now.values = painted(now.values, now, to, now.top);
    [now.bar, now.share] = [to.bar, to.share];
    setAt(to.bar);
    setField(field, now.values, now.gesture);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const by = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    const along = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (by === 0 && along === 0) return;
    event.preventDefault();
    event.stopPropagation();
    if (along !== 0) return setAt(Math.min(values.length - 1, Math.max(0, at + along)));
    const next = Math.max(0, (values[at] ?? 0) + (by * top) / (event.shiftKey ? 200 : 20));
    setField(field, values.map((value, i) => (i === at ? Number(next.toPrecision(3)) : value)), newGesture());
  };
  return (
    <div class="histogram">
      <div class="histogram-bars" role="slider" tabIndex={0} aria-label={`${title}, bar ${at + 1} of ${values.length}`}
        aria-valuenow={values[at] ?? 0}
        aria-valuetext={numberText(values[at] ?? 0)} onKeyDown={onKeyDown}
        onPointerDown={(event) => {
          if (event.button !== 0) return;
          event.currentTarget.setPointerCapture(event.pointerId);
          stroke.current = { gesture: newGesture(), ...where(event), values, top };
          paint(event);
        }}
        onPointerMove={paint} onPointerUp={() => { stroke.current = null; }}
        onPointerCancel={() => { stroke.current = null; }}>
        {values.map((value, i) => <span key={i} class={i === at ? "bar current" : "bar"}
          style={{ height: `${100 * Math.min(1, value / top)}%` }} />)}
      </div>
      <div class="histogram-ends muted"><span>lowest</span><span>{values.length} steps</span><span>highest</span></div>
    </div>
  );
}
