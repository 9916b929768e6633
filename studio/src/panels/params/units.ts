// Units of quantities: what a unit's text means ("mm/yr", "1/km2"), and how much of one is one of another.

/** Exponents of length, time, angle and pixels; the factor turns an amount into metres, years, degrees, pixels. */
export interface Unit {
  factor: number;
  powers: readonly [length: number, time: number, angle: number, pixels: number];
}

const length = (factor: number): Unit => ({ factor, powers: [1, 0, 0, 0] });
const time = (factor: number): Unit => ({ factor, powers: [0, 1, 0, 0] });
const angle = (factor: number): Unit => ({ factor, powers: [0, 0, 1, 0] });
const SECONDS_A_YEAR = 31557600;

const UNITS: { readonly [name: string]: Unit } = {
  mm: length(0.001), cm: length(0.01), m: length(1), km: length(1000), ft: length(0.3048), mi: length(1609.344),
  nm: length(1852),
  s: time(1 / SECONDS_A_YEAR), h: time(3600 / SECONDS_A_YEAR), d: time(86400 / SECONDS_A_YEAR), yr: time(1),
  year: time(1), years: time(1), a: time(1), kyr: time(1000), ka: time(1000), myr: time(1e6), ma: time(1e6),
  deg: angle(1), "°": angle(1), rad: angle(180 / Math.PI),
  ha: { factor: 1e4, powers: [2, 0, 0, 0] },
  kn: { factor: (1852 / 3600) * SECONDS_A_YEAR, powers: [1, -1, 0, 0] },
  px: { factor: 1, powers: [0, 0, 0, 1] },
  "%": { factor: 0.01, powers: [0, 0, 0, 0] },
};

export const NO_UNIT: Unit = { factor: 1, powers: [0, 0, 0, 0] };

export function sameDimension(a: Unit, b: Unit): boolean {
  return a.powers.every((power, i) => power === b.powers[i]);
}

export function multiplied(a: Unit, b: Unit, sign: 1 | -1): Unit {
  const power = (i: 0 | 1 | 2 | 3) => a.powers[i] + sign * b.powers[i];
  return { factor: a.factor * b.factor ** sign, powers: [power(0), power(1), power(2), power(3)] };
}

/** One name with an exponent behind it: "m2", "km", "yr-1"; null: there is no such unit. */
function readFactor(text: string): Unit | null {
  const parts = /^([a-zA-Z°%]+?)(-?\d)?$/.exec(text.replace("²", "2").replace("³", "3"));
  if (!parts) return text === "1" ? NO_UNIT : null;
  const name = parts[1] ?? "";
  const unit = UNITS[name] ?? UNITS[name.toLowerCase()];
  if (!unit) return null;
  const exponent = parts[2] === undefined ? 1 : Number(parts[2]);
  const [l, t, a, p] = unit.powers;
  return { factor: unit.factor ** exponent, powers: [l * exponent, t * exponent, a * exponent, p * exponent] };
}

/** "m", "mm/yr", "1/km2", "m/yr/km"; null: not one of these. "" has no dimension. */
export function readUnit(text: string): Unit | null {
  if (text === "") return NO_UNIT;
  let unit = NO_UNIT;
  for (const [i, part] of text.split("/").entries()) {
    const factor = readFactor(part.trim());
    if (!factor) return null;
    unit = multiplied(unit, factor, i === 0 ? 1 : -1);
  }
  return unit;
}

/** How a unit is written beside a number: "m²", "°". */
export function unitText(unit: string): string {
  if (unit === "deg") return "°";
  return unit.replace(/([a-z])2/g, "$1²").replace(/([a-z])3/g, "$1³");
}
