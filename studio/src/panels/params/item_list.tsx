// A list of alike things (groups) or of tools: each a card that opens when it is chosen; added, removed, copied and put
// in another order. The chosen one is what the pen works on (active_item.ts).
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { ArrowDown, ArrowUp, Copy, Pencil, Plus, RotateCcw, Trash2 } from "lucide-preact";
import type { Json, ParamInfo } from "../../api/types";
import { EventLines, hasTimes } from "../timeline/event_lines";
import { activeItem, drawing, drawRequest } from "./active_item";
import { drawnText } from "./measures";
import { type ToolInfo, activate, addTool, itemsOf, listEdits } from "./list_edits";
import { ParamList } from "./param_row";
import { type Field, innerScope, isMembers, resetField } from "./scope";
import { amountText, counted, titleOf, wordOf } from "./words";

const DRAWN = new Set(["points", "strokes", "polygons", "regions", "rivers"]);

export function toolOf(info: ParamInfo, item: Json): ToolInfo | undefined {
  const name = isMembers(item) && typeof item["tool"] === "string" ? item["tool"] : "";
  return info.tools?.find((tool) => tool.name === name) ?? (info.kind === "groups" ? info.tools?.[0] : undefined);
}

/** A few words that tell an item from its neighbours: "1800 m", "3 points, 4.2 km". */
export function itemText(tool: ToolInfo | undefined, item: Json): string {
  if (!tool || !isMembers(item)) return "";
  const parts: string[] = typeof item["start"] === "number" || typeof item["end"] === "number"
    ? [`${item["start"] ?? 0} to ${item["end"] ?? "…"}`] : [];
  for (const param of tool.params) {
    const value = item[param.name];
    if (value === undefined || parts.length >= 3 || param.name === "start" || param.name === "end") continue;
    if (DRAWN.has(param.kind)) parts.push(drawnText(param.kind, value));
    else if (typeof value === "number") parts.push(parts.length === 0 || param.unit !== ""
      ? amountText(value, param.unit) : "");
    else if (typeof value === "string" && value !== "") parts.push(wordOf(value));
  }
  return parts.filter(Boolean).slice(0, 3).join(", ");
}

export function ItemList({ field }: { field: Field }): JSX.Element {
  const { info } = field;
  const items = itemsOf(field);
  const drawn = info.kind === "groups" && (info.tools?.[0]?.params.some((param) => DRAWN.has(param.kind)) ?? false);
  const pressed = drawing.value === field.pointer;
  const title = titleOf(info.name);
  return (
    <section class="items" data-param={field.pointer}>
      <div class="items-head">
        <span class="param-title" data-help={info.help || undefined}>{title}</span>
        <span class="muted items-count">{items.length > 0 ? counted(items.length, "item") : ""}</span>
        {items.length > 0 && field.stated !== undefined && <button type="button" class="plain icon small"
          aria-label={`Remove all of ${title}`}
          data-help="Remove all" onClick={() => resetField(field)}><RotateCcw /></button>}
        {drawn && <button type="button" class="compact draw" aria-pressed={pressed}
          aria-label={`Draw ${title.toLowerCase()}`}
          onClick={() => { drawRequest.value = { step: field.scope.step, pointer: field.pointer, kind: info.kind,
          name: info.name }; }}>
          <Pencil />Draw</button>}
        <AddItem field={field} onAdd={(tool) => addTool(field, tool)} />
      </div>
      {hasTimes(info) && items.length > 0 && <EventLines field={field} />}
      <ol class="item-cards">
        {items.map((item, i) => <ItemCard key={i} field={field} index={i} item={item} count={items.length} />)}
      </ol>
    </section>
  );
}

export function AddItem({ field, onAdd }: { field: Field; onAdd(tool: ToolInfo): void }): JSX.Element | null {
  const tools = field.info.tools ?? [];
  const title = titleOf(field.info.name).toLowerCase();
  if (field.info.kind === "groups") {
    const only = tools[0];
    return only ? <button type="button" class="plain compact" aria-label={`Add to ${title}`}
      onClick={() => onAdd(only)}><Plus />Add</button> : null;
  }
  return (
    <select class="select add-tool" aria-label={`Add to ${title}`} value=""
      onChange={(event) => {
        const tool = tools.find((candidate) => candidate.name === event.currentTarget.value);
        event.currentTarget.value = "";
        if (tool) onAdd(tool);
      }}>
      <option value="" disabled hidden>+ Add…</option>
      {tools.map((tool) => <option key={tool.name} value={tool.name} title={tool.about}>{wordOf(tool.name)}</option>)}
    </select>
  );
}

interface ItemCardProps {
  field: Field;
  index: number;
  item: Json;
  count: number;
}

function ItemCard({ field, index, item, count }: ItemCardProps): JSX.Element {
  const pointer = `${field.pointer}/${index}`;
  const active = activeItem.value?.pointer === pointer;
  const tool = toolOf(field.info, item);
  const edits = listEdits(field);
  const [over, setOver] = useState(false);
  const name = tool?.name ? wordOf(tool.name) : `${titleOf(field.info.name).replace(/s$/, "")} ${index + 1}`;
  const onKeyDown = (event: KeyboardEvent) => {
    const by = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    if (by !== 0 && event.altKey) {
      edits.move(index, index + by);
      if (active && index + by >= 0 && index + by < count) activate(field, index + by);
    } else if (event.key === "Delete") edits.remove(index);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const drop = (event: DragEvent) => {
    setOver(false);
    const from = event.dataTransfer?.getData("text/x-item")?.split("\n");
    if (from?.[0] !== field.pointer) return;
    event.preventDefault();
    edits.move(Number(from[1]), index);
  };
  return (
    <li class={`item-card${active ? " active" : ""}${over ? " over" : ""}`}
      onDragOver={(event) => { event.preventDefault(); setOver(true); }}
      onDragLeave={() => setOver(false)} onDrop={drop}>
      <div class="item-head">
        <button type="button" class="plain item-name" aria-expanded={active} draggable onKeyDown={onKeyDown}
          data-help={tool?.about || undefined}
          onDragStart={(event) => event.dataTransfer?.setData("text/x-item", `${field.pointer}\n${index}`)}
          onClick={() => activate(field, active ? null : index)}>
          <span class="item-title">{name}</span><span class="muted ellipsis">{itemText(tool, item)}</span>
        </button>
        <span class="item-actions">
          {index > 0 && <button type="button" class="plain icon small" aria-label={`Move ${name} up`}
            onClick={() => edits.move(index, index - 1)}><ArrowUp /></button>}
          {index + 1 < count && <button type="button" class="plain icon small" aria-label={`Move ${name} down`}
            onClick={() => edits.move(index, index + 1)}><ArrowDown /></button>}
          <button type="button" class="plain icon small" aria-label={`Copy ${name}`}
            onClick={() => edits.insert(index + 1, item, "copied")}><Copy /></button>
          <button type="button" class="plain icon small" aria-label={`Remove ${name}`}
            onClick={() => { edits.remove(index); if (active) activate(field, null); }}><Trash2 /></button>
        </span>
      </div>
      {active && tool && <div class="item-body"><ParamList scope={itemScope(field, index, item, tool)} /></div>}
    </li>
  );
}

/** Members of an item; where the list is not stated itself, they cannot be set singly and the list is written first. */
function itemScope(field: Field, index: number, item: Json, tool: ToolInfo) {
  const list = { ...innerScope(field.scope, field.info.name, [], false, {}), stated: {} };
  const scope = innerScope(list, String(index), tool.params, false, item);
  if (Array.isArray(field.stated)) return scope;
  const studio = { ...scope.studio, edit: (edits: Parameters<typeof scope.studio.edit>[0], label: string,
    gesture?: string) =>
    scope.studio.edit([{ do: "set" as const, pointer: field.pointer, value: itemsOf(field) }, ...edits], label,
      gesture) };
  return { ...scope, studio };
}

