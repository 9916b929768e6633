// Ctrl+K: everything that can be done, and every step to go to, found by a few letters.
import { useSignal } from "@preact/signals";
import { Box } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { allActions, isPossible } from "../../actions/registry";
import type { IconType } from "../../actions/registry";
import { Dialog } from "./dialog";
import { Keys } from "./keys";
import { ranked } from "./rank";
import { closeDialog, useStudio } from "./shell";

interface Entry {
  id: string;
  title: string;
  about: string;
  words: string;
  icon: IconType | undefined;
  keys: string | undefined;
  run: () => void;
}

function useEntries(): Entry[] {
  const studio = useStudio();
  const actions = allActions.value.filter(
    (action) => action.id !== "help.palette" && isPossible(action),
  ).map((action) => ({
    id: action.id, title: action.title, about: action.group, words: `${action.words ?? ""} ${action.group}`,
    icon: action.icon, keys: action.keys?.[0], run: action.run,
  }));
  const steps = studio.document.value.recipe.steps.map((step) => ({
    id: `step ${step.id}`, title: `Go to ${step.id}`, about: step.op, words: step.op, icon: Box, keys: undefined,
    run: () => (studio.selected.value = step.id),
  }));
  return [...actions, ...steps];
}

export function Palette() {
  const typed = useSignal("");
  const at = useSignal(0);
  const list = useRef<HTMLUListElement>(null);
  const found = ranked(useEntries(), typed.value).slice(0, 60);
  const chosen = Math.min(at.value, found.length - 1);
  useEffect(() => list.current?.children[chosen]?.scrollIntoView({ block: "nearest" }), [chosen]);
  const choose = (entry: Entry | undefined): void => {
    if (!entry) return;
    closeDialog();
    entry.run();
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[event.key];
    if (by) at.value = Math.min(found.length - 1, Math.max(0, chosen + by));
    else if (event.key === "Enter") choose(found[chosen]);
    else return;
    event.preventDefault();
  };
  return (
    <Dialog title="Find anything" bare class="palette" close={closeDialog}>
      <input
        type="search" class="palette-input" placeholder="What do you want to do?" autoFocus
        role="combobox" aria-expanded aria-controls="palette-list" aria-label="Find anything"
        aria-activedescendant={chosen >= 0 ? `palette-${chosen}` : undefined}
        value={typed.value}
        onInput={(event) => {
          typed.value = event.currentTarget.value;
          at.value = 0;
        }}
        onKeyDown={onKeyDown}
      />
      <ul class="palette-list" id="palette-list" role="listbox" aria-label="Found" ref={list}>
        {found.map((entry, i) => (
          <li
            key={entry.id} id={`palette-${i}`} role="option" aria-selected={i === chosen} class="palette-row"
            onPointerMove={() => (at.value = i)} onClick={() => choose(entry)}
          >
            <span class="menu-icon">{entry.icon && <entry.icon aria-hidden />}</span>
            <span class="menu-title">{entry.title}</span>
            <span class="muted">{entry.about}</span>
            {entry.keys && <Keys keys={entry.keys} />}
          </li>
        ))}
        {found.length === 0 && <li class="empty">Nothing is called so.</li>}
      </ul>
    </Dialog>
  );
}
