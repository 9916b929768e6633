// Help beside what is pointed at or has the focus: one bubble for everything below that says "data-help".
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";

interface Tip {
  text: string;
  left: number;
  top: number;
  above: boolean;
}

const WIDTH = 280;
const SHOW_AFTER_MS = 350;

function placed(element: Element, text: string): Tip {
  const box = element.getBoundingClientRect();
  const left = Math.max(8, Math.min(box.left, window.innerWidth - WIDTH - 8));
  const above = box.bottom + 110 > window.innerHeight;
  return { text, left, top: above ? box.top - 6 : box.bottom + 6, above };
}

export function HelpTips({ within }: { within: { current: HTMLElement | null } }): JSX.Element | null {
  const [tip, setTip] = useState<Tip | null>(null);
  useEffect(() => {
    const root = within.current;
    if (!root) return;
    let timer = 0;
    const later = (event: Event) => {
      window.clearTimeout(timer);
      const element = event.target instanceof Element ? event.target.closest("[data-help]") : null;
      const text = element?.getAttribute("data-help");
      if (!element || !text) return setTip(null);
      timer = window.setTimeout(() => { if (element.isConnected) setTip(placed(element, text)); }, SHOW_AFTER_MS);
    };
    const hide = () => {
      window.clearTimeout(timer);
      setTip(null);
    };
    const focused = (event: FocusEvent) => { if (event.target instanceof Element
      && event.target.matches(":focus-visible")) later(event); };
    root.addEventListener("pointerover", later);
    root.addEventListener("focusin", focused);
    for (const name of ["pointerleave", "pointerdown", "focusout", "keydown", "wheel"]) root.addEventListener(name,
      hide, { passive: true });
    return () => {
      hide();
      root.removeEventListener("pointerover", later);
      root.removeEventListener("focusin", focused);
      for (const name of ["pointerleave", "pointerdown", "focusout", "keydown", "wheel"]) root.removeEventListener(name,
        hide);
    };
  }, []);
  if (!tip) return null;
  return <div class={`help-tip${tip.above ? " above" : ""}`} role="tooltip"
    style={{ left: `${tip.left}px`, top: `${tip.top}px`, width: `${WIDTH}px` }}>{tip.text}</div>;
}
