// The pen's tools among the page's actions, and Tab over the views, which asks for a step to add.
import type { Action, IconType } from "../../actions/registry";
import type { OpenedStudio } from "../../document/open_studio";
import { offeredActions, toolActions } from "../../tools/actions";
import { ToolIcon } from "../../tools/icons";
import { adding } from "./parts";

const icons = new Map<string, IconType>();

/** The same component for the same picture, so that nothing is drawn anew. */
function iconOf(name: string): IconType {
  const known = icons.get(name);
  if (known) return known;
  const icon: IconType = () => <ToolIcon name={name} size={16} />;
  icons.set(name, icon);
  return icon;
}

export function toolEntries(studio: OpenedStudio): Action[] {
  return [...offeredActions(studio), ...toolActions(studio)].map(({ id, title, keys, icon, run, enabled }) => ({
    id, title, group: "Tools", icon: iconOf(icon), keys: keys === "" ? [] : [keys], when: enabled, run,
  }));
}

/** Elsewhere Tab goes on to the next control. */
export function stepKey(studio: OpenedStudio, event: KeyboardEvent): boolean {
  if (event.key !== "Tab" || event.shiftKey || event.ctrlKey || event.altKey) return false;
  const target = event.target instanceof Element ? event.target : null;
  if (target !== document.body && !target?.matches(".view, .view canvas, .view [tabindex]")) return false;
  if (target === document.body && !document.querySelector(".view:hover")) return false;
  adding.value = { after: studio.selected.value };
  return true;
}
