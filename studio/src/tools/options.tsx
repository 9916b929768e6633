// The bar over the map: the active tool's values for what is drawn next; and those of what is selected.
import { classColour, type CatalogueClass } from "../document/catalogue";
import type { Studio } from "../document/studio";
import type { Json, ParamInfo } from "../api/types";
import { choose, chosenValue, ownReach, practical, reach, readout, selection, startValue } from "./active";
import { itemMembers, type Feature } from "./features";
import { Field } from "./field";
import { ToolIcon } from "./icons";
import { classesFor, firstClass } from "./objects";
import { kRegions, lookOf, nounOf } from "./names";
import { domainOf, type Domain } from "./place";
import type { Slot } from "./slots";
import { toolsOf, type ToolBox } from "./toolbox";

const kMost = 6;
/** Set in the panel of parameters, where there is room to say what they mean. */
const kInPanelOnly = new Set(["longitude_deg", "latitude_deg", "file", "on", "step_m", "feature", "peak_m", "invert"]);

function RegionChoice({ value, change }: { value: Json; change(region: string): void }) {
  return (
    <span class="tool-regions" role="radiogroup" aria-label="Region">
      {kRegions.map((region, i) => (
        <button key={region} type="button" role="radio" aria-checked={value === region} title={`${region} (${i + 1})`}
          class={`region ${region}`} onClick={() => change(region)}>
          <span class="swatch" />
          {value === region && <span>{region}</span>}
          <span class="unseen">{region}</span>
        </button>
      ))}
    </span>
  );
}

interface ClassChoiceProps {
  classes: readonly CatalogueClass[];
  value: Json;
  change(name: string): void;
}

/** A class of the scene's catalogue, with what it is. */
function ClassChoice({ classes, value, change }: ClassChoiceProps) {
  const about = classes.find((one) => one.name === value)?.about;
  return (
    <label class="tool-field" title={about || "of the catalogue"}>
      <span class="muted">Class</span>
      <span class="class-mark" style={{ background: classColour(classes, String(value)) }} />
      <select value={String(value)} onChange={(event) => change(event.currentTarget.value)}>
        {classes.map(({ name }) => <option key={name} value={name}>{name.replace(/_/g, " ")}</option>)}
      </select>
    </label>
  );
}

const kReach: ParamInfo = { name: "radius_m", kind: "number", unit: "m", min: 0.01, default: 0, help: "reach of the brush: [ and ] change it" };

function ReachField({ domain, geometry }: { domain: Domain; geometry: string | undefined }) {
  const value = ownReach(geometry, domain);
  return <Field member={practical(kReach, domain)} value={value} usual={null} change={(next) => (reach.value = Number(next))} />;
}

/** Members that the bar has room for: those that the hand can see first. */
function shownMembers(slot: Slot): readonly ParamInfo[] {
  const weight = ({ name }: ParamInfo) => {
    const order = [
      "region", "class", "name", "value", "height_m", "depth_m", "amplitude_m", "change_m", "rotation_deg", "scale", "height_scale", "raise_m",
      "radius_m", "width_m", "strength_m", "strength", "speed_m_s", "towards_deg",
    ];
    return order.indexOf(name) < 0 ? order.length : order.indexOf(name);
  };
  return slot.members.filter(({ name }) => !kInPanelOnly.has(name)).sort((a, b) => weight(a) - weight(b)).slice(0, kMost);
}

interface MembersProps {
  tools: ToolBox;
  slot: Slot;
  domain: Domain;
  /** What is selected of this slot. */
  features: readonly Feature[];
  /** Also for what is drawn next. */
  next: boolean;
}

function Members({ tools, slot, domain, features, next }: MembersProps) {
  const classes = classesFor(tools.studio, tools.studio.selected.value, slot);
  return (
    <>
      {shownMembers(slot).map((member) => {
        const stated = features[0] ? itemMembers(features[0])[member.name] : undefined;
        const value = features[0] ? (stated ?? member.default) : chosenValue(slot, member, domain);
        const change = (to: Json, gesture: string) => {
          if (next) choose(slot, member.name, to);
          if (features.length > 0) tools.setMember(features, member.name, to, gesture);
        };
        if (member.name === "region") {
          return <RegionChoice key={member.name} value={value} change={(to) => change(to, `option-region-${Date.now()}`)} />;
        }
        if (member.name === "class" && classes.length > 0) {
          return <ClassChoice key={member.name} classes={classes} value={value === "" || value === null ? firstClass(classes) : value}
            change={(to) => change(to, `option-class-${Date.now()}`)} />;
        }
        const usual = startValue(slot, member, domain);
        return <Field key={member.name} member={practical(member, domain)} value={value} usual={typeof usual === "number" ? usual : null} change={change} />;
      })}
    </>
  );
}

function hintOf(slot: Slot | undefined, id: string): string {
  if (id === "edit:select") return "Click selects, drag moves, double click adds a point";
  if (id === "edit:erase") return "Sweep over lines";
  if (!slot) return "Drag, or click from point to point";
  if (slot.brush) {
    const other = slot.tool === "raise" ? "Ctrl lowers" : slot.tool === "lower" ? "Ctrl raises" : slot.tool === "brush" || slot.tool === "region" ? "Ctrl erases" : "";
    return [other, slot.op === "terrain.sculpt" && slot.tool !== "smooth" ? "Shift smooths" : "", "[ ] size"].filter(Boolean).join(" · ");
  }
  if (slot.geometry === "line") return "Drag, or click from point to point; Enter ends";
  if (slot.geometry === "ring") return slot.click ? "Draw around, or click a contour" : "Draw around, or click corners; Ctrl makes a hole";
  if (slot.geometry === "polar") return "Drag the coast; Shift smooths";
  return slot.members.some((member) => member.name === "height_m") ? "Click sets, drag moves, digits or Alt+wheel give the height" : "Click sets, drag moves";
}

export function ToolOptions({ studio }: { studio: Studio }) {
  const tools = toolsOf(studio);
  const offer = tools.active.value;
  const domain = domainOf(studio.document.value.recipe);
  const { slot } = offer;
  const all = selection.value.size > 0 ? tools.selectedOfOneSlot() : [];
  const own = slot ? all.filter((feature) => feature.slot.id === slot.id && !slot.brush) : all;
  const shown = slot ?? own[0]?.slot;
  const title = slot || own.length === 0 ? offer.look.title : nounOf(own[0]!.slot);
  const count = selection.value.size;
  return (
    <div class="tool-bar" role="toolbar" aria-label={`Options: ${title}`}>
      <span class="tool-name"><ToolIcon name={slot || own.length === 0 ? offer.look.icon : lookOf(own[0]!.slot).icon} size={16} />{title}</span>
      {offer.adds && <span class="tool-adds">{offer.help}</span>}
      {shown && <Members tools={tools} slot={shown} domain={domain} features={own} next={slot !== undefined} />}
      {(offer.id === "edit:erase" || slot?.geometry === "polar") && <ReachField domain={domain} geometry={slot?.geometry} />}
      {count > 0 && !slot && <span class="tool-count">{count === 1 ? "1 selected" : `${count} selected`}</span>}
      <span class="tool-readout" aria-live="polite">{readout.value || <span class="tool-hint muted">{hintOf(slot, offer.id)}</span>}</span>
    </div>
  );
}
