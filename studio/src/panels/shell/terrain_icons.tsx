// Icons that lucide lacks, in its manner: 24 x 24, lines of the text's colour.
import type { ComponentChildren } from "preact";

function Drawing({ children }: { children: ComponentChildren }) {
  return (
    <svg
      class="lucide"
      viewBox="0 0 24 24"
      fill="none"
      stroke="currentColor"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden
    >
      {children}
    </svg>
  );
}

/** A range under a stroke. */
export function MountainStroke() {
  return <Drawing><path d="M2 20 8.5 9.5l3.2 5 3.3-6.5L22 20Z" /><path d="M3 6c3-3 6 1 9-1s4-2 6-1" /></Drawing>;
}
