// Files that a document names may be written by other programs: when the window is come back to, they are looked at
// again, by the engine (a step whose file is another has another result) and by what the page has read of them.
import { signal, type ReadonlySignal } from "@preact/signals";
import type { Api } from "../api/api";

const count = signal(0);
const leastPause_ms = 1000;

/** How often they were looked at again. */
export const filesLooked: ReadonlySignal<number> = count;

/** Looks whenever the window gets the focus, until the returned function is called. */
export function lookOnReturn(api: Pick<Api, "refresh">, window: EventTarget): () => void {
  let last = -Infinity;
  const look = (): void => {
    const now = performance.now();
    if (now - last < leastPause_ms) return;
    last = now;
    api.refresh().then(() => (count.value += 1), () => undefined);  // where there is no server the page says so
  };
  window.addEventListener("focus", look);
  return () => window.removeEventListener("focus", look);
}
