// Keys as they are written in menus ("Ctrl+Shift+Z", "?", "F") and whether an event is one of them.

export interface KeyPress {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  shiftKey: boolean;
  altKey: boolean;
}

const kNames: { [name: string]: string } = {
  Esc: "escape", Space: " ", Plus: "+", Left: "arrowleft", Right: "arrowright", Up: "arrowup", Down: "arrowdown",
};

/** Signs such as "?" are typed with Shift on some keyboards and without on others: Shift counts for letters and
 * names. */
function shiftCounts(key: string): boolean {
  return key.length > 1 || key === " " || key.toLowerCase() !== key.toUpperCase();
}

export function matches(press: KeyPress, keys: string): boolean {
  const parts = keys.split("+");
  const name = parts.pop() || "+";
  const wanted = (kNames[name] ?? name).toLowerCase();
  if (press.key.toLowerCase() !== wanted) return false;
  if (
    (press.ctrlKey || press.metaKey) !== parts.includes("Ctrl") || press.altKey !== parts.includes("Alt")
  ) return false;
  return !shiftCounts(press.key) || press.shiftKey === parts.includes("Shift");
}

/** For people: Ctrl is Command on a Mac. */
export function keysText(keys: string, mac: boolean): string {
  return mac ? keys.replace("Ctrl+", "⌘").replace("Shift+", "⇧").replace("Alt+", "⌥") : keys;
}

/** Keys without Ctrl are letters while something is typed. */
export function isTyping(target: EventTarget | null): boolean {
  const element = target as (
    { tagName?: string; type?: string; isContentEditable?: boolean; shadowRoot?: unknown } | null
  );
  if (!element?.tagName) return false;
  if (element.isContentEditable || element.tagName === "TEXTAREA" || element.tagName === "SELECT") return true;
  if (element.shadowRoot) return true;  // the text pane
  return element.tagName === "INPUT"
    && !["checkbox", "radio", "range", "button", "color", "file"].includes(element.type ?? "");
}
