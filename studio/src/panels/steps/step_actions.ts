// What can be done with steps from anywhere, for the palette, the menus and the keyboard.
import { CircleSlash, Copy, ListPlus, Pin, Trash2 } from "lucide-preact";
import type { Action } from "../../actions/registry";
import type { Studio } from "../../document/studio";
import { adding } from "./adding";
import { duplicate, isPinned, removeStep, toggleBypass, togglePin } from "./step_edits";

/** Tab is the search's where it would go nowhere: over the views. */
function overViews(): boolean {
  const at = document.activeElement;
  return at === null || at === document.body || at.matches("canvas") || at.closest("[data-views]") !== null;
}

export function stepActions(studio: Studio): Action[] {
  const group = "Steps";
  const add = () => { adding.value = { after: studio.selected.value }; };
  const selected = () => studio.selected.value;
  const onSelected = (run: (id: string) => void) => () => { const id = selected(); if (id !== null) run(id); };
  const any = () => selected() !== null;
  return [
    { id: "step.add", title: "Add step…", group, icon: ListPlus, keys: ["Shift+A", "Tab"],
      keysWhen: (keys) => keys !== "Tab" || overViews(), words: "operator node new insert", run: add },
    { id: "step.bypass", title: "Leave the step out", group, icon: CircleSlash, keys: ["Ctrl+B"],
      words: "bypass mute disable", when: any,
      checked: () => studio.step(selected() ?? "")?.bypass === true,
        run: onSelected((id) => toggleBypass(studio, id)) },
    { id: "step.pin", title: "Pin the step", group, icon: Pin, words: "preview show", when: any,
      checked: () => isPinned(studio, selected() ?? ""), run: onSelected((id) => togglePin(studio, id)) },
    { id: "step.duplicate", title: "Duplicate the step", group, icon: Copy, keys: ["Shift+D"], words: "copy", when: any,
      run: onSelected((id) => void duplicate(studio, id)) },
    { id: "step.remove", title: "Remove the step", group, icon: Trash2, words: "delete", when: any,
      run: onSelected((id) => void removeStep(studio, id)) },
    { id: "step.document", title: "Document: size, seed, variables", group, words: "domain cells",
      run: () => { studio.selected.value = null; } },
  ];
}
