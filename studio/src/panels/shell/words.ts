// Numbers and names as people read them.

const kByteUnits = ["bytes", "kB", "MB", "GB"];

export function bytesText(bytes: number): string {
  let unit = 0, value = bytes;
  while (value >= 999.5 && unit < kByteUnits.length - 1) {
    value /= 1000;
    ++unit;
  }
  const digits = unit === 0 || value >= 99.5 ? 0 : 1;
  return `${value.toFixed(digits)} ${kByteUnits[unit]}`;
}

/** "3 s", "2 min", "1 h 5 min": no finer than it can be known. */
export function durationText(seconds: number): string {
  if (seconds < 10) return `${Math.max(1, Math.round(seconds))} s`;
  if (seconds < 55) return `${Math.round(seconds / 5) * 5} s`;
  const minutes = Math.max(1, Math.round(seconds / 60));
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/** Thousands are set off by a thin space. */
export function numberText(value: number, digits = 0): string {
  const [whole, fraction] = Math.abs(value).toFixed(digits).split(".");
  const grouped = whole!.replace(/\B(?=(\d{3})+$)/g, "\u2009");
  const negative = value < 0 && Number(Math.abs(value).toFixed(digits)) !== 0;
  return `${negative ? "−" : ""}${grouped}${fraction ? `.${fraction}` : ""}`;
}

export function baseName(path: string): string {
  return path.slice(path.lastIndexOf("/") + 1);
}

/** "hydrology.rivers" reads "Rivers". */
export function operatorTitle(op: string): string {
  const name = op.slice(op.indexOf(".") + 1).replace(/_/g, " ");
  return name.charAt(0).toUpperCase() + name.slice(1);
}

/** An id for a new step that no step has: "import", "import_2". */
export function freeId(wanted: string, taken: readonly string[]): string {
  const base = wanted.replace(/[^A-Za-z0-9_]+/g, "_") || "step";
  for (let i = 1; ; ++i) {
    const id = i === 1 ? base : `${base}_${i}`;
    if (!taken.includes(id)) return id;
  }
}
