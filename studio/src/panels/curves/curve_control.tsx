// Parameters that are curves, with what is known of them: what their x means, how they begin, how they run.
import type { JSX } from "preact";
import { ChartSpline } from "lucide-preact";
import { type Field, fieldOf, setField } from "../params/scope";
import { titleOf } from "../params/words";
import { CurveEditor } from "./curve_editor";
import { type CurveBounds, readKnots } from "./knots";
import type { CurveKind, Knot } from "./monotone";

const REGIONS = [
  { name: "mountain", colour: "var(--mountain)" }, { name: "beach", colour: "var(--beach)" },
    { name: "lagoon", colour: "var(--lagoon)" },
  { name: "reef", colour: "var(--reef)" }, { name: "slope", colour: "var(--abyss)" },
] as const;

function isByRegion(field: Field): boolean {
  return /region coordinate/.test(field.info.help);
}

function boundsOf(field: Field): CurveBounds {
  const { min = -Infinity, max = Infinity } = field.info;
  const x: [number, number] = isByRegion(field) ? [0, 5] : [0, 1];
  return { x, y: [min, max], apart: x[1] / 500 };
}

function sibling(field: Field, name: string): unknown {
  const info = field.scope.params.find((param) => param.name === name);
  return info && fieldOf(field.scope, info).value;
}

/** What a curve is that is derived as long as nobody draws it, to begin with. */
function firstKnots(field: Field): Knot[] {
  const number = (name: string, otherwise: number) => {
    const value = sibling(field, name);
    return typeof value === "number" ? value : otherwise;
  };
  if (isByRegion(field) && field.info.unit === "m")
    return [[0, number("peak_m", 900)], [0.5, number("peak_m", 900) * 0.35], [1, 40], [2, 0], [3, -15], [4, -3],
      [5, number("floor_m", -1000)]];
  if (/0 at both/.test(field.info.help)) return [[0, 0], [0.5, 1], [1, 0]];
  if (/density/.test(field.info.name)) return [[0, 1], [0.4, 0.6], [1, 0.05]];
  return [[0, 1], [1, 0]];
}

export function CurveControl({ field }: { field: Field }): JSX.Element {
  const knots = readKnots(field.value);
  const title = titleOf(field.info.name);
  if (knots.length === 0) {
    return (
      <div class="curve-none"><span class="muted">{field.info.help.includes("derived") ? "auto" : "none"}</span>
        <button type="button" class="plain compact" aria-label={`Draw ${title.toLowerCase()}`}
          onClick={() => setField(field, firstKnots(field).map((knot) => [...knot]))}>
          <ChartSpline />Draw a curve</button></div>
    );
  }
  const kind: CurveKind = sibling(field, "interpolation") === "linear" ? "linear" : "monotone_cubic";
  const byRegion = isByRegion(field);
  return <CurveEditor label={title} knots={knots} kind={kind} bounds={boundsOf(field)} unit={field.info.unit}
    bands={byRegion ? REGIONS : undefined}
    xName={byRegion ? "region" : "x"}
    onChange={(next, gesture) => setField(field, next.map((knot) => [...knot]), gesture)} />;
}
