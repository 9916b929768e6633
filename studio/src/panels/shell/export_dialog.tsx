// Export: what to write, from which result, with which numbers; then its progress, its files and what to type in there.
import { useSignal } from "@preact/signals";
import type { Signal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { ApiError } from "../../api/api";
import type { Json, Output } from "../../api/types";
import { Dialog } from "./dialog";
import { ExportForm } from "./export_form";
import { outputOf, presetsOf, sourcesFor, withExtension } from "./export_presets";
import type { ExportPreset } from "./export_presets";
import { ExportResult } from "./export_result";
import { closeDialog, useStudio } from "./shell";

export interface Choice {
  on: boolean;
  path: string;
  from: string;
  values: { [name: string]: Json };
}

export type Choices = { [preset: string]: Choice };

function useChoices(presets: readonly ExportPreset[]): {
  choice: (preset: ExportPreset) => Choice; choices: Signal<Choices>;
} {
  const studio = useStudio();
  const choices = useSignal<Choices>({});
  const choice = (preset: ExportPreset): Choice => {
    const known = choices.value[preset.id];
    if (known) return known;
    const sources = sourcesFor(studio.document.value.recipe, studio.schema, preset.format);
    const { terrain, overlay } = studio.shown.value;
    const from = [terrain, overlay].find((source) => source !== null && sources.includes(source)) ?? sources[0] ?? "";
    const first = presets[0]?.id === preset.id;
    return { on: first, path: preset.path, from, values: {} };
  };
  return { choice, choices };
}

export function ExportDialog() {
  const studio = useStudio();
  const presets = useMemo(() => presetsOf(studio.schema), [studio.schema]);
  const { choice, choices } = useChoices(presets);
  const at = useSignal(presets[0]?.id ?? "");
  const folder = useSignal("export");
  const keep = useSignal(false);
  const job = useSignal<string | null>(null);
  const failure = useSignal("");
  const shown = presets.find((preset) => preset.id === at.value);
  const chosen = presets.filter((preset) => choice(preset).on && choice(preset).from !== "");
  const change = (preset: ExportPreset, next: Partial<Choice>): void => {
    choices.value = { ...choices.value, [preset.id]: { ...choice(preset), ...next } };
  };
  const write = async (): Promise<void> => {
    const outputs = chosen.map((preset) => {
      const { path, from, values } = choice(preset);
      return outputOf(preset, withExtension(preset.format, path), from, values);
    });
    failure.value = "";
    try {
      if (keep.value) await keepOutputs(studio, outputs);
      job.value = (await studio.api.exportOutputs(studio.window, outputs, folder.value)).job;
    } catch (error) {
      failure.value = error instanceof ApiError ? error.answer.diagnostics?.[0]?.message ?? error.message
        : (error as Error).message;
    }
  };
  const foot = job.value !== null ? undefined : (
    <>
      <label class="check">
        <input type="checkbox" checked={keep.value} onChange={(event) => (keep.value = event.currentTarget.checked)} />
        Keep as outputs of the recipe
      </label>
      <div class="bar-space" />
      {failure.value && <p class="failure" role="alert">{failure.value}</p>}
      <button onClick={closeDialog}>Cancel</button>
      <button class="primary" disabled={chosen.length === 0} onClick={() => void write()}>
        {chosen.length > 1 ? `Export ${chosen.length} outputs` : "Export"}
      </button>
    </>
  );
  return (
    <Dialog title="Export" class="export" close={closeDialog} foot={foot}>
      {job.value !== null ? <ExportResult job={job.value} back={() => (job.value = null)} /> : (
        <div class="export-columns">
          <ul class="export-list" aria-label="What to write">
            {presets.map((preset) => {
              const { on, from } = choice(preset);
              return (
                <li key={preset.id} class={`export-row ${preset.id === at.value ? "current" : ""}`}>
                  <input
                    type="checkbox"
                    checked={on && from !== ""}
                    disabled={from === ""}
                    aria-label={`Write ${preset.title}`}
                    onChange={(event) => {
                      change(preset, { on: event.currentTarget.checked });
                      at.value = preset.id;
                    }}
                  />
                  <button
                    class="plain"
                    aria-current={preset.id === at.value}
                    disabled={from === ""}
                    title={from === "" ? "No step makes what this is written from" : preset.about}
                    onClick={() => (at.value = preset.id)}
                  >
                    <span>{preset.title}</span>
                    <span class="muted">{preset.about}</span>
                  </button>
                </li>
              );
            })}
          </ul>
          {shown && (
            <ExportForm
              key={shown.id} preset={shown} choice={choice(shown)} folder={folder}
              change={(next) => change(shown, { on: true, ...next })}
            />
          )}
        </div>
      )}
    </Dialog>
  );
}

/** An output that writes the same file gives way. */
async function keepOutputs(studio: ReturnType<typeof useStudio>, outputs: readonly Output[]): Promise<void> {
  const before = studio.document.value.recipe.outputs ?? [];
  const others = before.filter((output) => !outputs.some((one) => one.path === output.path));
  const value = [...others, ...outputs] as unknown as Json;
  await studio.edit([{ do: "set", pointer: "/outputs", value }], "outputs kept from an export");
}
