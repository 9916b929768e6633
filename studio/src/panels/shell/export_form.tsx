// The settings of one output: where it comes from, its file, and the format's own parameters.
import type { Signal } from "@preact/signals";
import type { Json, ParamInfo } from "../../api/types";
import type { Choice } from "./export_dialog";
import { plainParams, sourcesFor } from "./export_presets";
import type { ExportPreset } from "./export_presets";
import { useStudio } from "./shell";

/** Those that are asked for at once; the others are a click away. */
const kFirst = 4;

interface ExportFormProps {
  preset: ExportPreset;
  choice: Choice;
  folder: Signal<string>;
  change: (next: Partial<Choice>) => void;
}

export function ExportForm({ preset, choice, folder, change }: ExportFormProps) {
  const studio = useStudio();
  const sources = sourcesFor(studio.document.value.recipe, studio.schema, preset.format);
  const params = plainParams(preset.format);
  const field = (param: ParamInfo) => (
    <ParamField
      key={param.name} param={param} value={choice.values[param.name]}
      change={(value) => change({ values: { ...choice.values, [param.name]: value } })}
    />
  );
  return (
    <div class="export-form">
      <h3>{preset.title}</h3>
      <p class="muted">{preset.format.summary}</p>
      <label class="field">
        <span>From</span>
        <select value={choice.from} onChange={(event) => change({ from: event.currentTarget.value })}>
          {sources.map((source) => (
            <option key={source} value={source}>
              {source}
            </option>
          ))}
        </select>
      </label>
      <label class="field">
        <span>File</span>
        <input
          type="text"
          value={choice.path}
          spellcheck={false}
          onChange={(event) => change({ path: event.currentTarget.value })}
        />
      </label>
      <label class="field">
        <span>Folder</span>
        <input
          type="text"
          value={folder.value}
          spellcheck={false}
          onChange={(event) => (folder.value = event.currentTarget.value)}
        />
      </label>
      {params.slice(0, kFirst).map(field)}
      {params.length > kFirst && (
        <details>
          <summary>{params.length - kFirst} more settings</summary>
          {params.slice(kFirst).map(field)}
        </details>
      )}
    </div>
  );
}

interface ParamFieldProps {
  param: ParamInfo;
  value: Json | undefined;
  change: (value: Json) => void;
}

function nameOf(param: ParamInfo): string {
  const words = param.name.replace(/_(m|px|deg|m2|yr)$/, "").replace(/_/g, " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

function ParamField({ param, value, change }: ParamFieldProps) {
  return (
    <label class="field" title={param.help}>
      <span>{nameOf(param)}{param.unit && <span class="muted"> {param.unit}</span>}</span>
      <ParamInput param={param} value={value} change={change} />
    </label>
  );
}

function ParamInput({ param, value, change }: ParamFieldProps) {
  const current = value ?? param.default;
  if (param.kind === "switch") {
    return (
      <input type="checkbox" checked={current === true} onChange={(event) => change(event.currentTarget.checked)} />
    );
  }
  if (param.kind === "choice") {
    return (
      <select value={String(current)} onChange={(event) => change(event.currentTarget.value)}>
        {(param.choices ?? []).map((word) => <option key={word} value={word}>{word.replace(/_/g, " ")}</option>)}
      </select>
    );
  }
  if (param.kind === "number" || param.kind === "integer") {
    return (
      <input
        type="number" min={param.min} max={param.max} step={param.kind === "integer" ? 1 : "any"}
        value={current === null ? "" : String(current)} placeholder={param.default === null ? "chosen for you" : ""}
        onChange={(event) => {
          const number = event.currentTarget.valueAsNumber;
          change(Number.isFinite(number) ? number : "");
        }}
      />
    );
  }
  return (
    <input
      type="text"
      value={current === null ? "" : String(current)}
      onChange={(event) => change(event.currentTarget.value)}
    />
  );
}
