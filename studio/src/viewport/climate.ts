// What the ground's natural colours follow: how warm it is, where trees end and snow stays. From the latitude where the
// terrain's system tells it, in the round figures of the C++ renderer (src/seamount/ops/render/climate.cpp).
import type { Frame } from "../api/types";

export interface Climate {
  /** Warm enough for reefs and rain forest. */
  tropical: boolean;
  /** Metres over the sea. */
  snowLine: number;
  treeLine: number;
}

type Knots = readonly (readonly [latitude: number, metres: number])[];
const snow: Knots = [
  [0, 4750], [18, 5200], [28, 5800], [37, 4000], [47, 2850], [62, 1700], [67, 1250], [78, 450], [90, 0],
];
const trees: Knots = [[0, 3900], [28, 4000], [37, 3000], [47, 2000], [62, 1100], [67, 700], [73, 1], [90, 1]];

function between(knots: Knots, latitude: number): number {
  let i = 1;
  while (i + 1 < knots.length && knots[i]![0] < latitude) ++i;
  const [a, low] = knots[i - 1]!, [b, high] = knots[i]!;
  return low + ((high - low) * (latitude - a)) / (b - a);
}

/** Degrees, of zones of UTM and of degrees; null: the system does not say. */
export function latitudeOf(frame: Frame): number | null {
  const middle = frame.north - (frame.rows * frame.cell_m) / 2;
  const utm = /^EPSG:32([67])(\d\d)$/.exec(frame.crs);
  if (utm !== null) return (utm[1] === "6" ? middle : middle - 1e7) / 110_900;
  const named = /(\d+(?:\.\d+)?) ([NS])\b/.exec(frame.crs);
  return named === null ? null : Number(named[1]) * (named[2] === "N" ? 1 : -1);
}

export function climateOf(frame: Frame, inSea: boolean): Climate {
  const latitude = Math.min(90, Math.abs(latitudeOf(frame) ?? (inSea ? 18 : 45)));
  return { tropical: latitude < 30 && inSea, snowLine: between(snow, latitude), treeLine: between(trees, latitude) };
}
