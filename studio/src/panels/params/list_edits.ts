// Edits of a list of groups or tools: an item put in, taken out, moved; and which of them is worked on.
import type { Json, ParamInfo } from "../../api/types";
import { activeItem } from "./active_item";
import type { Field } from "./scope";
import { titleOf, wordOf } from "./words";

export type ToolInfo = NonNullable<ParamInfo["tools"]>[number];

export function itemsOf(field: Field): Json[] {
  return Array.isArray(field.value) ? field.value : [];
}

/** The list written anew where it is not stated; edits of single items where it is. */
export function listEdits(field: Field) {
  const { studio, owner } = field.scope;
  const items = itemsOf(field);
  const stated = Array.isArray(field.stated);
  const name = titleOf(field.info.name).toLowerCase();
  const whole = (next: Json[], label: string) => void studio.edit([{ do: "set", pointer: field.pointer, value: next }],
    label);
  return {
    insert(index: number, value: Json, what = "added") {
      const label = `${owner}: ${name}, ${what}`;
      if (stated) void studio.edit([{ do: "insert", list: field.pointer, index, value }], label);
      else whole([...items.slice(0, index), value, ...items.slice(index)], label);
    },
    remove(index: number) {
      const label = `${owner}: ${name}, one removed`;
      if (items.length === 1) void studio.edit([{ do: "set", pointer: field.pointer }], label);
      else if (stated) void studio.edit([{ do: "remove", item: `${field.pointer}/${index}` }], label);
      else whole(items.filter((_, i) => i !== index), label);
    },
    move(index: number, to: number) {
      if (to < 0 || to >= items.length) return;
      const label = `${owner}: ${name}, order`;
      if (stated) return void studio.edit([{ do: "move", item: `${field.pointer}/${index}`, index: to }], label);
      const next = [...items];
      next.splice(to, 0, ...next.splice(index, 1));
      whole(next, label);
    },
  };
}

export function activate(field: Field, index: number | null): void {
  activeItem.value = index === null ? null : { step: field.scope.step, pointer: `${field.pointer}/${index}` };
}

/** A new item at the end, which is worked on then. */
export function addTool(field: Field, tool: ToolInfo): void {
  const items = itemsOf(field);
  const value = field.info.kind === "tools" ? { tool: tool.name } : {};
  listEdits(field).insert(items.length, value, tool.name ? `${wordOf(tool.name)} added` : "added");
  activate(field, items.length);
}
