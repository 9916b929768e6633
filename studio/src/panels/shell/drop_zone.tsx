// Files can be dropped anywhere; while they hang over the window it says what will become of them.
import { useSignal } from "@preact/signals";
import { FileUp } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { uploading } from "../../document/uploads";
import { importFiles } from "./files";
import { anyDialog, useStudio } from "./shell";
import { UploadCard } from "./upload_card";

function carriesFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") ?? false;
}

export function DropZone() {
  const studio = useStudio();
  const over = useSignal(false);
  useEffect(() => {
    let depth = 0;
    const enter = (event: DragEvent): void => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      depth += 1;
      over.value = true;
    };
    const leave = (event: DragEvent): void => {
      if (!carriesFiles(event)) return;
      depth = Math.max(0, depth - 1);
      over.value = depth > 0;
    };
    const hang = (event: DragEvent): void => {
      if (carriesFiles(event)) event.preventDefault();
    };
    const drop = (event: DragEvent): void => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      depth = 0;
      over.value = false;
      void importFiles(studio, [...(event.dataTransfer?.files ?? [])]);
    };
    const listeners = [["dragenter", enter], ["dragleave", leave], ["dragover", hang], ["drop", drop]] as const;
    for (const [name, listener] of listeners) addEventListener(name, listener);
    return () => {
      for (const [name, listener] of listeners) removeEventListener(name, listener);
    };
  }, [studio]);
  if (uploading.value !== null) return anyDialog.value ? null : <UploadCard />;
  if (!over.value) return null;
  return (
    <div class="drop-zone">
      <div class="drop-card">
        <FileUp aria-hidden />
        <div>
          <strong>Drop to take it in</strong>
          <p class="muted">Elevation, a coast, contours, painted regions, or a recipe</p>
        </div>
      </div>
    </div>
  );
}
