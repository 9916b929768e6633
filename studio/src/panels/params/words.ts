// Words and numbers as the panels show them: parameters' titles, amounts with units, values for the history.
import type { Json, ParamInfo } from "../../api/types";
import { unitText } from "./units";

const SUFFIX = /_(m|km|m2|km2|deg|px|yr|m_s|m_yr|mm_yr|m2_yr|per_km2|per_km|km2|1_m)$/;

/** Names that say too little by themselves. */
const TITLES: { readonly [name: string]: string } = { cell_m: "Cell size", crs: "Coordinates", x_m: "East",
  y_m: "North" };

/** "peak_m" is "Peak": the unit stands beside the number. */
export function titleOf(name: string): string {
  const known = TITLES[name];
  if (known) return known;
  const words = name.replace(SUFFIX, "").replace(/_/g, " ").trim();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Words of a choice: "by_size" is "by size". */
export function wordOf(choice: string): string {
  return choice.replace(/_/g, " ");
}

/** At most five digits, no noise behind them; very large and very small ones with an exponent. */
export function numberText(value: number): string {
  if (!Number.isFinite(value)) return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e9) return String(value);
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) return value.toExponential(3).replace(/\.?0+e/, "e")
    .replace("e+", "e");
  return String(Number(value.toPrecision(5)));
}

export function amountText(value: number, unit: string): string {
  const shown = unitText(unit);
  return numberText(value) + (shown === "" ? "" : shown === "°" || shown === "%" ? shown : ` ${shown}`);
}

/** A value for the history, short: "0.4", "on", "3 items". */
export function valueText(value: Json | undefined, info?: Pick<ParamInfo, "unit">): string {
  if (value === undefined) return "default";
  if (value === null) return "auto";
  if (typeof value === "number") return amountText(value, info?.unit ?? "");
  if (typeof value === "boolean") return value ? "on" : "off";
  if (typeof value === "string") return value === "" ? "none" : value.length > 24 ? `${value.slice(0, 23)}…` : value;
  if (Array.isArray(value)) {
    if (value.length === 2 && value.every((item) => typeof item === "number")) return value.map((n) =>
      numberText(n as number)).join(", ");
    return `${value.length} ${value.length === 1 ? "item" : "items"}`;
  }
  return "changed";
}

/** "reef: subsidence 0.2 → 0.4". */
export function changeLabel(owner: string, info: ParamInfo, before: Json | undefined, after: Json | undefined): string {
  const name = titleOf(info.name).toLowerCase();
  if (info.kind === "curve" || (Array.isArray(before) && Array.isArray(after)
    && valueText(before) === valueText(after))) return `${owner}: ${name} changed`;
  return `${owner}: ${name} ${valueText(before, info)} → ${valueText(after, info)}`;
}

export function counted(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

/** "3.2 s", "480 ms", "2 min 5 s". */
export function secondsText(seconds: number): string {
  if (seconds < 0.001) return "";
  if (seconds < 1) return `${Math.max(1, Math.round(seconds * 1000))} ms`;
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
}

export function bytesText(bytes: number): string {
  const units = ["B", "KiB", "MiB", "GiB", "TiB"];
  let size = bytes;
  let i = 0;
  while (size >= 1024 && i + 1 < units.length) {
    size /= 1024;
    ++i;
  }
  return `${size >= 10 || i === 0 ? Math.round(size) : size.toFixed(1)} ${units[i]}`;
}

/** Metres as people say them: "3.2 km", "45 m". */
export function distanceText(metres: number): string {
  return metres >= 1000 ? `${numberText(Number((metres / 1000).toPrecision(3)))} km`
    : `${numberText(Number(metres.toPrecision(3)))} m`;
}

export function areaText(square: number): string {
  return square >= 1e5 ? `${numberText(Number((square / 1e6).toPrecision(3)))} km²`
    : `${numberText(Number(square.toPrecision(3)))} m²`;
}
