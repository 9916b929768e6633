// The recipe as text beside everything else, both ways; fetched when it is first opened.
import { useSignal } from "@preact/signals";
import { CircleAlert } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { problemText } from "./files";
import { RecipeEditor } from "./recipe_editor";
import { useStudio } from "./shell";
import { TextSync } from "./text_sync";
import type { TextStanding } from "./text_sync";

const kWords: { [standing in TextStanding]: string } = {
  same: "As the document", typing: "Being looked at…", errors: "Not taken over", offline: "Waits for the studio",
};

export function TextPane() {
  const studio = useStudio();
  const frame = useRef<HTMLDivElement>(null);
  const editor = useRef<RecipeEditor | null>(null);
  const sync = useSignal<TextSync | null>(null);
  const problem = useSignal("");
  useEffect(() => {
    let ended = false;
    studio.api.document().then(
      ({ text, revision }) => {
        if (ended) return;
        const told = { changed: () => sync.value?.typed(), blurred: () => sync.value?.blurred() };
        editor.current = new RecipeEditor(frame.current!, text, told);
        sync.value = new TextSync(studio, editor.current, text, revision);
      },
      (error: unknown) => (problem.value = problemText(error)),
    );
    return () => {
      ended = true;
      sync.value?.close();
      editor.current?.close();
      sync.value = editor.current = null;
    };
  }, [studio]);
  const selected = studio.selected.value;
  useEffect(() => {
    if (selected !== null && editor.current && !editor.current.focused) editor.current.showStep(selected);
  }, [selected, sync.value]);
  const standing = sync.value?.standing.value ?? "same";
  const diagnostics = sync.value?.diagnostics.value ?? [];
  return (
    <div class="text-pane">
      <div class="text-editor cm-editor" ref={frame} />
      <div class={`text-foot ${standing}`} role="status">
        {problem.value || kWords[standing]}
        {diagnostics.slice(0, 3).map(({ line, column, message }) => (
          <button key={`${line}:${column}:${message}`} class="plain" onClick={() => editor.current?.goTo(line, column)}>
            <CircleAlert aria-hidden />
            {line > 0 && <span class="muted">line {line}</span>}
            {message}
          </button>
        ))}
        {diagnostics.length > 3 && <span class="muted">and {diagnostics.length - 3} more</span>}
      </div>
    </div>
  );
}
