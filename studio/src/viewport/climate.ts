// What the ground's natural colours follow: how warm and wet it is, where trees end and snow stays, which rock it is.
// Chosen, or from the latitude where the terrain's system tells it, in the round figures of the C++ renderer
// (src/seamount/ops/render/climate.h), whose presets these are.
import type { Frame } from "../api/types";

export type ClimateChoice = "automatic" | "tropical" | "temperate" | "arid" | "polar";

export const climateNames: readonly (readonly [ClimateChoice, string, string])[] = [
  ["automatic", "By its place", "by the terrain's latitude; without one of a warm sea, or temperate inland"],
  ["tropical", "Tropical", "rain forest up to the clouds"],
  ["temperate", "Temperate", "meadows and woods, bare rock above, snow on high mountains"],
  ["arid", "Arid", "bare rock and sand, hardly any green"],
  ["polar", "Polar", "tundra along the coast under ice and snow"],
];

export interface Climate {
  /** Degrees, south negative. */
  latitude: number;
  /** Mean of the year at the sea's level, degrees Celsius. */
  seaLevel_c: number;
  rain_mm: number;
  /** Bearing that the wind brings rain from, degrees. */
  windFrom_deg: number;
  /** Metres over the sea. */
  snowLine: number;
  treeLine: number;
  /** Else granite. */
  basalt: boolean;
}

type Knots = readonly (readonly [latitude: number, value: number])[];
const snow: Knots = [
  [0, 4750], [18, 5200], [28, 5800], [37, 4000], [47, 2850], [62, 1700], [67, 1250], [78, 450], [90, 0],
];
const trees: Knots = [[0, 3900], [28, 4000], [37, 3000], [47, 2000], [62, 1100], [67, 700], [73, 1], [90, 1]];
const warmth: Knots = [[0, 26.5], [15, 26], [30, 20], [45, 11], [60, 2.5], [75, -9], [90, -18]];
const rain: Knots = [[0, 2200], [20, 1900], [32, 1000], [45, 950], [60, 750], [75, 300], [90, 150]];

const presets: { readonly [choice in ClimateChoice]?: readonly [latitude: number, rain_mm: number] } = {
  tropical: [8, 5000], temperate: [46, 1100], arid: [27, 90], polar: [82, 350],
};

function between(knots: Knots, latitude: number): number {
  const at = Math.min(90, Math.abs(latitude));
  let i = 1;
  while (i + 1 < knots.length && knots[i]![0] < at) ++i;
  const [a, low] = knots[i - 1]!, [b, high] = knots[i]!;
  return low + ((high - low) * (at - a)) / (b - a);
}

/** Degrees, of zones of UTM and of degrees; null: the system does not say. */
export function latitudeOf(frame: Frame): number | null {
  const middle = frame.north - (frame.rows * frame.cell_m) / 2;
  const utm = /^EPSG:32([67])(\d\d)$/.exec(frame.crs);
  if (utm !== null) return (utm[1] === "6" ? middle : middle - 1e7) / 110_900;
  const named = /(\d+(?:\.\d+)?) ([NS])\b/.exec(frame.crs);
  return named === null ? null : Number(named[1]) * (named[2] === "N" ? 1 : -1);
}

export function climateOf(frame: Frame, inSea: boolean, choice: ClimateChoice = "automatic"): Climate {
  const preset = presets[choice], latitude = preset?.[0] ?? latitudeOf(frame) ?? (inSea ? -18 : 45);
  const trades = Math.abs(latitude) < 30;
  return {
    latitude,
    seaLevel_c: between(warmth, latitude),
    rain_mm: preset?.[1] ?? between(rain, latitude),
    // Trade winds blow towards the equator and the west, westerlies towards the pole and the east.
    windFrom_deg: latitude >= 0 ? (trades ? 65 : 250) : trades ? 115 : 290,
    snowLine: between(snow, latitude),
    treeLine: between(trees, latitude),
    basalt: inSea && trades,
  };
}
