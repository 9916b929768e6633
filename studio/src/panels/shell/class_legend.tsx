// What the marks on the map are: the classes of a scene's objects, with their colours and numbers.
import { seenClasses } from "../../viewport/content";
import { counted } from "../params/words";

const kMost = 9;

export function ClassLegend() {
  const classes = seenClasses.value;
  if (classes.length === 0) return null;
  const rest = classes.slice(kMost);
  return (
    <div class="class-legend" role="list" aria-label="Objects">
      {classes.slice(0, kMost).map(({ name, colour, count }) => (
        <div class="class-row" role="listitem" key={name}>
          <span class="class-mark" style={{ background: colour }} />
          <span class="class-name ellipsis">{name.replace(/_/g, " ")}</span>
          <span class="muted">{count}</span>
        </div>
      ))}
      {rest.length > 0 && <div class="class-row muted" role="listitem">and {counted(rest.length, "class", "classes")} more</div>}
    </div>
  );
}
