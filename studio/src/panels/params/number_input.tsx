// A number field while it is typed into: sums and units are understood, what they come to is shown beside.
import type { JSX } from "preact";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { readTyped } from "./expression";
import { bounded } from "./scale";
import { amountText, numberText } from "./words";

interface NumberInputProps {
  label: string;
  text: string;
  unit: string;
  bounds: { min?: number; max?: number; integer: boolean };
  /** null: left as it was. */
  onDone(value: number | null): void;
}

/** Opens the next number field of the panel for typing. */
function typeIntoNext(from: HTMLElement, backwards: boolean): void {
  const panel = from.closest("[data-fields]");
  if (!panel) return;
  const fields = [...panel.querySelectorAll<HTMLElement>("[data-number-field]")].filter((field) =>
    field.offsetParent !== null);
  const next = fields[fields.indexOf(from) + (backwards ? -1 : 1)];
  next?.focus();
  next?.dispatchEvent(new CustomEvent("Edit"));
}

export function NumberInput({ label, text, unit, bounds, onDone }: NumberInputProps): JSX.Element {
  const [typed, setTyped] = useState(text);
  const input = useRef<HTMLInputElement>(null);
  const done = useRef(false);
  useLayoutEffect(() => {
    input.current?.focus();
    if (text.length > 1 || /\d\d/.test(text)) input.current?.select();
  }, []);
  const read = readTyped(typed, unit);
  const empty = typed.trim() === "";
  const error = "error" in read && !empty ? read.error : "";
  const value = "value" in read ? bounded(read.value, bounds) : null;
  const sum = value !== null && numberText(value) !== typed.trim().replace(",", ".");
  const limited = "value" in read && value !== read.value;
  const finish = (keep: boolean) => {
    if (done.current) return;
    done.current = true;
    onDone(keep ? value : null);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    event.stopPropagation();
    if (event.key === "Escape") finish(false);
    else if (event.key === "Enter" && error === "") finish(true);
    else if (event.key === "Tab" && error === "") {
      event.preventDefault();
      typeIntoNext(input.current!, event.shiftKey);
      finish(true);
    } else return;
    event.preventDefault();
  };
  return (
    <div class="number-typing">
      <input ref={input} type="text" class="number-input" data-number-field aria-label={label}
        aria-invalid={error !== ""}
        value={typed} spellcheck={false} autocomplete="off" onInput={(event) => setTyped(event.currentTarget.value)}
        onKeyDown={onKeyDown} onBlur={() => finish(error === "" && !empty)} />
      {(error !== "" || sum) && (
        <span class={error ? "number-hint wrong" : "number-hint"} role={error ? "alert" : undefined}>
          {error || `= ${amountText(value!, unit)}${limited ? " (limit)" : ""}`}
        </span>
      )}
    </div>
  );
}
