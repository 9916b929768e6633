// The pen's tools among the page's actions.
import type { Action, IconType } from "../../actions/registry";
import type { OpenedStudio } from "../../document/open_studio";
import { offeredActions, toolActions } from "../../tools/actions";
import { ToolIcon } from "../../tools/icons";

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
