// A value in the bar of options: a name, a slider where there is a range, and the number itself, which can be typed.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Json, ParamInfo } from "../api/types";
import type { Domain } from "./place";
import { isReach } from "./active";

export interface Range {
  least: number;
  most: number;
  log: boolean;
  step: number;
}

/** The range of a slider; null: no slider. */
export function sliderRange(member: ParamInfo, domain: Domain, iterations = 100): Range | null {
  const side = Math.min(domain.width_m, domain.height_m);
  const least = member.min ?? -Infinity;
  const most = member.max ?? Infinity;
  if (member.kind === "integer") {
    const end = member.name === "after" ? iterations : Math.min(most, 16);
    return { least: Math.max(least, 0), most: end, log: false, step: 1 };
  }
  if (member.kind !== "number") return null;
  if (isReach(member) || /_m$/.test(member.name) && least > 0) {
    const from = Math.max(least, domain.cell_m / 2, 0.01);
    return { least: from, most: Math.max(from * 2, Math.min(most, side / 2)), log: true, step: 0 };
  }
  if (most - least <= 2.5) return { least, most, log: false, step: 0.01 };
  if (/_deg$/.test(member.name)) return { least: Math.max(least, -180), most: Math.min(most, 180), log: false, step: 1 };
  if (member.name === "strength_m") return { least: -side / 10, most: side / 10, log: false, step: 10 };
  if (/^(depth_m|amplitude_m)$/.test(member.name) || (member.name === "height_m" && least === 0)) {
    return { least: 0, most: Math.min(most, Math.max(200, side / 20)), log: false, step: side > 4000 ? 5 : 0.5 };
  }
  return null;
}

const toSlider = (value: number, { least, most, log }: Range) =>
  log ? (1000 * Math.log(Math.max(value, least) / least)) / Math.log(most / least) : (1000 * (value - least)) / (most - least);

function fromSlider(at: number, { least, most, log, step }: Range): number {
  const value = log ? least * (most / least) ** (at / 1000) : least + ((most - least) * at) / 1000;
  if (log) return Number(value.toPrecision(2));
  return Number((Math.round(value / step) * step).toFixed(4));
}

/** "1.2 km", "2*450", "-30". NaN: none. */
export function readNumber(text: string): number {
  const match = /^\s*(-?\d*\.?\d+(?:e-?\d+)?)\s*(?:([*/+-])\s*(-?\d*\.?\d+))?\s*(km|m|cm|°|%)?\s*$/i.exec(text.replace(",", "."));
  if (!match) return NaN;
  const [, first, sign, second, unit] = match;
  const [a, b] = [Number(first), Number(second ?? 0)];
  const value = sign === "*" ? a * b : sign === "/" ? a / b : sign === "+" ? a + b : sign === "-" ? a - b : a;
  return unit?.toLowerCase() === "km" ? value * 1000 : unit?.toLowerCase() === "cm" ? value / 100 : value;
}

export function titleOf(name: string): string {
  const words = name.replace(/_(m|deg|m2|m_s|m2_yr)$/, "").replace(/_/g, " ");
  return words[0]!.toUpperCase() + words.slice(1);
}

const clamp = (value: number, member: ParamInfo) => Math.min(member.max ?? Infinity, Math.max(member.min ?? -Infinity, value));

interface Props {
  member: ParamInfo;
  value: Json;
  range: Range | null;
  /** `gesture`: edits of one drag share it. */
  change(value: Json, gesture: string): void;
}

function NumberValue({ member, value, range, change }: Props) {
  const shown = typeof value === "number" ? String(Number(value.toFixed(3))) : "";
  const [text, setText] = useState(shown);
  const gesture = useRef("");
  const newGesture = () => (gesture.current = `option-${member.name}-${Date.now()}`);
  useEffect(() => setText(shown), [shown]);
  const typed = (input: string) => {
    if (input.trim() === "" && member.default === null) return change(null, newGesture());
    const number = readNumber(input);
    if (Number.isNaN(number)) return setText(shown);
    change(member.kind === "integer" ? Math.round(clamp(number, member)) : clamp(number, member), newGesture());
  };
  return (
    <>
      {range && (
        <input type="range" min={0} max={1000} value={toSlider(typeof value === "number" ? value : range.least, range)}
          aria-label={titleOf(member.name)} onPointerDown={newGesture}
          onInput={(event) => change(clamp(fromSlider(Number(event.currentTarget.value), range), member), gesture.current)} />
      )}
      <span class="tool-number">
        <input type="text" inputMode="decimal" value={text} placeholder="auto" aria-label={`${titleOf(member.name)}, number`}
          onInput={(event) => setText(event.currentTarget.value)} onChange={(event) => typed(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === "Escape") {
              setText(shown);
              event.currentTarget.blur();
            }
            event.stopPropagation();
          }} />
        {member.unit && <span class="muted">{member.unit}</span>}
      </span>
    </>
  );
}

export function Field(props: Props) {
  const { member, value, change } = props;
  const title = titleOf(member.name);
  const now = () => `option-${member.name}-${Date.now()}`;
  let control;
  if (member.kind === "switch") {
    control = <input type="checkbox" checked={value === true} onChange={(event) => change(event.currentTarget.checked, now())} />;
  } else if (member.kind === "choice") {
    control = (
      <select value={String(value)} onChange={(event) => change(event.currentTarget.value, now())}>
        {(member.choices ?? []).map((choice) => <option key={choice} value={choice}>{titleOf(choice)}</option>)}
      </select>
    );
  } else if (member.kind === "text" || member.kind === "file") {
    control = (
      <input type="text" class="tool-text" value={String(value ?? "")} placeholder={member.kind === "file" ? "file" : ""}
        onKeyDown={(event) => event.stopPropagation()} onChange={(event) => change(event.currentTarget.value, now())} />
    );
  } else control = <NumberValue {...props} />;
  return (
    <label class="tool-field" title={member.help}>
      <span class="muted">{title}</span>
      {control}
    </label>
  );
}
