// The rail of tools at the side of the map: what draws into the selected step, how what is drawn is edited, and behind
// the dots what else there is, with the step that it would add.
import { useEffect, useRef } from "preact/hooks";
import { useSignal } from "@preact/signals";
import type { Studio } from "../document/studio";
import { activeTool } from "./active";
import { ToolIcon } from "./icons";
import type { Offer } from "./offers";
import { toolsOf, type PenViewport, type ToolBox } from "./toolbox";

interface Props {
  studio: Studio;
  viewport: PenViewport | null;
}

function ToolButton({ offer, tools }: { offer: Offer; tools: ToolBox }) {
  const { look, help } = offer;
  const active = tools.active.value.id === offer.id;
  return (
    <button type="button" class={`tool ${active ? "active" : ""}`} aria-pressed={active} aria-label={look.title}
      onClick={() => tools.take(offer.id)}>
      <ToolIcon name={look.icon} />
      <span class="tool-tip" aria-hidden="true">
        <span class="tool-tip-title">{look.title}{look.keys && <kbd>{look.keys}</kbd>}</span>
        <span class="muted">{help}</span>
      </span>
    </button>
  );
}

function MoreTools({ offers, tools }: { offers: readonly Offer[]; tools: ToolBox }) {
  const open = useSignal(false);
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!open.value) return undefined;
    const close = (event: Event) => {
      if (!box.current?.contains(event.target as Node)) open.value = false;
    };
    document.addEventListener("pointerdown", close, true);
    return () => document.removeEventListener("pointerdown", close, true);
  }, [open.value]);
  if (offers.length === 0) return null;
  const active = offers.some((offer) => offer.id === activeTool.value);
  const keys = (event: KeyboardEvent) => {
    if (event.key !== "Escape") return;
    open.value = false;
    event.stopPropagation();
  };
  return (
    <div class="more-tools" ref={box} onKeyDown={keys}>
      <button type="button" class={`tool ${active ? "active" : ""}`} aria-label="More tools" aria-expanded={open.value} aria-haspopup="menu"
        title="More tools" onClick={() => (open.value = !open.value)}>
        <ToolIcon name="more" />
      </button>
      {open.value && (
        <div class="more-list" role="menu" aria-label="More tools">
          {offers.map((offer) => (
            <button key={offer.id} type="button" class="plain" role="menuitem" onClick={() => {
              tools.take(offer.id);
              open.value = false;
            }}>
              <ToolIcon name={offer.look.icon} />
              <span>{offer.look.title}</span>
              <span class="muted">{offer.help}</span>
            </button>
          ))}
        </div>
      )}
    </div>
  );
}

export function ToolRail({ studio, viewport }: Props) {
  const tools = toolsOf(studio);
  useEffect(() => (viewport ? tools.attach(viewport) : undefined), [tools, viewport]);
  const { rail, more } = tools.offers.value;
  const groups = (["edit", "draw", "brush", "measure"] as const).map((group) => rail.filter((offer) => offer.group === group));
  const alone = rail.filter((offer) => offer.group === "more");
  return (
    <div class="tool-rail" role="toolbar" aria-orientation="vertical" aria-label="Tools">
      {[groups[0]!, [...alone, ...groups[1]!], groups[2]!].filter((group) => group.length > 0).map((group) => (
        <div class="tool-group" key={group[0]!.id}>
          {group.map((offer) => <ToolButton key={offer.id} offer={offer} tools={tools} />)}
        </div>
      ))}
      <MoreTools offers={more} tools={tools} />
      <div class="tool-group last">
        {groups[3]!.map((offer) => <ToolButton key={offer.id} offer={offer} tools={tools} />)}
      </div>
    </div>
  );
}
