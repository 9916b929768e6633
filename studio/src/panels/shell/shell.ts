// What the parts of the shell share: the studio, and which dialog is open.
import { computed, signal } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { OpenedStudio } from "../../document/open_studio";

export const StudioContext = createContext<OpenedStudio | null>(null);

export function useStudio(): OpenedStudio {
  const studio = useContext(StudioContext);
  if (!studio) throw new Error("There is no studio around this part");
  return studio;
}

export type DialogName = "palette" | "shortcuts" | "export" | "open" | "save_as" | "blank" | "examples";

/** At most one is open. */
export const dialog = signal<DialogName | null>(null);

/** What is to happen once the person has said what becomes of changes that no file has; null: nothing waits. */
export const afterUnsaved = signal<(() => void) | null>(null);

export const anyDialog = computed(() => dialog.value !== null || afterUnsaved.value !== null);

export function openDialog(name: DialogName): void {
  dialog.value = name;
}

export function closeDialog(): void {
  dialog.value = null;
}
