// The colour of a kind of value, the same at ports, wires and inputs.
import type { JSX } from "preact";

const KINDS = ["terrain", "labels", "field", "current", "image", "things", "catalogue", "objects", "drawing", "tin",
  "contours", "report"];

export function kindClass(kind: string): string {
  return `kind-${KINDS.includes(kind) ? kind : "report"}`;
}

export function KindMark({ kind }: { kind: string }): JSX.Element {
  return <span class={`kind-mark ${kindClass(kind)}`} data-help={kind} aria-hidden="true" />;
}
