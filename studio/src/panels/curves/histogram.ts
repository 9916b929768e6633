// Bars under a brush: those between two places of the pen get the heights on the line between them.

export interface PenPlace {
  bar: number;
  /** 0 at the bottom, 1 at the top. */
  share: number;
}

export function painted(values: readonly number[], from: PenPlace, to: PenPlace, top: number): number[] {
  const first = Math.min(from.bar, to.bar);
  const last = Math.max(from.bar, to.bar);
  return values.map((value, i) => {
    if (i < first || i > last) return value;
    const t = from.bar === to.bar ? 1 : (i - from.bar) / (to.bar - from.bar);
    return Number(((from.share + t * (to.share - from.share)) * top).toPrecision(3));
  });
}
