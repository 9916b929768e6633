// The sheet of shortcuts: what the registry knows, and what the views do with the mouse.
import { allActions } from "../../actions/registry";
import type { Action } from "../../actions/registry";
import { Dialog } from "./dialog";
import { Keys } from "./keys";
import { closeDialog } from "./shell";

const kGestures = [
  { title: "Orbit", keys: ["Middle button"] },
  { title: "Pan", keys: ["Shift+Middle button", "Space+Drag"] },
  { title: "Zoom to the pointer", keys: ["Wheel"] },
  { title: "Fly", keys: ["Right button", "W A S D"] },
  { title: "Brush: the opposite", keys: ["Ctrl+Draw"] },
  { title: "Brush: smooth", keys: ["Shift+Draw"] },
  { title: "Height under the pen", keys: ["Alt+Wheel"] },
];
const kFields = [
  { title: "Change a number", keys: ["Drag"] },
  { title: "Finer", keys: ["Shift+Drag"] },
  { title: "In round steps", keys: ["Ctrl+Drag"] },
  { title: "One step", keys: ["Wheel on the focus", "Ctrl+Wheel"] },
  { title: "Default again", keys: ["Backspace"] },
];

interface Row {
  title: string;
  keys: readonly string[];
}

/** Groups in the order of their first action; each key once. */
export function groupsOf(actions: readonly Action[]): [string, Row[]][] {
  const groups = new Map<string, Row[]>();
  for (const { group, title, keys } of actions) {
    if (!keys || keys.length === 0) continue;
    const rows = groups.get(group) ?? [];
    if (!rows.some((row) => row.title === title && row.keys[0] === keys[0])) rows.push({ title, keys });
    groups.set(group, rows);
  }
  return [...groups];
}

export function ShortcutsSheet() {
  const groups: [string, Row[]][] = [
    ...groupsOf(allActions.value), ["In the views", kGestures], ["Number fields", kFields],
  ];
  return (
    <Dialog title="Keyboard and mouse" class="sheet" close={closeDialog}>
      <div class="sheet-columns">
        {groups.map(([group, rows]) => (
          <section key={group} class="sheet-group">
            <h3>{group}</h3>
            <dl>
              {rows.map(({ title, keys }) => (
                <div key={title} class="sheet-row">
                  <dt>{title}</dt>
                  <dd>{keys.map((one) => <Keys key={one} keys={one} />)}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
