// The window through which a curve is seen: which part of the plane, how it maps to pixels, where its axes are marked.
import type { CurveBounds } from "./knots";
import type { Knot } from "./monotone";

export interface View {
  x: readonly [number, number];
  y: readonly [number, number];
  width: number;
  height: number;
}

export const MARGIN = { left: 40, right: 8, top: 8, bottom: 20 } as const;

export function toPixel(view: View, [x, y]: Knot): [number, number] {
  const w = view.width - MARGIN.left - MARGIN.right;
  const h = view.height - MARGIN.top - MARGIN.bottom;
  return [MARGIN.left + ((x - view.x[0]) / (view.x[1] - view.x[0])) * w,
    MARGIN.top + ((view.y[1] - y) / (view.y[1] - view.y[0])) * h];
}

export function fromPixel(view: View, px: number, py: number): Knot {
  const w = view.width - MARGIN.left - MARGIN.right;
  const h = view.height - MARGIN.top - MARGIN.bottom;
  return [view.x[0] + ((px - MARGIN.left) / w) * (view.x[1] - view.x[0]),
    view.y[1] - ((py - MARGIN.top) / h) * (view.y[1] - view.y[0])];
}

/** All of a short range of values; of a long one what the knots need, with room above and below. */
export function viewedValues(knots: readonly Knot[], bounds: CurveBounds): readonly [number, number] {
  const [low, high] = bounds.y;
  if (Number.isFinite(low) && Number.isFinite(high) && high - low <= 10) return bounds.y;
  const values = knots.map((knot) => knot[1]);
  const least = Math.min(0, ...values);
  const most = Math.max(0, ...values);
  const room = Math.max((most - least) * 0.12, most === least ? 1 : 0);
  return [Math.max(low, least < 0 ? least - room : Math.max(low, 0)), Math.min(high, most + room)];
}

/** Round values in a range, about `count` of them. */
export function ticks([low, high]: readonly [number, number], count: number): number[] {
  const rough = (high - low) / Math.max(1, count);
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * decade).find((candidate) => candidate >= rough * 0.999)
    ?? rough;
  const found: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9);
    i * step <= high + step * 1e-9; ++i) found.push(Number((i * step).toPrecision(9)));
  return found;
}

/** Step of a key press along an axis: an even hundredth of what is seen. */
export function keyStep([low, high]: readonly [number, number], fine: boolean): number {
  const rough = (high - low) / (fine ? 1000 : 100);
  const decade = 10 ** Math.floor(Math.log10(rough) + 1e-9);
  return [5, 2, 1].map((factor) => factor * decade).find((step) => step <= rough * (1 + 1e-9)) ?? rough;
}

/** The path of a function seen through a view, a point for every other pixel. */
export function curvePath(view: View, f: (x: number) => number): string {
  const points: string[] = [];
  const columns = Math.max(2, Math.floor((view.width - MARGIN.left - MARGIN.right) / 2));
  for (let i = 0; i <= columns; ++i) {
    const x = view.x[0] + (i / columns) * (view.x[1] - view.x[0]);
    const [px, py] = toPixel(view, [x, f(x)]);
    points.push(`${px.toFixed(1)} ${py.toFixed(1)}`);
  }
  return `M${points.join("L")}`;
}
