// What the document writes: files with where they come from, as what, and the parameters of their formats.
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { ChevronRight, FileOutput, Plus, Trash2 } from "lucide-preact";
import type { FormatInfo, Json, Output } from "../../api/types";
import type { Studio } from "../../document/studio";
import { ParamList } from "../params/param_row";
import { scopeOf } from "../params/scope";

/** The format that "as" or the path's extension says. */
export function formatOf(output: Output, formats: readonly FormatInfo[]): FormatInfo | undefined {
  if (output.as !== undefined) return formats.find((format) => format.name === output.as);
  const extension = output.path.slice(output.path.lastIndexOf(".")).toLowerCase();
  return formats.find((format) => format.extensions.includes(extension));
}

export function OutputList({ studio }: { studio: Studio }): JSX.Element {
  const outputs = studio.document.value.recipe.outputs ?? [];
  const [open, setOpen] = useState<number | null>(null);
  const last = studio.document.value.recipe.steps[studio.document.value.recipe.steps.length - 1];
  const add = () => {
    const from = studio.selected.value ?? last?.id;
    const op = studio.operator(studio.step(from ?? "")?.op ?? "");
    const port = op?.out[0];
    const extension = port?.kind === "image" ? "png" : port?.kind === "terrain" || port?.kind === "field"
      || port?.kind === "labels" ? "tif" : "json";
    const value: Json = { path: freePath(from ?? "output", extension, outputs),
      ...(from ? { from: port ? `${from}.${port.name}` : from } : {}) };
    void studio.edit([{ do: "insert", list: "/outputs", value }],
      `output ${String((value as { path: string }).path)} added`);
    setOpen(outputs.length);
  };
  return (
    <section class="outputs" aria-label="Outputs">
      <header class="panel-head"><h2>Outputs</h2><span class="muted">{outputs.length || ""}</span>
        <button type="button" class="plain compact" disabled={!last} onClick={add}><Plus />Add</button></header>
      <ol>{outputs.map((output, i) => <OutputRow key={i} studio={studio} output={output} index={i} open={open === i}
        onToggle={() => setOpen(open === i ? null : i)} />)}</ol>
    </section>
  );
}

function freePath(base: string, extension: string, outputs: readonly Output[]): string {
  for (let number = 1; ; ++number) {
    const path = `${base}${number === 1 ? "" : `_${number}`}.${extension}`;
    if (!outputs.some((output) => output.path === path)) return path;
  }
}

interface OutputRowProps {
  studio: Studio;
  output: Output;
  index: number;
  open: boolean;
  onToggle(): void;
}

function OutputRow({ studio, output, index, open, onToggle }: OutputRowProps): JSX.Element {
  const format = formatOf(output, studio.schema.formats);
  const pointer = `/outputs/${index}`;
  const scope = scopeOf(studio, output.path, "", pointer, format?.params ?? [], output as Json);
  const set = (name: string, value: string) =>
    void studio.edit([value === "" ? { do: "set", pointer: `${pointer}/${name}` }
      : { do: "set", pointer: `${pointer}/${name}`, value }], `${output.path}: ${name} ${value || "as by default"}`);
  return (
    <li class={`output${open ? " open" : ""}`}>
      <div class="output-head">
        <button type="button" class="plain output-toggle" aria-expanded={open}
          onClick={onToggle}><ChevronRight class="chevron" /><FileOutput />
          <span class="ellipsis">{output.path}</span><span class="muted ellipsis">{output.as ?? ""}{output.from
            ? ` ← ${typeof output.from === "string" ? output.from : output.from.file}` : ""}</span></button>
        <button type="button" class="plain icon small" aria-label={`Remove ${output.path}`}
          onClick={() => void studio.edit([{ do: "remove", item: pointer }], `output ${output.path} removed`)}>
          <Trash2 /></button>
      </div>
      {open && (
        <div class="output-body" data-fields>
          <PathRow output={output} onSet={(path) => set("path", path)} />
          <ChoiceRow title="From" value={typeof output.from === "string" ? output.from : ""} none="the last step"
            choices={sourcesOf(studio)} onSet={(value) => set("from", value)} />
          <ChoiceRow title="As" value={output.as ?? ""} none="as the file's ending says"
            choices={studio.schema.formats.map((one) => one.name)} onSet={(value) => set("as", value)} />
          {format && <ParamList scope={scope} />}
        </div>
      )}
    </li>
  );
}

function sourcesOf(studio: Studio): string[] {
  return studio.document.value.recipe.steps.flatMap((step) => (studio.operator(step.op)?.out ?? []).map((port) =>
    `${step.id}.${port.name}`));
}

function PathRow({ output, onSet }: { output: Output; onSet(path: string): void }): JSX.Element {
  const [path, setPath] = useState(output.path);
  useEffect(() => setPath(output.path), [output.path]);
  const commit = () => { if (path.trim() !== "" && path !== output.path) onSet(path.trim()); };
  return (
    <label class="param"><span class="param-title">File</span>
      <span class="param-control"><input type="text" class="text" value={path} spellcheck={false}
        onInput={(event) => setPath(event.currentTarget.value)} onBlur={commit}
        onKeyDown={(event) => { if (event.key === "Enter") commit(); event.stopPropagation(); }} /></span>
        <span class="param-reset" /></label>
  );
}

interface ChoiceRowProps {
  title: string;
  value: string;
  none: string;
  choices: readonly string[];
  onSet(value: string): void;
}

function ChoiceRow({ title, value, none, choices, onSet }: ChoiceRowProps): JSX.Element {
  const known = value === "" || choices.includes(value);
  return (
    <label class="param"><span class="param-title">{title}</span>
      <span class="param-control"><select class="select" value={value}
        onChange={(event) => onSet(event.currentTarget.value)}>
        <option value="">{none}</option>{!known && <option value={value}>{value}</option>}
        {choices.map((choice) => <option key={choice} value={choice}>{choice}</option>)}</select></span>
          <span class="param-reset" /></label>
  );
}
