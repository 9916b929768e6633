// What a hand draws becomes a few good points: the pen's jitter goes, corners stay, a long stroke has some dozens of
// points, and coordinates are as round as the screen allows.
import {
  keptPoints, mix, rounded, roundedPoint, roundingStep, simpleRing, simplified, toSegment, type Point,
} from "./geometry";

export interface Sample {
  x: number;
  y: number;
  /** 0 to 1. */
  pressure: number;
}

export interface FitOptions {
  /** Metres of a screen pixel and of a cell: nothing finer is worth a point. */
  pixel_m: number;
  cell_m: number;
  /** A stroke never has more points. */
  most?: number;
}

/** How far a fitted line may lie from the drawn one. */
export function tolerance({ pixel_m, cell_m }: FitOptions): number {
  return Math.max(pixel_m, cell_m / 4);
}

const place = (s: Sample): Point => [s.x, s.y];

/** Samples at equal distances along the way; the last one is kept where it was. */
function resampled(samples: readonly Sample[], step: number): Sample[] {
  const result = [samples[0]!];
  let last = samples[0]!;
  for (const next of samples.slice(1)) {
    for (let way = Math.hypot(next.x - last.x, next.y - last.y); way >= step; way -= step) {
      const share = step / way;
      const [x, y] = mix(place(last), place(next), share);
      last = { x, y, pressure: last.pressure + (next.pressure - last.pressure) * share };
      result.push(last);
    }
  }
  const end = samples[samples.length - 1]!;
  if (Math.hypot(end.x - last.x, end.y - last.y) > step / 4) result.push(end);
  else if (result.length > 1) result[result.length - 1] = end;
  return result;
}

function calmed(samples: readonly Sample[]): Sample[] {
  return samples.map((s, i) => {
    const before = samples[i - 1];
    const after = samples[i + 1];
    if (!before || !after) return s;
    return {
      x: (before.x + 2 * s.x + after.x) / 4,
      y: (before.y + 2 * s.y + after.y) / 4,
      pressure: (before.pressure + 2 * s.pressure + after.pressure) / 4,
    };
  });
}

/** Splits what is longer than a tenth of a bent stroke, so that splines through the points stay on the drawn line. */
function evened(samples: readonly Sample[], kept: readonly number[]): number[] {
  if (kept.length < 3) return [...kept];
  const longest = Math.max(3, Math.ceil(samples.length / 10));
  const result = [kept[0]!];
  for (const next of kept.slice(1)) {
    const from = result[result.length - 1]!;
    const parts = Math.ceil((next - from) / longest);
    for (let part = 1; part <= parts; ++part) result.push(from + Math.round(((next - from) * part) / parts));
  }
  return result;
}

/** The points of a stroke. One sample, or a stroke shorter than a pixel, stays one point. */
export function fitStroke(samples: readonly Sample[], options: FitOptions): Sample[] {
  const known = samples.filter((s) => Number.isFinite(s.x) && Number.isFinite(s.y));
  if (known.length === 0) return [];
  const least = tolerance(options);
  let way = resampled(known, 2 * options.pixel_m);
  for (let round = 0; round < 4; ++round) way = calmed(way);
  const most = options.most ?? 60;
  let within = least;
  let kept = keptWithin(way, within);
  for (let round = 0; kept.length > most && round < 24; ++round) kept = keptWithin(way, (within *= 1.3));
  if (kept.length * 2 < most) kept = evened(way, kept);
  const step = roundingStep(least);
  return kept.map((i) => {
    const { x, y, pressure } = way[i]!;
    return { x: rounded(x, step), y: rounded(y, step), pressure: rounded(pressure, 0.01) };
  });
}

/** A twentieth of the pressure counts as much as the tolerance. */
function keptWithin(way: readonly Sample[], within: number): number[] {
  const weight = within / 0.05;
  return keptPoints(way, within, (p, a, b) => {
    const { distance, share } = toSegment(place(p), place(a), place(b));
    return Math.hypot(distance, weight * (p.pressure - a.pressure - share * (b.pressure - a.pressure)));
  });
}

export function fitLine(samples: readonly Sample[], options: FitOptions): Point[] {
  return fitStroke(
    samples.map((s) => ({ ...s, pressure: 1 })),
    options,
  ).map(place);
}

/** A ring drawn in one go: closed, not crossing itself, of at most `most` points; fewer than three where it is none. */
export function fitRing(samples: readonly Sample[], options: FitOptions): Point[] {
  const open = fitLine(samples, { ...options, most: 240 });
  const most = options.most ?? 60;
  let ring = simplified(simpleRing(open), tolerance(options), true);
  for (let within = tolerance(options); ring.length > most; ring = simplified(ring, (within *= 1.3), true));
  const step = roundingStep(tolerance(options));
  return ring.map((point) => roundedPoint(point, step));
}
