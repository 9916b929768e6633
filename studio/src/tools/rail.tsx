// The rail of tools at the side of the map: what draws into the selected step, how what is drawn is edited, and behind
// the dots what else there is, with the step that it would add. Hints and the list stand over what lies beside the rail.
import { useEffect, useRef } from "preact/hooks";
import { useSignal, type Signal } from "@preact/signals";
import type { Studio } from "../document/studio";
import { activeTool } from "./active";
import { ToolIcon } from "./icons";
import type { Offer } from "./offers";
import { toolsOf, type PenViewport, type ToolBox } from "./toolbox";

interface Props {
  studio: Studio;
  viewport: PenViewport | null;
}

interface Hint {
  offer: Offer;
  left: number;
  top: number;
}

function ToolButton({ offer, tools, hint }: { offer: Offer; tools: ToolBox; hint: Signal<Hint | null> }) {
  const { look } = offer;
  const active = tools.active.value.id === offer.id;
  const show = (event: { currentTarget: HTMLElement }) => {
    const box = event.currentTarget.getBoundingClientRect();
    hint.value = { offer, left: box.right + 8, top: box.top + box.height / 2 };
  };
  const hide = () => (hint.value = null);
  return (
    <button type="button" class={`tool ${active ? "active" : ""}`} aria-pressed={active} aria-label={look.title}
      aria-keyshortcuts={look.keys || undefined} onPointerEnter={show} onPointerLeave={hide} onFocus={show} onBlur={hide}
      onClick={() => {
        hide();
        tools.take(offer.id);
      }}>
      <ToolIcon name={look.icon} />
    </button>
  );
}

function ToolHint({ hint }: { hint: Hint }) {
  const { look, help } = hint.offer;
  return (
    <div class="tool-hint-box" role="tooltip" style={{ left: `${hint.left}px`, top: `${hint.top}px` }}>
      <span class="tool-hint-title">{look.title}{look.keys && <kbd>{look.keys}</kbd>}</span>
      <span class="muted">{help}</span>
    </div>
  );
}

function MoreTools({ offers, tools }: { offers: readonly Offer[]; tools: ToolBox }) {
  const open = useSignal<{ left: number; top: number } | null>(null);
  const box = useRef<HTMLDivElement>(null);
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!open.value) return undefined;
    list.current?.querySelector("button")?.focus();
    const close = (event: Event) => {
      if (!box.current?.contains(event.target as Node)) open.value = null;
    };
    document.addEventListener("pointerdown", close, true);
    return () => document.removeEventListener("pointerdown", close, true);
  }, [open.value]);
  if (offers.length === 0) return null;
  const active = offers.some((offer) => offer.id === activeTool.value);
  const toggle = (event: { currentTarget: HTMLElement }) => {
    const { right, top } = event.currentTarget.getBoundingClientRect();
    const height = 34 * offers.length + 10;
    open.value = open.value ? null : { left: right + 8, top: Math.max(8, Math.min(top, window.innerHeight - height - 8)) };
  };
  const keys = (event: KeyboardEvent) => {
    const items = [...(list.current?.querySelectorAll("button") ?? [])];
    const at = items.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "Escape") {
      open.value = null;
      box.current?.querySelector("button")?.focus();
    } else if (event.key === "ArrowDown") items[(at + 1) % items.length]?.focus();
    else if (event.key === "ArrowUp") items[(at + items.length - 1) % items.length]?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div class="more-tools" ref={box} onKeyDown={keys}>
      <button type="button" class={`tool ${active ? "active" : ""}`} aria-label="More tools" aria-expanded={open.value !== null}
        aria-haspopup="menu" title="More tools" onClick={toggle}>
        <ToolIcon name="more" />
      </button>
      {open.value && (
        <div class="more-list" role="menu" aria-label="More tools" ref={list} style={{ left: `${open.value.left}px`, top: `${open.value.top}px` }}>
          {offers.map((offer) => (
            <button key={offer.id} type="button" class="plain" role="menuitem" onClick={() => {
              tools.take(offer.id);
              open.value = null;
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

/** The wheel with Alt or Shift over a view is the pen's, where it holds something that can be turned. */
function listenToWheel(tools: ToolBox): () => void {
  const listen = (event: WheelEvent): void => {
    if ((!event.altKey && !event.shiftKey) || !(event.target as Element).closest?.("[data-ground-view]")) return;
    const by = event.deltaY || event.deltaX;
    if (by === 0 || !tools.wheel(by < 0 ? 1 : -1)) return;
    event.preventDefault();
    event.stopPropagation();
  };
  document.addEventListener("wheel", listen, { capture: true, passive: false });
  return () => document.removeEventListener("wheel", listen, { capture: true });
}

export function ToolRail({ studio, viewport }: Props) {
  const tools = toolsOf(studio);
  useEffect(() => listenToWheel(tools), [tools]);
  const hint = useSignal<Hint | null>(null);
  useEffect(() => (viewport ? tools.attach(viewport) : undefined), [tools, viewport]);
  const { rail, more } = tools.offers.value;
  const groups = (["edit", "draw", "brush", "measure"] as const).map((group) => rail.filter((offer) => offer.group === group));
  const alone = rail.filter((offer) => offer.group === "more");
  return (
    <div class="tool-column" role="toolbar" aria-orientation="vertical" aria-label="Tools">
      {[groups[0]!, [...alone, ...groups[1]!], groups[2]!].filter((group) => group.length > 0).map((group) => (
        <div class="tool-group" key={group[0]!.id}>
          {group.map((offer) => <ToolButton key={offer.id} offer={offer} tools={tools} hint={hint} />)}
        </div>
      ))}
      <MoreTools offers={more} tools={tools} />
      <div class="tool-group last">
        {groups[3]!.map((offer) => <ToolButton key={offer.id} offer={offer} tools={tools} hint={hint} />)}
      </div>
      {hint.value && <ToolHint hint={hint.value} />}
    </div>
  );
}
