// What a step reads: for each input the step and output it is connected to, or a file; only what fits is offered.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { ChevronRight, CircleDashed, X } from "lucide-preact";
import type { OperatorInfo, PortInfo, Step } from "../../api/types";
import type { Studio } from "../../document/studio";
import { UploadCancelled, uploadFile } from "../../document/uploads";
import { type Connections, type Origin, connectingEdits, connectionsOf, offersFor } from "../graph/connections";
import { KindMark } from "../graph/kind_mark";
import { titleOf } from "./words";

export function originText(origin: Origin): string {
  return "file" in origin ? origin.file : `${origin.step}.${origin.port}`;
}

/** "reef: terrain from isle.terrain". */
function connect(studio: Studio, step: string, input: string, origin: Origin | null): Promise<boolean> {
  const edits = connectingEdits([{ step, input, origin }], studio.document.value.recipe,
    (name) => studio.operator(name));
  return studio.edit(edits, origin ? `${step}: ${input} from ${originText(origin)}` : `${step}: ${input} disconnected`);
}

const FILE = "\0file";

function InputRow({ studio, step, input, origin }: { studio: Studio; step: Step; input: PortInfo;
  origin: Origin | undefined }): JSX.Element {
  const offers = offersFor(step.id, input, studio.document.value.recipe, (name) => studio.operator(name));
  const current = origin ? originText(origin) : "";
  const known = origin === undefined || "file" in origin
    || offers.some((offer) => originText({ step: offer.step, port: offer.port.name }) === current);
  const files = studio.schema.kinds.find((kind) => kind.name === input.kind)?.files ?? [];
  const choose = async (value: string) => {
    if (value === FILE) return takeFile(studio, step.id, input, files);
    const [id = "", port = ""] = value.split(".");
    await connect(studio, step.id, input.name, value === "" ? null : { step: id, port });
  };
  const open = origin === undefined && input.required;
  return (
    <div class={`input-row${open ? " open" : ""}`}>
      <span class="param-title"
        data-help={input.help || undefined}><KindMark kind={input.kind} />{titleOf(input.name)}</span>
      <select class="select" aria-label={`Input ${input.name}`} value={current} aria-invalid={open}
        onChange={(event) => void choose(event.currentTarget.value)}>
        <option value="">{input.required ? "open: choose…" : "none"}</option>
        {!known && <option value={current}>{current}</option>}
        {origin && "file" in origin && <option value={current}>{current}</option>}
        {offers.map((offer) => {
          const value = `${offer.step}.${offer.port.name}`;
          return <option key={value} value={value}>{value}</option>;
        })}
        <option value={FILE}>A file…</option>
      </select>
      {open ? <CircleDashed class="open-mark" aria-label="open" /> : origin ? (
        <button type="button" class="plain icon small" aria-label={`Disconnect ${input.name}`} data-help="Disconnect"
          onClick={() => void choose("")}><X /></button>) : <span />}
    </div>
  );
}

/** Asks for a file, takes it into the studio's folder and connects it. */
function takeFile(studio: Studio, step: string, input: PortInfo, endings: readonly string[]): void {
  const chooser = document.createElement("input");
  chooser.type = "file";
  if (endings.length > 0) chooser.accept = endings.join(",");
  chooser.onchange = async () => {
    const file = chooser.files?.[0];
    if (!file) return;
    try {
      const taken = await uploadFile(studio.api, file);
      await connect(studio, step, input.name, { file: taken.file });
    } catch (problem) {
      if (problem instanceof UploadCancelled) return;
      studio.message.value = { kind: "error", text: problem instanceof Error ? problem.message : String(problem),
        step };
    }
  };
  chooser.click();
}

export function Inputs({ studio, step, op }: { studio: Studio; step: Step; op: OperatorInfo }): JSX.Element | null {
  const [all, setAll] = useState(false);
  if (op.in.length === 0) return null;
  const { recipe } = studio.document.value;
  const connections: Connections = connectionsOf(recipe, recipe.steps.indexOf(step), (name) => studio.operator(name));
  const first = op.in.filter((input) => input.required || connections.has(input.name));
  const rest = op.in.filter((input) => !first.includes(input));
  const row = (input: PortInfo) => <InputRow key={input.name} studio={studio} step={step} input={input}
    origin={connections.get(input.name)} />;
  return (
    <section class="inputs" aria-label="Inputs">
      {first.map(row)}
      {rest.length > 0 && (
        <button type="button" class="plain group-toggle quiet" aria-expanded={all} onClick={() => setAll(!all)}>
          <ChevronRight class="chevron" />{first.length > 0
            ? `${rest.length} more ${rest.length === 1 ? "input" : "inputs"}`
            : `${rest.length} ${rest.length === 1 ? "input" : "inputs"}`}
        </button>
      )}
      {all && rest.map(row)}
    </section>
  );
}
