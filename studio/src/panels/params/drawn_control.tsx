// Parameters that are drawn: how much there is, and a button that gives the pen to draw it.
import type { JSX } from "preact";
import { Pencil, Trash2 } from "lucide-preact";
import type { ControlProps } from "./controls";
import { drawing, drawRequest } from "./active_item";
import { drawnText } from "./measures";
import { resetField } from "./scope";
import { titleOf } from "./words";

export function DrawButton({ field }: ControlProps): JSX.Element | null {
  const { scope, info, pointer } = field;
  if (scope.step === "") return null;
  const pressed = drawing.value === pointer;
  return (
    <button type="button" class={`compact draw${pressed ? " pressed" : ""}`} aria-pressed={pressed}
      aria-label={`Draw ${titleOf(info.name).toLowerCase()}`}
      onClick={() => { drawRequest.value = { step: scope.step, pointer, kind: info.kind, name: info.name }; }}>
      <Pencil size={13} />{info.kind === "point" ? "" : "Draw"}
    </button>
  );
}

export function DrawnControl({ field }: ControlProps): JSX.Element {
  const empty = !Array.isArray(field.value) || field.value.length === 0;
  return (
    <div class="drawn">
      <span class={empty ? "drawn-text muted" : "drawn-text"}>{drawnText(field.info.kind, field.value)}</span>
      {!empty && field.stated !== undefined && (
        <button type="button" class="plain icon small" aria-label={`Remove all of ${titleOf(field.info.name)}`}
          data-help="Remove all"
          onClick={() => resetField(field)}><Trash2 size={13} /></button>
      )}
      <DrawButton field={field} />
    </div>
  );
}
