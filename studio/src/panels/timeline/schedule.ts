// Times of events: what lies where on a time line, and how a drag changes begin and end.

export interface Span {
  start: number;
  end: number;
}

export type Grip = "start" | "end" | "both";

/** An end later than this means "for ever". */
const ENDLESS = 1e8;

export function isEndless(span: Span): boolean {
  return span.end >= ENDLESS;
}

/** Length of the time that is shown: all events, and what runs, with some room. */
export function shownEnd(spans: readonly Span[], runs: number): number {
  const last = Math.max(runs, 1, ...spans.map((span) => (isEndless(span) ? span.start + 1 : span.end)));
  return niceEnd(last * 1.02);
}

function niceEnd(value: number): number {
  const decade = 10 ** Math.floor(Math.log10(value));
  const factor = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((even) => even * decade >= value) ?? 10;
  return factor * decade;
}

/** Marks from 0 to `end`, at most `most` of them. */
export function marks(end: number, most: number): number[] {
  const decade = 10 ** Math.floor(Math.log10(end / Math.max(1, most)));
  const step = [1, 2, 5, 10].map((factor) => factor * decade).find((candidate) => end / candidate <= most) ?? end;
  const count = Math.floor(end / step + 1e-9);
  return Array.from({ length: count + 1 }, (_, i) => Number((i * step).toPrecision(6)));
}

/** A span after a drag by `by`: whole steps, not before 0, at least one step long. */
export function draggedSpan(span: Span, grip: Grip, by: number, step: number): Span {
  const snap = (value: number) => Number((Math.round(value / step) * step).toPrecision(9));
  if (grip === "start") return { ...span, start: Math.max(0, Math.min(snap(span.start + by), span.end - step)) };
  if (grip === "end") return { ...span, end: Math.max(span.start + step, snap(span.end + by)) };
  const start = Math.max(0, snap(span.start + by));
  return { start, end: isEndless(span) ? span.end : Number((start + span.end - span.start).toPrecision(9)) };
}

/** The next time that is played: from the end on from the beginning. */
export function nextTime(time: number, end: number, step: number): number {
  return time + step > end ? 0 : Number((time + step).toPrecision(9));
}
