// The plain controls of parameters: switch, choice, preset, text, colour, point, lists of numbers and of texts.
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { Plus, X } from "lucide-preact";
import type { Json } from "../../api/types";
import { type Field, newGesture, resetField, setField } from "./scope";
import { NumberField } from "./number_field";
import { amountText, titleOf, wordOf } from "./words";

export interface ControlProps {
  field: Field;
}

const quietly = (field: Field): boolean => field.standing !== "stated" && field.standing !== "variable";
const label = (field: Field): string => titleOf(field.info.name);

export function NumberControl({ field }: ControlProps): JSX.Element {
  const { info, value, fallback } = field;
  return <NumberField label={label(field)} value={typeof value === "number" ? value : null} unit={info.unit}
    min={info.min} max={info.max}
    integer={info.kind === "integer"} usual={typeof fallback === "number" ? fallback : null} help={info.help}
    quiet={quietly(field)}
    onChange={(next, gesture, before) => setField(field, next, gesture, before)}
    onReset={(gesture) => resetField(field, gesture)} />;
}

export function SwitchControl({ field }: ControlProps): JSX.Element {
  const on = field.value === true;
  return (
    <button type="button" role="switch" class="switch" aria-checked={on} aria-label={label(field)}
      aria-description={field.info.help}
      onClick={() => setField(field, !on)}>
      <span class="switch-track"><span class="switch-thumb" /></span>
      <span class="switch-word">{on ? "on" : "off"}</span>
    </button>
  );
}

/** Up to four short words lie side by side; more are a list. */
export function ChoiceControl({ field }: ControlProps): JSX.Element {
  const choices = field.info.choices ?? [];
  const letters = choices.reduce((sum, choice) => sum + choice.length + 3, 0);
  if (choices.length > 4 || letters > 34) {
    return (
      <select class="select" aria-label={label(field)} aria-description={field.info.help}
        value={String(field.value ?? "")}
        onChange={(event) => setField(field, event.currentTarget.value)}>
        {field.value === null && <option value="">auto</option>}
        {choices.map((choice) => <option key={choice} value={choice}>{wordOf(choice)}</option>)}
      </select>
    );
  }
  return <Segments label={label(field)} words={choices} chosen={typeof field.value === "string" ? field.value : null}
    quiet={quietly(field)} onChoose={(choice) => setField(field, choice)} />;
}

interface SegmentsProps {
  label: string;
  words: readonly string[];
  chosen: string | null;
  quiet?: boolean;
  /** Of a preset the chosen word can be let go. */
  free?: boolean;
  about?: (word: string) => string | undefined;
  onChoose(word: string | null): void;
}

/** A row of words of which one is chosen; arrows go from one to the next. */
export function Segments({ label: name, words, chosen, quiet, free, about, onChoose }: SegmentsProps): JSX.Element {
  const onKeyDown = (event: KeyboardEvent) => {
    const by = event.key === "ArrowRight" || event.key === "ArrowDown" ? 1 : event.key === "ArrowLeft"
      || event.key === "ArrowUp" ? -1 : 0;
    if (by === 0 || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const next = words[(words.indexOf(chosen ?? "") + by + words.length) % words.length];
    if (next === undefined) return;
    onChoose(next);
    const row = event.currentTarget as HTMLElement;
    requestAnimationFrame(() => row.querySelector<HTMLElement>("[aria-checked=true]")?.focus());
  };
  return (
    <div class={`segments${quiet ? " quiet" : ""}`} role="radiogroup" aria-label={name} onKeyDown={onKeyDown}>
      {words.map((word, i) => (
        <button key={word} type="button" role="radio" aria-checked={word === chosen}
          tabIndex={word === chosen || (chosen === null && i === 0) ? 0 : -1}
          data-help={about?.(word)}
          onClick={() => onChoose(free && word === chosen ? null : word)}>{wordOf(word)}</button>
      ))}
    </div>
  );
}

export function PresetControl({ field }: ControlProps): JSX.Element {
  const presets = field.info.presets ?? (field.info.choices ?? []).map((name) => ({ name, about: "", values: {} }));
  const chosen = typeof field.stated === "string" ? field.stated : null;
  const about = presets.find((preset) => preset.name === chosen)?.about;
  return (
    <div class="preset">
      <Segments label="Preset" words={presets.map((preset) => preset.name)} chosen={chosen} free
        about={(word) => presets.find((preset) => preset.name === word)?.about}
        onChoose={(word) => (word === null ? resetField(field) : setField(field, word, undefined, chosen ?? "none"))} />
      {about && <p class="note">{about}</p>}
    </div>
  );
}

export function TextControl({ field }: ControlProps): JSX.Element {
  const stated = typeof field.value === "string" ? field.value : "";
  const [text, setText] = useState(stated);
  useEffect(() => setText(stated), [stated]);
  const commit = () => { if (text !== stated) setField(field, text); };
  return <input type="text" class="text" aria-label={label(field)} aria-description={field.info.help} value={text}
    placeholder="none"
    spellcheck={false} onInput={(event) => setText(event.currentTarget.value)} onBlur={commit}
    onKeyDown={(event) => {
      if (event.key === "Enter") commit();
      else if (event.key === "Escape") setText(stated);
      else return;
      event.stopPropagation();
    }} />;
}

export function ColourControl({ field }: ControlProps): JSX.Element {
  const colour = typeof field.value === "string" && /^#[0-9a-f]{6}$/i.test(field.value) ? field.value : "#000000";
  const [gesture, setGesture] = useState(newGesture);
  return (
    <div class="colour">
      <input type="color" value={colour} aria-label={label(field)} aria-description={field.info.help}
        onInput={(event) => setField(field, event.currentTarget.value, gesture)}
        onChange={() => setGesture(newGesture())} />
      <TextControl field={field} />
    </div>
  );
}

/** East and north of a place. */
export function PointControl({ field }: ControlProps): JSX.Element {
  const point = Array.isArray(field.value) ? field.value : [null, null];
  const coordinate = (i: 0 | 1) => (typeof point[i] === "number" ? (point[i] as number) : null);
  const part = (i: 0 | 1, prefix: string, name: string) => (
    <NumberField label={`${label(field)}, ${name}`} value={coordinate(i)} unit={field.info.unit || "m"} prefix={prefix}
      help={field.info.help}
      quiet={quietly(field)} onReset={(gesture) => resetField(field, gesture)} onChange={(next, gesture) => {
        const after: Json = i === 0 ? [next, coordinate(1) ?? 0] : [coordinate(0) ?? 0, next];
        setField(field, after, gesture);
      }} />
  );
  return <div class="point">{part(0, "x", "east")}{part(1, "y", "north")}</div>;
}

export function NumbersControl({ field }: ControlProps): JSX.Element {
  const values = Array.isArray(field.value) ? field.value.filter((item): item is number => typeof item === "number")
    : [];
  const { info } = field;
  const set = (next: number[], gesture?: string) => setField(field, next, gesture);
  return (
    <div class="numbers">
      {values.map((value, i) => (
        <div class="numbers-item" key={i}>
          <NumberField label={`${label(field)} ${i + 1}`} value={value} unit={info.unit} min={info.min} max={info.max}
            integer={info.kind === "integers"}
            onChange={(next, gesture) => set(values.map((old, k) => (k === i ? next : old)), gesture)} />
          <button type="button" class="plain icon small" aria-label={`Remove ${amountText(value, info.unit)}`}
            onClick={() => set(values.filter((_, k) => k !== i))}><X size={12} /></button>
        </div>
      ))}
      <button type="button" class="plain compact" aria-label={`Add to ${label(field)}`}
        onClick={() => set([...values, values[values.length - 1] ?? Math.max(info.min ?? 0, 0)])}>
        <Plus size={13} />Add</button>
    </div>
  );
}

export function TextsControl({ field }: ControlProps): JSX.Element {
  const values = Array.isArray(field.value) ? field.value.filter((item): item is string => typeof item === "string")
    : [];
  const [text, setText] = useState("");
  const add = () => {
    if (text.trim() === "") return;
    setField(field, [...values, text.trim()]);
    setText("");
  };
  return (
    <div class="texts">
      {values.map((value, i) => (
        <span class="tag" key={i}>{value}
          <button type="button" class="plain icon small" aria-label={`Remove ${value}`}
            onClick={() => setField(field, values.filter((_, k) => k !== i))}><X size={11} /></button>
        </span>
      ))}
      <input type="text" class="text" aria-label={`Add to ${label(field)}`} placeholder="Add…" value={text}
        spellcheck={false}
        onInput={(event) => setText(event.currentTarget.value)} onBlur={add}
        onKeyDown={(event) => { if (event.key === "Enter") { add(); event.stopPropagation(); } }} />
    </div>
  );
}
