// Parameters that belong together, folded until they are wanted or something in them is changed.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { ChevronRight, RotateCcw } from "lucide-preact";
import { ParamList } from "./param_row";
import { type Field, innerScope, isMembers, resetField } from "./scope";
import { titleOf } from "./words";

/** Open or closed as it was left, for all steps alike, while the page is open. */
const left = new Map<string, boolean>();

export function Group({ field, search }: { field: Field; search: string }): JSX.Element {
  const { info, scope } = field;
  const tool = info.tools?.[0];
  const inner = innerScope(scope, info.name, tool?.params ?? [], true);
  const count = isMembers(field.stated) ? Object.keys(field.stated).length : 0;
  const key = field.pointer;
  const [open, setOpen] = useState(left.get(key) ?? count > 0);
  const shown = open || search.trim() !== "";
  const title = titleOf(info.name);
  const titleFits = search.trim() !== "" && `${info.name} ${title}`.toLowerCase().includes(search.trim().toLowerCase());
  const toggle = () => {
    left.set(key, !open);
    setOpen(!open);
  };
  return (
    <section class={`group${shown ? " open" : ""}`}>
      <div class="group-head">
        <button type="button" class="plain group-toggle" aria-expanded={shown} data-help={info.help || undefined}
          onClick={toggle}>
          <ChevronRight class="chevron" />{title}{count > 0 && <span class="count"
            aria-label={`${count} changed`}>{count}</span>}
        </button>
        {count > 0 && <button type="button" class="plain icon small" aria-label={`Reset all of ${title}`}
          data-help="Reset all of them"
          onClick={() => resetField(field)}><RotateCcw /></button>}
      </div>
      {shown && <div class="group-body"><ParamList scope={inner} search={titleFits ? "" : search} /></div>}
    </section>
  );
}
