// A parameter as a row of the panel: title with help, control, and what takes it back to its default.
import type { JSX } from "preact";
import { RotateCcw } from "lucide-preact";
import type { ParamInfo } from "../../api/types";
import { CurveControl } from "../curves/curve_control";
import { HistogramEditor } from "../curves/histogram_editor";
import { namesClass } from "../../document/catalogue";
import { ClassControl, ClassesControl } from "./class_control";
import { ChoiceControl, ColourControl, NumberControl, NumbersControl, PointControl, PresetControl, SwitchControl,
  TextControl,
         TextsControl } from "./controls";
import { DrawButton, DrawnControl } from "./drawn_control";
import { FileControl, FilesControl } from "./file_control";
import { Group } from "./group";
import { ItemList } from "./item_list";
import { type Field, type Scope, fieldOf, isChanged, matchesSearch, resetField } from "./scope";
import { BindVariable, VariableControl } from "./variable_control";
import { isBindable } from "./variables";
import { titleOf, valueText } from "./words";

const WIDE = new Set<ParamInfo["kind"]>(["preset", "curve", "numbers", "integers", "files"]);

/** A distribution that is painted rather than typed. */
function isPainted(info: ParamInfo): boolean {
  return info.kind === "numbers" && /histogram|distribution/.test(info.name);
}

export function Control({ field }: { field: Field }): JSX.Element {
  const { info } = field;
  switch (info.kind) {
    case "number": case "integer": return <NumberControl field={field} />;
    case "switch": return <SwitchControl field={field} />;
    case "choice": return <ChoiceControl field={field} />;
    case "preset": return <PresetControl field={field} />;
    case "text": return namesClass(info) ? <ClassControl field={field} /> : <TextControl field={field} />;
    case "texts": return namesClass(info) ? <ClassesControl field={field} /> : <TextsControl field={field} />;
    case "file": case "model": return <FileControl field={field} />;
    case "files": return <FilesControl field={field} />;
    case "colour": return <ColourControl field={field} />;
    case "point": return <div class="point-draw"><PointControl field={field} /><DrawButton field={field} /></div>;
    case "curve": return <CurveControl field={field} />;
    case "numbers": case "integers": return isPainted(info)
      ? <HistogramEditor field={field} /> : <NumbersControl field={field} />;
    case "points": case "strokes": case "outlines": case "polygons": case "regions": case "rivers":
      return <DrawnControl field={field} />;
    default: return <span class="muted">{valueText(field.value, info)}</span>;
  }
}

/** The one under the pointer, as it is now; `last`: the pointer has moved since the focus did. */
export const hovered: { field: Field | null; last: boolean } = { field: null, last: false };

export function ParamRow({ field }: { field: Field }): JSX.Element {
  const { info } = field;
  if (hovered.field?.pointer === field.pointer) hovered.field = field;
  const changed = isChanged(field);
  const title = titleOf(info.name);
  const wide = WIDE.has(info.kind);
  const mayBind = field.variable === null && field.scope.step !== "" && isBindable(info);
  const plainPreset = info.kind === "preset" && info.name === "preset";
  return (
    <div class={`param${wide ? " wide" : ""}${changed ? " changed" : ""}`} data-param={field.pointer}
      onPointerMove={() => Object.assign(hovered, { field, last: true })}
      onPointerLeave={() => { hovered.field = null; }}>
      <span class="param-title" data-help={info.help || undefined}>{plainPreset ? "Preset" : title}</span>
      {mayBind && <BindVariable field={field} />}
      <div class="param-control">{field.variable !== null
        ? <VariableControl field={field} /> : <Control field={field} />}</div>
      {changed ? (
        <button type="button" class="plain icon small param-reset" aria-label={`Reset ${title}`}
          data-help={`Back to ${field.fallback === null ? "auto" : valueText(field.fallback, info)} (Backspace)`}
          onClick={() => resetField(field)}>
          <RotateCcw /></button>
      ) : <span class="param-reset" />}
    </div>
  );
}

/** Members of one object, groups folded below the plain ones where they were written. */
export function ParamList({ scope, search = "" }: { scope: Scope; search?: string }): JSX.Element {
  return (
    <div class="param-list">
      {scope.params.filter((info) => matchesSearch(info, search)).map((info) => {
        const field = fieldOf(scope, info);
        if (info.kind === "group") return <Group key={info.name} field={field} search={search} />;
        if (info.kind === "groups" || info.kind === "tools") return <ItemList key={info.name} field={field} />;
        return <ParamRow key={info.name} field={field} />;
      })}
    </div>
  );
}
