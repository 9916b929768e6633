// Parameters that name files: typed, chosen, or dropped; a chosen file is uploaded beside the document.
import type { JSX } from "preact";
import { useRef, useState } from "preact/hooks";
import { Upload, X } from "lucide-preact";
import { type ControlProps, TextControl } from "./controls";
import type { Studio } from "../../document/studio";
import { UploadCancelled, uploadFile } from "../../document/uploads";
import { setField } from "./scope";
import { titleOf } from "./words";

interface ChooseProps {
  studio: Studio;
  label: string;
  multiple?: boolean;
  onFiles(names: string[]): void;
  onProblem(text: string): void;
}

/** A button that asks for files and hands back their names in the studio's folder. */
function ChooseFiles({ studio, label, multiple, onFiles, onProblem }: ChooseProps): JSX.Element {
  const input = useRef<HTMLInputElement>(null);
  const [busy, setBusy] = useState(false);
  const take = async (files: FileList | null) => {
    if (!files || files.length === 0) return;
    setBusy(true);
    try {
      const names: string[] = [];
      for (const file of files) names.push((await uploadFile(studio.api, file)).file);
      onFiles(names);
    } catch (problem) {
      if (!(problem instanceof UploadCancelled)) onProblem(problem instanceof Error ? problem.message : String(problem));
    } finally {
      setBusy(false);
      if (input.current) input.current.value = "";
    }
  };
  return (
    <>
      <button type="button" class="plain icon" aria-label={`Choose a file for ${label}`}
        data-help="Choose a file; it is copied beside the document"
        aria-busy={busy} disabled={busy} onClick={() => input.current?.click()}><Upload size={14} /></button>
      <input ref={input} type="file" hidden multiple={multiple} tabIndex={-1} aria-hidden="true"
        onChange={(event) => void take(event.currentTarget.files)} />
    </>
  );
}

export function FileControl({ field }: ControlProps): JSX.Element {
  const { studio, step } = field.scope;
  const onProblem = (text: string) => { studio.message.value = { kind: "error", text, ...(step ? { step } : {}) }; };
  const drop = async (event: DragEvent) => {
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    event.stopPropagation();
    try {
      setField(field, (await uploadFile(studio.api, file)).file);
    } catch (problem) {
      if (!(problem instanceof UploadCancelled)) onProblem(problem instanceof Error ? problem.message : String(problem));
    }
  };
  return (
    <div class="file" onDragOver={(event) => event.preventDefault()} onDrop={(event) => void drop(event)}>
      <TextControl field={field} />
      <ChooseFiles studio={studio} label={titleOf(field.info.name)}
        onFiles={([name]) => { if (name) setField(field, name); }} onProblem={onProblem} />
    </div>
  );
}

export function FilesControl({ field }: ControlProps): JSX.Element {
  const { studio } = field.scope;
  const names = Array.isArray(field.value) ? field.value.filter((item): item is string => typeof item === "string")
    : [];
  return (
    <div class="files">
      {names.map((name, i) => (
        <div class="files-item" key={name}><span class="ellipsis" title={name}>{name}</span>
          <button type="button" class="plain icon small" aria-label={`Remove ${name}`}
            onClick={() => setField(field, names.filter((_, k) => k !== i))}><X size={12} /></button></div>
      ))}
      <div class="files-add"><span class="muted">{names.length === 0 ? "none" : ""}</span>
        <ChooseFiles studio={studio} label={titleOf(field.info.name)} multiple
          onFiles={(more) => setField(field, [...names, ...more])}
          onProblem={(text) => { studio.message.value = { kind: "error", text }; }} /></div>
    </div>
  );
}
