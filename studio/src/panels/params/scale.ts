// Sliders: how the way along one is spread over a parameter's range, how coarse a pixel is, and rounding to it.

export interface Scale {
  /** 0 to 1 of a value; beyond the range it is clamped. */
  share(value: number): number;
  value(share: number): number;
}

export interface ScaleOptions {
  min: number;
  max: number;
  /** The default, or what the value is usually like; null: not known. */
  usual: number | null;
  unit: string;
  integer: boolean;
}

const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

function linear(min: number, max: number): Scale {
  return {
    share: (value) => clamp((value - min) / (max - min), 0, 1),
    value: (share) => min + clamp(share, 0, 1) * (max - min),
  };
}

/** Even in the logarithm far from zero, even in the value nearer to it than the knee. */
function bent(min: number, max: number, knee: number): Scale {
  const low = Math.asinh(min / knee);
  const high = Math.asinh(max / knee);
  return {
    share: (value) => clamp((Math.asinh(value / knee) - low) / (high - low), 0, 1),
    value: (share) => clamp(knee * Math.sinh(low + clamp(share, 0, 1) * (high - low)), min, max),
  };
}

function logarithmic(min: number, max: number): Scale {
  const ratio = Math.log(max / min);
  return {
    share: (value) => clamp(Math.log(Math.max(value, min) / min) / ratio, 0, 1),
    value: (share) => clamp(min * Math.exp(clamp(share, 0, 1) * ratio), min, max),
  };
}

/** A scale on which the usual value lies well inside and small values can be set as finely as large ones. */
export function scaleOf({ min, max, usual, unit, integer }: ScaleOptions): Scale {
  const reach = Math.max(Math.abs(min), Math.abs(max));
  const near = usual === null ? 0 : Math.abs(usual);
  if (unit === "deg" || (integer && max - min <= 60)) return linear(min, max);
  if (min > 0) return max / min > 50 ? logarithmic(min, max) : linear(min, max);
  if (max < 0) return min / max > 50 ? bent(min, max, -max) : linear(min, max);
  if (near > 0) return reach / near > 25 ? bent(min, max, near / 4) : linear(min, max);
  return reach > 100 ? bent(min, max, reach / 4000) : linear(min, max);
}

const EVEN = [1, 2, 5, 10];

/** The largest of 1, 2, 5, 10 ... that is no more than `step`. */
export function evenStep(step: number): number {
  if (!(step > 0)) return 1;
  const decade = 10 ** Math.floor(Math.log10(step) + 1e-9);
  const factor = [...EVEN].reverse().find((even) => even * decade <= step * (1 + 1e-9)) ?? 1;
  return Number((factor * decade).toPrecision(12));
}

export function rounded(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toPrecision(12));
}

/** Step that a pixel of dragging makes at `value`: of a slider `width` pixels wide, else a hundredth of the value's
 * magnitude. */
export function pixelStep(value: number, scale: Scale | null, width: number, integer: boolean): number {
  let step: number;
  if (scale) {
    const share = scale.share(value);
    step = Math.abs(scale.value(share + 1 / width) - scale.value(share - 1 / width)) / 2;
    if (share <= 0 || share >= 1) step *= 2;
  } else {
    step = 10 ** Math.floor(Math.log10(Math.max(Math.abs(value), 1e-3))) / 50;
  }
  step = evenStep(step);
  return integer ? Math.max(1, Math.round(step)) : step;
}

export interface Drag {
  start: number;
  /** Pixels to the right of where it began. */
  dx: number;
  width: number;
  /** Ctrl: whole steps, ten times as coarse. Shift: a tenth of the way. */
  snap: boolean;
  fine: boolean;
}

/** Value of a drag along a field. */
export function dragged(drag: Drag, scale: Scale | null,
  bounds: { min?: number; max?: number; integer: boolean }): number {
  const dx = drag.fine ? drag.dx / 10 : drag.dx;
  let value: number;
  if (scale) {
    value = scale.value(scale.share(drag.start) + dx / drag.width);
  } else {
    value = drag.start + dx * pixelStep(drag.start, null, drag.width, bounds.integer);
  }
  let step = pixelStep(value, scale, drag.width, bounds.integer);
  if (drag.snap) step = evenStep(step * 10);
  else if (drag.fine) step = bounds.integer ? 1 : evenStep(step / 10);
  return bounded(rounded(value, step), bounds);
}

export function bounded(value: number, { min, max, integer }: { min?: number; max?: number;
  integer: boolean }): number {
  const whole = integer ? Math.round(value) : value;
  return clamp(whole, min ?? -Infinity, max ?? Infinity);
}

/** What a derived value starts from when it is first dragged. */
export function firstGuess(scale: Scale | null, min: number | undefined, max: number | undefined): number {
  if (scale) {
    const middle = scale.value(0.5);
    return middle === 0 ? 0 : Number(middle.toPrecision(1));
  }
  return min ?? max ?? 0;
}
