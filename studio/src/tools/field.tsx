// A value in the bar of options, by its kind.
import type { Json, ParamInfo } from "../api/types";
import { NumberField } from "../panels/params/number_field";
import { newGesture } from "../panels/params/scope";
import { titleOf } from "../panels/params/words";

interface Props {
  member: ParamInfo;
  value: Json;
  /** What it usually is here: the middle of the field's scale. */
  usual: number | null;
  /** `gesture`: edits of one drag share it. */
  change(value: Json, gesture: string): void;
}

function NumberValue({ member, value, usual, change }: Props) {
  const { name, unit, min, max, help } = member;
  return (
    <div class="tool-number">
      <NumberField
        label={titleOf(name)}
        prefix={titleOf(name)}
        value={typeof value === "number" ? value : null}
        unit={unit}
        help={help}
        min={min}
        max={max}
        integer={member.kind === "integer"}
        usual={usual}
        onChange={(next, gesture) => change(next, gesture)}
        onReset={(gesture) => change(member.default, gesture ?? newGesture())}
      />
    </div>
  );
}

export function Field(props: Props) {
  const { member, value, change } = props;
  const title = titleOf(member.name);
  if (member.kind === "number" || member.kind === "integer") return <NumberValue {...props} />;
  let control;
  if (member.kind === "switch") {
    control = (
      <input
        type="checkbox"
        checked={value === true}
        onChange={(event) => change(event.currentTarget.checked, newGesture())}
      />
    );
  } else if (member.kind === "choice") {
    control = (
      <select value={String(value)} onChange={(event) => change(event.currentTarget.value, newGesture())}>
        {(member.choices ?? []).map((choice) => <option key={choice} value={choice}>{titleOf(choice)}</option>)}
      </select>
    );
  } else {
    control = (
      <input type="text" class="tool-text" value={String(value ?? "")} onKeyDown={(event) => event.stopPropagation()}
        onChange={(event) => change(event.currentTarget.value, newGesture())} />
    );
  }
  return (
    <label class="tool-field" title={member.help}>
      <span class="muted">{title}</span>
      {control}
    </label>
  );
}
