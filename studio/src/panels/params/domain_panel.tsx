// The document itself, shown while no step is selected: its size, its cells, its seed, what it says of itself,
// variables.
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { Plus, X } from "lucide-preact";
import type { Json } from "../../api/types";
import type { Studio } from "../../document/studio";
import { NumberField } from "./number_field";
import { ParamList } from "./param_row";
import { newGesture, scopeOf } from "./scope";
import { SeedRow } from "./seed_row";
import { usesOf } from "./variables";
import { bytesText, counted, valueText } from "./words";

/** Cells of the document's domain and the memory of one float raster. */
export function cellsOf(domain: { readonly [member: string]: Json | undefined },
  defaults: (name: string) => number): { columns: number; rows: number } {
  const member = (name: string) => (typeof domain[name] === "number" ? (domain[name] as number) : defaults(name));
  const cell = member("cell_m");
  const size = (metres: number) => Math.max(1, Math.round(metres / cell));
  return { columns: size(member("width_m")), rows: size(member("height_m")) };
}

export function DomainPanel({ studio }: { studio: Studio }): JSX.Element {
  const { recipe } = studio.document.value;
  const scope = scopeOf(studio, "domain", "", "/domain", studio.schema.domain, recipe.domain as Json | undefined);
  const standard = (name: string) => {
    const value = studio.schema.domain.find((info) => info.name === name)?.default;
    return typeof value === "number" ? value : 1;
  };
  const { columns, rows } = cellsOf(recipe.domain ?? {}, standard);
  const bytes = columns * rows * 4;
  return (
    <div class="params-body" data-fields>
      <AboutText studio={studio} pointer="/about" owner="document" text={recipe.about}
        placeholder="What is this? A note for whoever opens it." />
      <ParamList scope={scope} />
      <dl class="facts">
        <div><dt>Cells</dt><dd>{columns} × {rows}</dd></div>
        <div><dt>Memory</dt><dd class={bytes > 1e9 ? "much" : ""}>{bytesText(bytes)} a terrain</dd></div>
      </dl>
      <SeedRow studio={studio} owner="document" pointer="/seed" seed={recipe.seed} derived={false} />
      <Variables studio={studio} />
    </div>
  );
}

interface AboutTextProps {
  studio: Studio;
  pointer: string;
  owner: string;
  text: string | undefined;
  placeholder: string;
}

export function AboutText({ studio, pointer, owner, text = "", placeholder }: AboutTextProps): JSX.Element {
  const [typed, setTyped] = useState(text);
  useEffect(() => setTyped(text), [text]);
  const commit = () => {
    if (typed === text) return;
    void studio.edit([typed.trim() === "" ? { do: "set", pointer } : { do: "set", pointer, value: typed }],
      `${owner}: about`);
  };
  const lines = Math.min(6, Math.max(1, Math.ceil(typed.length / 44)));
  return <textarea class="about" rows={lines} aria-label={`About ${owner}`} value={typed} placeholder={placeholder}
    onInput={(event) => setTyped(event.currentTarget.value)} onBlur={commit}
    onKeyDown={(event) => {
      if (event.key === "Escape") setTyped(text);
      if (event.key === "Enter" && event.ctrlKey) commit();
      event.stopPropagation();
    }} />;
}

function Variables({ studio }: { studio: Studio }): JSX.Element {
  const { recipe } = studio.document.value, variables = recipe.variables ?? {};
  const [name, setName] = useState("");
  const sound = /^[A-Za-z_][A-Za-z0-9_]*$/.test(name) && !(name in variables);
  const add = () => {
    if (!sound) return;
    void studio.edit([{ do: "set", pointer: `/variables/${name}`, value: 0 }], `variable ${name} added`);
    setName("");
  };
  const set = (variable: string, value: Json, gesture = newGesture()) =>
    void studio.edit([{ do: "set", pointer: `/variables/${variable}`, value }],
      `variable ${variable} → ${valueText(value)}`, gesture);
  return (
    <section class="variables" aria-label="Variables">
      <h3 data-help={'Values by name: "$name" may stand wherever a parameter’s value does'}>Variables</h3>
      {Object.entries(variables).map(([variable, value]) => (
        <div class="param" key={variable}>
          <span class="param-title" data-help={`Stands in ${counted(usesOf(recipe, variable), "place")}`}>${variable}</span>
          <div class="param-control">{typeof value === "number"
            ? <NumberField label={variable} value={value} unit=""
              onChange={(next, gesture) => set(variable, next, gesture)} />
            : <span class="muted ellipsis">{valueText(value)}</span>}</div>
          <button type="button" class="plain icon small param-reset" aria-label={`Remove ${variable}`}
            onClick={() => void studio.edit([{ do: "set", pointer: `/variables/${variable}` }],
            `variable ${variable} removed`)}><X /></button>
        </div>
      ))}
      <div class="param">
        <input type="text" class="text" placeholder="New name" aria-label="Name of a new variable" value={name}
          spellcheck={false}
          onInput={(event) => setName(event.currentTarget.value)}
          onKeyDown={(event) => { if (event.key === "Enter") add(); event.stopPropagation(); }} />
        <button type="button" class="plain compact" disabled={!sound} onClick={add}><Plus />Add</button>
      </div>
    </section>
  );
}
