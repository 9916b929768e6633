// A shortcut as it is shown, and a button for an action, with its name and keys as a hint.
import { findAction, isPossible } from "../../actions/registry";
import { keysText } from "../../actions/keys";

export const isMac = typeof navigator !== "undefined" && /Mac|iPhone|iPad/.test(navigator.platform);

export function Keys({ keys }: { keys: string }) {
  return <kbd>{keysText(keys, isMac)}</kbd>;
}

/** "Undo (Ctrl+Z)". */
export function hintOf(title: string, keys?: string): string {
  return keys ? `${title} (${keysText(keys, isMac)})` : title;
}

interface ActionButtonProps {
  id: string;
  /** Beside the icon. */
  text?: string;
  class?: string;
}

export function ActionButton({ id, text, class: className }: ActionButtonProps) {
  const action = findAction(id);
  if (!action) return null;
  const Icon = action.icon;
  return (
    <button
      class={`${text ? "" : "icon"} ${className ?? "plain"}`}
      aria-label={text ? undefined : action.title}
      aria-keyshortcuts={action.keys?.[0]?.replace("Ctrl", "Control")}
      aria-pressed={action.checked?.()}
      title={hintOf(action.title, action.keys?.[0])}
      disabled={!isPossible(action)}
      onClick={() => action.run()}
    >
      {Icon && <Icon aria-hidden />}
      {text}
    </button>
  );
}
