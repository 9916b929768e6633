// Names of a catalogue's classes: chosen where the catalogue is known, typed otherwise.
import type { JSX } from "preact";
import { catalogueClasses, classColour, type CatalogueClass } from "../../document/catalogue";
import { type ControlProps, TextControl, TextsControl } from "./controls";
import { type Field, resetField, setField } from "./scope";
import { titleOf, wordOf } from "./words";

function classesFor(field: Field): readonly CatalogueClass[] {
  const { studio, step } = field.scope;
  return step === "" ? [] : catalogueClasses(studio, step);
}

/** One class; none says "any" where that has a meaning. */
export function ClassControl({ field }: ControlProps): JSX.Element {
  const classes = classesFor(field);
  if (classes.length === 0) return <TextControl field={field} />;
  const value = typeof field.value === "string" ? field.value : "";
  const known = value === "" || classes.some((one) => one.name === value);
  return (
    <select class="select" aria-label={titleOf(field.info.name)} aria-description={field.info.help} value={value}
      onChange={(event) => {
        const name = event.currentTarget.value;
        if (name === "") resetField(field);
        else setField(field, name);
      }}>
      <option value="">{/any|all/.test(field.info.help) ? "any" : "none"}</option>
      {!known && <option value={value}>{value} (not in the catalogue)</option>}
      {classes.map(({ name, about }) => <option key={name} value={name} title={about}>{wordOf(name)}</option>)}
    </select>
  );
}

/** Several classes, each switched on or off; none of them: all. */
export function ClassesControl({ field }: ControlProps): JSX.Element {
  const classes = classesFor(field);
  if (classes.length === 0) return <TextsControl field={field} />;
  const chosen = Array.isArray(field.value) ? field.value.map(String) : [];
  const toggle = (name: string) => {
    const next = classes.map((one) => one.name).filter((one) => (one === name) !== chosen.includes(one));
    if (next.length === 0) resetField(field);
    else setField(field, next);
  };
  return (
    <div class="classes" role="group" aria-label={titleOf(field.info.name)} aria-description={field.info.help}>
      {classes.map(({ name, about }) => (
        <button key={name} type="button" class="plain compact class-chip" aria-pressed={chosen.includes(name)}
          data-help={about || undefined} onClick={() => toggle(name)}>
          <span class="class-mark" style={{ background: classColour(classes, name) }} />{wordOf(name)}</button>
      ))}
      {chosen.length === 0 && <span class="muted">all</span>}
    </div>
  );
}
