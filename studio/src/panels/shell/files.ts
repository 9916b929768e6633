// Opening, saving and importing: what the menus, the first screen and a dropped file do.
import { ApiError } from "../../api/api";
import type { OpenRequest, Uploaded } from "../../api/api";
import type { OpenedStudio } from "../../document/open_studio";
import { UploadCancelled, uploadFile } from "../../document/uploads";
import { importPlan } from "./import_edits";
import { afterUnsaved, closeDialog, openDialog } from "./shell";
import { showToast } from "./toasts";
import { baseName } from "./words";

export function problemText(error: unknown): string {
  if (error instanceof ApiError) return error.answer.diagnostics?.[0]?.message ?? error.message;
  return error instanceof Error ? error.message : String(error);
}

async function trying(what: string, work: () => Promise<void>): Promise<boolean> {
  try {
    await work();
    return true;
  } catch (error) {
    if (error instanceof UploadCancelled) return false;
    showToast({ kind: "error", text: `${what}: ${problemText(error)}` });
    return false;
  }
}

/** At once, or after asking about changes that no file has. */
export function unlessUnsaved(studio: OpenedStudio, go: () => void): void {
  const { saved, history } = studio.document.value;
  if (saved || history.length === 0) go();
  else afterUnsaved.value = go;
}

/** True once the window has the opened document. */
export function openDocument(studio: OpenedStudio, request: OpenRequest): Promise<boolean> {
  return trying("This could not be opened", async () => {
    await studio.open(request);
    closeDialog();
  });
}

export async function save(studio: OpenedStudio, path?: string): Promise<boolean> {
  const { file } = studio.document.value;
  if (path === undefined && file === "") {
    openDialog("save_as");
    return false;
  }
  return trying("This could not be saved", async () => {
    if (!(await studio.save(path))) return;
    closeDialog();
    showToast({ kind: "note", text: `Saved to ${studio.document.value.file}` });
  });
}

/** What else is JSON has a kind: a coast, contours. */
function isRecipe(file: File, uploaded: Uploaded): boolean {
  return uploaded.kind === "recipe" || (uploaded.kind === "" && file.name.toLowerCase().endsWith(".json"));
}

function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf("/") + 1);
}

/** Sends the files and does with each what its kind and the document suggest. */
export async function importFiles(studio: OpenedStudio, files: readonly File[]): Promise<void> {
  for (const file of files) {
    await trying(`${file.name} could not be taken in`, async () => {
      const uploaded = await uploadFile(studio.api, file);
      if (isRecipe(file, uploaded)) {
        const path = folderOf(studio.document.value.file) + uploaded.file;
        return unlessUnsaved(studio, () => void openDocument(studio, { path }));
      }
      const { recipe } = studio.document.value;
      const plan = importPlan(studio.schema, recipe, studio.selected.value, uploaded.file, uploaded.kind);
      if (!plan) throw new Error(uploaded.info["problem"] ?? `nothing here begins with ${uploaded.kind || "such a file"}`);
      if (!(await studio.edit(plan.edits, plan.label))) return;
      studio.selected.value = plan.select;
      closeDialog();
      showToast({ kind: "note", text: plan.told });
    });
  }
}

export function pickFiles(accept: string, multiple: boolean): Promise<File[]> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = accept;
    input.multiple = multiple;
    input.addEventListener("change", () => resolve([...(input.files ?? [])]));
    input.addEventListener("cancel", () => resolve([]));
    input.click();
  });
}

/** A name to propose for a document that has none. */
export function proposedName(file: string): string {
  return file === "" ? "terrain.json" : baseName(file);
}
