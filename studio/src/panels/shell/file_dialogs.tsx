// Open, save as, a blank document, and what becomes of changes that no file has.
import { useSignal } from "@preact/signals";
import { FileBraces, Upload } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { FileInfo } from "../../api/api";
import { Dialog } from "./dialog";
import { importFiles, openDocument, pickFiles, problemText, proposedName, save } from "./files";
import { afterUnsaved, closeDialog, useStudio } from "./shell";
import { bytesText } from "./words";

export function OpenDialog() {
  const studio = useStudio();
  const folder = useSignal("");
  const files = useSignal<readonly FileInfo[] | null>(null);
  const problem = useSignal("");
  const typed = useSignal("");
  useEffect(() => {
    studio.api.files().then(
      (answer) => {
        folder.value = answer.folder;
        files.value = answer.files.filter((file) => file.path.endsWith(".json"));
      },
      (error: unknown) => (problem.value = problemText(error)),
    );
  }, []);
  const found = (files.value ?? []).filter((file) => file.path.toLowerCase().includes(typed.value.toLowerCase()));
  const fromHere = async (): Promise<void> => importFiles(studio, await pickFiles("", true));
  const foot = (
    <>
      <button onClick={() => void fromHere()}><Upload aria-hidden />From this computer…</button>
      <div class="bar-space" />
      <button onClick={closeDialog}>Cancel</button>
    </>
  );
  return (
    <Dialog title="Open a recipe" class="open" close={closeDialog} foot={foot}>
      <input
        type="search"
        placeholder="Find"
        aria-label="Find a recipe"
        value={typed.value}
        autoFocus
        onInput={(event) => (typed.value = event.currentTarget.value)}
      />
      {problem.value && (
        <p class="failure" role="alert">
          {problem.value}
        </p>
      )}
      <ul class="rows" aria-label={`Recipes in ${folder.value}`}>
        {found.map((file) => (
          <li key={file.path}>
            <button class="plain row" onClick={() => void openDocument(studio, { path: file.path })}>
              <FileBraces aria-hidden />
              <span class="row-title">{file.path}</span>
              <span class="muted">{bytesText(file.bytes)}</span>
              <span class="muted">{dateText(file.modified)}</span>
            </button>
          </li>
        ))}
      </ul>
      {files.value && found.length === 0 && (
        <p class="empty">
          There is no recipe {typed.value ? "called so" : ""} in {folder.value}.
        </p>
      )}
    </Dialog>
  );
}

function dateText(modified: string): string {
  const date = new Date(modified);
  return Number.isNaN(date.getTime()) ? "" : date.toLocaleString(
    undefined, { dateStyle: "medium", timeStyle: "short" },
  );
}

export function SaveAsDialog() {
  const studio = useStudio();
  const name = useSignal(proposedName(studio.document.value.file));
  const go = (event: Event): void => {
    event.preventDefault();
    const path = name.value.trim();
    if (path !== "") void save(studio, path.endsWith(".json") ? path : `${path}.json`);
  };
  return (
    <Dialog title="Save as" class="small-dialog" close={closeDialog}>
      <form onSubmit={go}>
        <label class="field stacked">
          <span>Name, below the studio's folder</span>
          <input
            type="text"
            value={name.value}
            spellcheck={false}
            autoFocus
            onFocus={(event) => selectStem(event.currentTarget)}
            onInput={(event) => (name.value = event.currentTarget.value)}
          />
        </label>
        <p class="muted">The file is a recipe: the command line runs it just as it is.</p>
        <div class="dialog-buttons">
          <button type="button" onClick={closeDialog}>
            Cancel
          </button>
          <button class="primary" type="submit" disabled={name.value.trim() === ""}>
            Save
          </button>
        </div>
      </form>
    </Dialog>
  );
}

function selectStem(input: HTMLInputElement): void {
  const end = input.value.lastIndexOf(".");
  input.setSelectionRange(0, end > 0 ? end : input.value.length);
}

export function BlankDialog() {
  const studio = useStudio();
  const width_km = useSignal(10);
  const cell_m = useSignal(20);
  const width_m = width_km.value * 1000;
  const cells = Math.round(width_m / cell_m.value);
  const possible = cells >= 8 && cells <= 16384;
  const go = (event: Event): void => {
    event.preventDefault();
    if (possible) void openDocument(studio, { blank: true, width_m, height_m: width_m, cell_m: cell_m.value });
  };
  return (
    <Dialog title="A blank terrain" class="small-dialog" close={closeDialog}>
      <form onSubmit={go}>
        <label class="field">
          <span>
            Width <span class="muted">km</span>
          </span>
          <input
            type="number"
            min={0.01}
            step="any"
            value={width_km.value}
            autoFocus
            onInput={(event) => (width_km.value = event.currentTarget.valueAsNumber || 0)}
          />
        </label>
        <label class="field">
          <span>
            Cell <span class="muted">m</span>
          </span>
          <input
            type="number"
            min={0.01}
            step="any"
            value={cell_m.value}
            onInput={(event) => (cell_m.value = event.currentTarget.valueAsNumber || 0)}
          />
        </label>
        <p class={possible ? "muted" : "failure"}>
          {possible
            ? `${cells} × ${cells} cells. Both can be changed later.`
            : "Between 8 and 16 384 cells a side are possible."}
        </p>
        <div class="dialog-buttons">
          <button type="button" onClick={closeDialog}>
            Cancel
          </button>
          <button class="primary" type="submit" disabled={!possible}>
            Create
          </button>
        </div>
      </form>
    </Dialog>
  );
}

export function UnsavedDialog() {
  const studio = useStudio();
  const go = afterUnsaved.value;
  if (!go) return null;
  const { file } = studio.document.value;
  const close = (): void => {
    afterUnsaved.value = null;
  };
  const leave = (): void => {
    close();
    go();
  };
  const saveFirst = async (): Promise<void> => {
    close();
    if (await save(studio)) go();
  };
  return (
    <Dialog
      title={file === "" ? "This terrain has no file yet" : `${file} lacks the latest changes`}
      class="small-dialog"
      close={close}
    >
      <p>Save before another document takes its place?</p>
      <div class="dialog-buttons">
        <button onClick={leave}>Leave them</button>
        <div class="bar-space" />
        <button onClick={close}>Cancel</button>
        <button class="primary" autoFocus onClick={() => void saveFirst()}>
          Save
        </button>
      </div>
    </Dialog>
  );
}
