// A button with a menu under it: arrows move, Enter chooses, Escape and a click elsewhere close it.
import { signal, useSignal } from "@preact/signals";
import { ChevronDown } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { findAction, isPossible } from "../../actions/registry";
import { Keys } from "./keys";

/** An action's id, or "-" for a line. */
export type MenuEntry = string;

const openMenu = signal<string | null>(null);

interface MenuProps {
  label: string;
  entries: readonly MenuEntry[];
  children?: ComponentChildren;
}

export function Menu({ label, entries, children }: MenuProps) {
  const root = useRef<HTMLDivElement>(null);
  const open = openMenu.value === label;
  const close = (): void => {
    openMenu.value = null;
  };
  useEffect(() => {
    if (!open) return;
    const outside = (event: Event): void => {
      if (!root.current?.contains(event.target as Node)) close();
    };
    addEventListener("pointerdown", outside, true);
    addEventListener("focusin", outside, true);
    return () => {
      removeEventListener("pointerdown", outside, true);
      removeEventListener("focusin", outside, true);
    };
  }, [open]);
  return (
    <div class="menu" ref={root}>
      <button
        class="plain"
        aria-haspopup="menu"
        aria-expanded={open}
        onClick={() => (openMenu.value = open ? null : label)}
        onKeyDown={(event) => {
          if (event.key !== "ArrowDown") return;
          event.preventDefault();
          openMenu.value = label;
        }}
      >
        {children ?? label}
        <ChevronDown class="small" aria-hidden />
      </button>
      {open && (
        <MenuList label={label} entries={entries} close={close} button={() => root.current?.querySelector("button")} />
      )}
    </div>
  );
}

interface MenuListProps {
  label: string;
  entries: readonly MenuEntry[];
  close: () => void;
  button: () => HTMLElement | null | undefined;
}

function MenuList({ label, entries, close, button }: MenuListProps) {
  const list = useRef<HTMLDivElement>(null);
  const at = useSignal(0);
  const items = (): HTMLElement[] => [
    ...list.current!.querySelectorAll<HTMLElement>("[role^=menuitem]:not(:disabled)"),
  ];
  useEffect(() => items()[0]?.focus(), []);
  const onKeyDown = (event: KeyboardEvent): void => {
    const all = items();
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) at.value = (at.value + step + all.length) % all.length;
    else if (event.key === "Home") at.value = 0;
    else if (event.key === "End") at.value = all.length - 1;
    else if (event.key === "Escape") {
      close();
      button()?.focus();
    } else return;
    event.preventDefault();
    event.stopPropagation();
    all[at.value]?.focus();
  };
  return (
    <div class="menu-list" role="menu" aria-label={label} ref={list} onKeyDown={onKeyDown}>
      {entries.map((id, i) => (id === "-" ? <hr key={i} /> : <MenuItem key={id} id={id} close={close} />))}
    </div>
  );
}

function MenuItem({ id, close }: { id: string; close: () => void }) {
  const action = findAction(id);
  if (!action) return null;
  const Icon = action.icon;
  const checked = action.checked?.();
  return (
    <button
      class="plain menu-item"
      role={checked === undefined ? "menuitem" : "menuitemcheckbox"}
      aria-checked={checked}
      disabled={!isPossible(action)}
      tabIndex={-1}
      onClick={() => {
        close();
        action.run();
      }}
    >
      <span class="menu-icon">{Icon && <Icon aria-hidden />}</span>
      <span class="menu-title">{action.title}</span>
      {action.keys?.[0] && <Keys keys={action.keys[0]} />}
    </button>
  );
}
