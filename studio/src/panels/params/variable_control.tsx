// A parameter that is a variable of the document, and what makes it one: a small "$" behind its title.
import type { JSX } from "preact";
import { Unlink } from "lucide-preact";
import type { Json } from "../../api/types";
import { NumberField } from "./number_field";
import { type Field, newGesture, setField } from "./scope";
import { titleOf, valueText } from "./words";
import { bindEdits, bindNewEdits, fittingVariables, freshVariable } from "./variables";

/** The variable's name and value, which is changed here for all that use it; or the parameter gets one of its own. */
export function VariableControl({ field }: { field: Field }): JSX.Element {
  const { info, value, scope, variable } = field;
  const set = (to: Json, gesture = newGesture()) => void scope.studio.edit(
    [{ do: "set", pointer: `/variables/${variable}`, value: to }], `variable ${variable} → ${valueText(to, info)}`, gesture);
  return (
    <div class="variable">
      <span class="tag" data-help={`The variable "${variable}" of the document: other parameters may have it, too`}>${variable}</span>
      {typeof value === "number"
        ? <NumberField label={`${titleOf(info.name)}, variable ${variable}`} value={value} unit={info.unit} min={info.min}
          max={info.max} integer={info.kind === "integer"} onChange={(to, gesture) => set(to, gesture)} />
        : <span class="ellipsis">{valueText(value, info)}</span>}
      <button type="button" class="plain icon small" aria-label={`Give ${titleOf(info.name)} a value of its own`}
        data-help="Give it a value of its own" onClick={() => setField(field, field.value)}><Unlink /></button>
    </div>
  );
}

const kNew = "+";

/** Chooses a variable for a parameter, or makes one of it. */
export function BindVariable({ field }: { field: Field }): JSX.Element | null {
  const { info, scope, pointer, value } = field;
  const variables = scope.studio.document.value.recipe.variables ?? {};
  const names = fittingVariables(info, variables), title = titleOf(info.name);
  if (names.length === 0 && (value === null || value === "")) return null;
  const fresh = freshVariable(info.name, variables);
  const choose = (name: string) => {
    const edits = name === kNew ? bindNewEdits(pointer, fresh, value) : bindEdits(pointer, name);
    void scope.studio.edit(edits, `${scope.owner}: ${title.toLowerCase()} is the variable ${name === kNew ? fresh : name}`);
  };
  return (
    <span class="bind">
      <span aria-hidden="true">$</span>
      <select aria-label={`Variable for ${title}`} value="" onChange={(event) => {
        const name = event.currentTarget.value;
        event.currentTarget.value = "";
        if (name !== "") choose(name);
      }}>
        <option value="" disabled hidden>Variable…</option>
        {names.map((name) => <option key={name} value={name}>${name} = {valueText(variables[name], info)}</option>)}
        {value !== null && value !== "" && <option value={kNew}>New variable ${fresh}</option>}
      </select>
    </span>
  );
}
