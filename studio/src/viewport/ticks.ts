// Round numbers for scale bars, contour lines and graticules, and how lengths and heights are written.

/** The largest of 1, 2, 5 times a power of ten that is not above x (> 0). */
export function roundDownNice(x: number): number {
  const power = 10 ** Math.floor(Math.log10(x) + 1e-12);
  const mantissa = x / power;
  const digit = mantissa >= 5 - 1e-9 ? 5 : mantissa >= 2 - 1e-9 ? 2 : 1;
  return digit * power;
}

/** The smallest of 1, 2, 5 times a power of ten that is not below x (> 0). */
export function roundUpNice(x: number): number {
  const below = roundDownNice(x);
  if (below >= x * (1 - 1e-9)) return below;
  const mantissa = below / 10 ** Math.floor(Math.log10(below) + 1e-9);
  return mantissa < 1.5 ? below * 2 : mantissa < 3 ? below * 2.5 : below * 2;
}

/** Length of the scale bar: the longest round one that fits. */
export function scaleBarLength(pixel_m: number, most_px: number): number {
  return roundDownNice(Math.max(1e-9, pixel_m * most_px));
}

/** Interval of contour lines: as many on a typical slope as stand `gap_px` apart; heavy lines are every fifth. */
export function contourInterval(pixel_m: number, typicalSlope: number, gap_px = 26): number {
  const rise = pixel_m * gap_px * Math.max(0.02, typicalSlope);
  return Math.max(1, roundUpNice(rise));
}

/** Step of a graticule whose lines are at least `gap_px` apart. */
export function gridStep(pixel_m: number, gap_px = 90): number {
  return roundUpNice(pixel_m * gap_px);
}

/** Multiples of a step inside [from, to]. */
export function multiples(from: number, to: number, step: number): number[] {
  const result: number[] = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step && result.length < 1000; ++i) {
    result.push(i * step);
  }
  return result;
}

function digits(value: number): string {
  const text = Number(Math.abs(value).toPrecision(6)).toString();
  const [whole = "0", rest] = text.split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u2009") : whole;
  return (value < 0 ? "\u2212" : "") + grouped + (rest === undefined ? "" : `.${rest}`);
}

/** "250 m", "1.5 km". */
export function lengthText(metres: number): string {
  return Math.abs(metres) >= 1000 ? `${digits(metres / 1000)}\u202fkm` : `${digits(metres)}\u202fm`;
}

/** "1 240 m" with a true minus; tenths below 100 m. */
export function heightText(metres: number): string {
  return `${digits(Math.abs(metres) < 100 ? Math.round(metres * 10) / 10 : Math.round(metres))}\u202fm`;
}

/** A number of some field for a legend: at most three figures. */
export function fieldText(value: number): string {
  const size = Math.abs(value);
  if (value !== 0 && (size >= 1e6 || size < 1e-3)) return value.toExponential(1).replace("-", "\u2212");
  return digits(Number(value.toPrecision(3)));
}
