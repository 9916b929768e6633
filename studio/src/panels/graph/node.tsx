// A step as a node of the graph: picture, name, standing; ports at its sides.
import type { JSX } from "preact";
import type { PortInfo, StepState } from "../../api/types";
import type { Studio } from "../../document/studio";
import { FamilyIcon } from "../steps/family_icon";
import { Progress, StandingSign } from "../steps/standing";
import { CardActions } from "../steps/step_card";
import { Thumbnail } from "../steps/thumbnail";
import { type GraphNode, NODE_WIDTH, portTop } from "./geometry";
import { kindClass } from "./kind_mark";
import { portKey } from "./wiring";

export interface NodeProps {
  studio: Studio;
  node: GraphNode;
  state: StepState | undefined;
  connected: ReadonlySet<string>;
  /** While a wire is in the hand: the keys of ports that fit it. */
  fits: ReadonlySet<string> | null;
  focusable: boolean;
  shift: readonly [number, number] | null;
  onPort(event: PointerEvent, side: "in" | "out", port: PortInfo): void;
  onGrab(event: PointerEvent): void;
  onKeyDown(event: KeyboardEvent): void;
}

export function Node(props: NodeProps): JSX.Element {
  const { studio, node, state, fits, shift } = props;
  const step = studio.step(node.id);
  const selected = studio.selected.value === node.id;
  const welcome = fits ? [...fits].some((key) => key.startsWith(`${node.id}/`)) : false;
  const classes = ["node", selected && "selected", step?.bypass && "bypassed", state?.standing === "failed" && "failed",
    fits && !welcome && "dim", fits && welcome && "welcome", shift && "held"]
    .filter(Boolean).join(" ");
  const [dx, dy] = shift ?? [0, 0];
  return (
    <div class={classes} data-node={node.id}
      style={{ left: `${node.x + dx}px`, top: `${node.y + dy}px`, width: `${NODE_WIDTH}px`,
      height: `${node.height}px` }}>
      <button type="button" class="plain node-head" aria-pressed={selected} tabIndex={props.focusable ? 0 : -1}
        aria-label={`${node.id}, ${node.opName}`}
        onPointerDown={props.onGrab} onKeyDown={props.onKeyDown} onClick={() => { studio.selected.value = node.id; }}>
        <Thumbnail studio={studio} id={node.id} op={node.op}
          stale={state !== undefined && state.standing !== "fresh"} />
        <span class="node-words"><span class="node-id"><FamilyIcon op={node.opName} />
          <span class="ellipsis">{node.id}</span></span>
          <StandingSign state={state} /></span>
      </button>
      <CardActions studio={studio} id={node.id} bypassed={step?.bypass === true} />
      {node.ins.map((port, i) => <Port key={port.name} side="in" port={port} row={i} {...props} />)}
      {node.hiddenIns > 0 && <span class="port-more"
        style={{ top: `${portTop(node.ins.length)}px` }}>{node.hiddenIns} more</span>}
      {node.outs.map((port, i) => <Port key={port.name} side="out" port={port} row={i} {...props} />)}
      <Progress state={state} />
    </div>
  );
}

function Port({ node, side, port, row, connected, fits, onPort }: NodeProps & { side: "in" | "out"; port: PortInfo;
  row: number }): JSX.Element {
  const key = portKey(node.id, side, port.name);
  const on = connected.has(key);
  const open = side === "in" && port.required && !on;
  const classes = ["port", side, kindClass(port.kind), on && "on", open && "open", fits
    && (fits.has(key) ? "fits" : "unfit")].filter(Boolean).join(" ");
  return (
    <span class={classes} data-port={key} style={{ top: `${portTop(row)}px` }}
      title={`${port.name}: ${port.kind}${port.required || side === "out" ? "" : ", optional"}\n${port.help}`}
      onPointerDown={(event) => onPort(event, side, port)}><span class="port-dot" />
      <span class="port-name">{port.name}</span></span>
  );
}
