// Events that begin and end: bars on a line of time, dragged as a whole or by an end. Where the operator has a number
// of iterations or years, a mark shows how far it runs; it is dragged, and play lets it run step by step.
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Pause, Play } from "lucide-preact";
import type { Json, ParamInfo } from "../../api/types";
import { activeItem } from "../params/active_item";
import { type Field, fieldOf, isMembers, newGesture, setField } from "../params/scope";
import { numberText, titleOf, wordOf } from "../params/words";
import { type Grip, type Span, draggedSpan, isEndless, marks, nextTime, shownEnd } from "./schedule";

const TIMES = ["iterations", "years", "steps"];

/** Whether all its tools have a begin and an end. */
export function hasTimes(info: ParamInfo): boolean {
  const tools = info.tools ?? [];
  return tools.length > 0
    && tools.every((tool) => ["start", "end"].every((name) => tool.params.some((param) => param.name === name)));
}

function spanOf(info: ParamInfo, item: Json): Span {
  const members = isMembers(item) ? item : {};
  const tool = info.tools?.find((candidate) => candidate.name === members["tool"]) ?? info.tools?.[0];
  const time = (name: string, otherwise: number) => {
    const value = members[name] ?? tool?.params.find((param) => param.name === name)?.default;
    return typeof value === "number" ? value : otherwise;
  };
  return { start: time("start", 0), end: time("end", 1) };
}

/** The parameter beside the events that says how long it runs. */
export function timeField(field: Field): Field | null {
  const info = field.scope.params.find((param) => TIMES.includes(param.name));
  return info ? fieldOf(field.scope, info) : null;
}

export function EventLines({ field }: { field: Field }): JSX.Element {
  const items = Array.isArray(field.value) ? field.value : [];
  const spans = items.map((item) => spanOf(field.info, item));
  const time = timeField(field);
  const runs = typeof time?.value === "number" ? time.value : 0;
  const held = useRef<number | null>(null);
  const end = held.current ?? shownEnd(spans, runs);
  const step = end <= 4 ? 0.1 : 1;
  const track = useRef<HTMLDivElement>(null);
  const perPixel = () => end / Math.max(1, track.current?.clientWidth ?? 240);
  const setSpan = (index: number, span: Span, gesture: string) => {
    const { studio, owner } = field.scope;
    const before = spans[index]!;
    const edits = (["start", "end"] as const).filter((name) => span[name] !== before[name])
      .map((name) => ({ do: "set" as const, pointer: `${field.pointer}/${index}/${name}`, value: span[name] }));
    const last = isEndless(span) ? "on" : `to ${numberText(span.end)}`;
    if (edits.length > 0) void studio.edit(edits, `${owner}: event ${index + 1} from ${numberText(span.start)} ${last}`,
      gesture);
  };
  return (
    <div class="timeline">
      <div class="timeline-rows" ref={track}>
        {marks(end, 6).map((at) => <span key={at} class="timeline-mark"
          style={{ left: `${(100 * at) / end}%` }}>{numberText(at)}</span>)}
        {items.map((item, i) => <EventBar key={i} name={nameOf(item, i)} span={spans[i]!} end={end} step={step}
          pointer={`${field.pointer}/${i}`}
          stepId={field.scope.step} perPixel={perPixel} onHold={(on) => { held.current = on ? end : null; }}
          onChange={(span, gesture) => setSpan(i, span, gesture)} />)}
        {time && <PlayMark time={time} runs={runs} end={end} step={step} perPixel={perPixel} />}
      </div>
      {time && <PlayButton time={time} runs={runs} end={end} step={step} />}
    </div>
  );
}

function nameOf(item: Json, index: number): string {
  return isMembers(item) && typeof item["tool"] === "string" ? wordOf(item["tool"]) : `event ${index + 1}`;
}

interface EventBarProps {
  name: string;
  span: Span;
  end: number;
  step: number;
  pointer: string;
  stepId: string;
  perPixel(): number;
  onHold(on: boolean): void;
  onChange(span: Span, gesture: string): void;
}

function EventBar({ name, span, end, step, pointer, stepId, perPixel, onHold, onChange }: EventBarProps): JSX.Element {
  const drag = useRef<{ gesture: string; grip: Grip; x: number; span: Span; scale: number } | null>(null);
  const left = Math.min(100, (100 * span.start) / end);
  const right = Math.min(100, (100 * span.end) / end);
  const down = (event: PointerEvent) => {
    if (event.button !== 0) return;
    const bar = event.currentTarget as HTMLElement;
    bar.setPointerCapture(event.pointerId);
    const box = bar.getBoundingClientRect();
    const edge = Math.min(7, box.width / 3);
    const grip: Grip = event.clientX < box.left + edge ? "start" : event.clientX > box.right - edge ? "end" : "both";
    drag.current = { gesture: newGesture(), grip, x: event.clientX, span, scale: perPixel() };
    onHold(true);
    activeItem.value = { step: stepId, pointer };
  };
  const move = (event: PointerEvent) => {
    const now = drag.current;
    if (now) onChange(draggedSpan(now.span, now.grip, (event.clientX - now.x) * now.scale, step), now.gesture);
  };
  const up = () => {
    drag.current = null;
    onHold(false);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const by = event.key === "ArrowRight" ? step : event.key === "ArrowLeft" ? -step : 0;
    if (by === 0) return;
    event.preventDefault();
    event.stopPropagation();
    onChange(draggedSpan(span, event.shiftKey ? "end" : event.ctrlKey ? "start" : "both", by, step), newGesture());
  };
  return (
    <div class="timeline-row">
      <button type="button" class={`timeline-bar${activeItem.value?.pointer === pointer ? " active" : ""}`}
        style={{ left: `${left}%`, width: `${Math.max(1.5, right - left)}%` }}
        aria-label={`${name}, from ${numberText(span.start)} ${isEndless(span) ? "on" : `to ${numberText(span.end)}`}`}
        onPointerDown={down} onPointerMove={move} onPointerUp={up} onPointerCancel={up} onKeyDown={onKeyDown}
        onClick={() => { activeItem.value = { step: stepId, pointer }; }}><span class="ellipsis">{name}</span></button>
    </div>
  );
}

interface PlayProps {
  time: Field;
  runs: number;
  end: number;
  step: number;
}

function PlayMark({ time, runs, end, step, perPixel }: PlayProps & { perPixel(): number }): JSX.Element {
  const drag = useRef<{ gesture: string; x: number; runs: number; scale: number } | null>(null);
  const set = (to: number, gesture: string, before: number) =>
    setField(time, Math.min(time.info.max ?? Infinity, Math.max(0, Math.round(to / step) * step)), gesture, before);
  return (
    <span class="timeline-now" style={{ left: `${Math.min(100, (100 * runs) / end)}%` }}
      data-help={`${titleOf(time.info.name)}: drag to change`}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { gesture: newGesture(), x: event.clientX, runs, scale: perPixel() };
      }}
      onPointerMove={(event) => {
        const now = drag.current;
        if (now) set(now.runs + (event.clientX - now.x) * now.scale, now.gesture, now.runs);
      }}
      onPointerUp={() => { drag.current = null; }} onPointerCancel={() => { drag.current = null; }} />
  );
}

/** Plays as results come: the next step once the one before is there. All of it is one gesture. */
function PlayButton({ time, runs, end, step }: PlayProps): JSX.Element {
  const [playing, setPlaying] = useState<{ gesture: string; before: number } | null>(null);
  const settled = time.scope.studio.engine.value.settled;
  const stride = Math.max(step, Math.round(end / 40 / step) * step);
  useEffect(() => {
    if (!playing || !settled) return;
    const timer = window.setTimeout(() => setField(time, nextTime(runs, Math.floor(end), stride), playing.gesture,
      playing.before), 200);
    return () => window.clearTimeout(timer);
  }, [playing, settled, runs]);
  return (
    <div class="timeline-play">
      <button type="button" class="plain icon small" aria-label={playing ? "Pause" : "Play"}
        aria-pressed={playing !== null}
        onClick={() => setPlaying(playing ? null : { gesture: newGesture(), before: runs })}>{playing
        ? <Pause /> : <Play />}</button>
      <span class="muted">{titleOf(time.info.name)} {numberText(runs)}</span>
    </div>
  );
}
