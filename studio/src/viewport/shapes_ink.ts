// Draws the shapes of tools over a view: lines with a dark casing, areas, dots with labels, circles.
import { circle, runs, type Projector, type Run } from "./drape";
import { casing, roleColour } from "./roles";
import type { OverlayShape, Role } from "./types";

export const inkFont = "12px system-ui, sans-serif";

function trace(ink: CanvasRenderingContext2D, run: Run): void {
  ink.beginPath();
  run.points.forEach(([x, y], i) => (i === 0 ? ink.moveTo(x, y) : ink.lineTo(x, y)));
}

function strokeRuns(ink: CanvasRenderingContext2D, pieces: Run[], colour: string, width: number, dash: number[] = []): void {
  ink.lineCap = ink.lineJoin = "round";
  ink.setLineDash(dash);
  for (const over of [false, true]) {
    for (const run of pieces) {
      if (run.points.length < 2) continue;
      ink.globalAlpha = run.hidden ? 0.22 : 1;
      ink.strokeStyle = over ? colour : casing;
      ink.lineWidth = over ? width : width + 2;
      trace(ink, run);
      ink.stroke();
    }
  }
  ink.setLineDash([]);
  ink.globalAlpha = 1;
}

function line(ink: CanvasRenderingContext2D, shape: Extract<OverlayShape, { shape: "line" }>, by: Projector): void {
  const pieces = runs(shape.points, shape.closed === true, by);
  const width = shape.width_px ?? (shape.role === "guide" ? 1.25 : 2);
  if (shape.width_m !== undefined && shape.points.length > 0) {
    const [x, y] = shape.points[Math.floor(shape.points.length / 2)]!;
    ink.globalAlpha = 0.32;
    ink.strokeStyle = roleColour(shape.role);
    ink.lineWidth = Math.max(width, shape.width_m / by.pixelSize(x, y));
    ink.lineCap = ink.lineJoin = "round";
    for (const run of pieces) {
      trace(ink, run);
      ink.stroke();
    }
    ink.globalAlpha = 1;
  }
  strokeRuns(ink, pieces, shape.colour ?? roleColour(shape.role), width, shape.role === "guide" ? [5, 4] : []);
}

/** In the 3D view so many points at most are looked at: of a finer network nothing could be told apart there. */
const mostPoints = 24000;
/** Long paths take much longer than the same in pieces. */
const pieceLength = 400;

/** The pieces of many lines that are alike; those behind the ground are left out. */
function piecesOf(shape: Extract<OverlayShape, { shape: "lines" }>, by: Projector, every: number): Path2D[] {
  const pieces: Path2D[] = [];
  let path = new Path2D(), length = 0;
  for (const part of shape.lines) {
    let on = false;
    for (let i = 0; i < part.length; i += i + every < part.length ? every : Math.max(1, part.length - 1 - i)) {
      const [x, y] = part[i]!, at = by.project(x, y);
      const seen = at !== null && !by.hidden(x, y);
      if (seen && on) path.lineTo(at[0], at[1]);
      else if (seen) path.moveTo(at[0], at[1]);
      on = seen;
      ++length;
    }
    if (length < pieceLength) continue;
    pieces.push(path);
    [path, length] = [new Path2D(), 0];
  }
  return [...pieces, path];
}

function lines(ink: CanvasRenderingContext2D, shape: Extract<OverlayShape, { shape: "lines" }>, by: Projector): void {
  const points = shape.lines.reduce((sum, part) => sum + part.length, 0);
  const every = by.flat ? 1 : Math.max(1, Math.ceil(points / mostPoints));
  if (every > 1 && points < 3 * shape.lines.length) return;  // single edges, of which none can be left out
  const pieces = piecesOf(shape, by, every), thin = shape.width_px < 1;
  ink.lineCap = "butt";
  ink.lineJoin = "bevel";
  ink.globalAlpha = thin ? 0.55 : 1;
  for (const over of thin || !by.flat ? [true] : [false, true]) {
    ink.strokeStyle = over ? roleColour(shape.role) : casing;
    ink.lineWidth = over ? shape.width_px : shape.width_px + 1.5;
    for (const path of pieces) ink.stroke(path);
  }
  ink.globalAlpha = 1;
}

/** The 3D view looks for the ground before each mark: of very many it shows an even choice. */
const mostRaised = 600;

/** Small marks, many at once: one path for all of them. */
function dots(ink: CanvasRenderingContext2D, shape: Extract<OverlayShape, { shape: "dots" }>, by: Projector): void {
  const { places } = shape, every = by.flat ? 1 : Math.max(1, Math.ceil(places.length / mostRaised));
  const across = !by.flat || places.length > 3000 ? 2.5 : places.length > 400 ? 3.5 : 5;
  const marks = new Path2D(), edges = new Path2D();
  for (let i = 0; i < places.length; i += every) {
    const [x, y] = places[i]!, at = by.project(x, y);
    if (at === null || by.hidden(x, y)) continue;
    edges.rect(at[0] - across / 2 - 1, at[1] - across / 2 - 1, across + 2, across + 2);
    marks.rect(at[0] - across / 2, at[1] - across / 2, across, across);
  }
  ink.fillStyle = casing;
  ink.fill(edges);
  ink.fillStyle = shape.colour;
  ink.fill(marks);
}

function area(ink: CanvasRenderingContext2D, shape: Extract<OverlayShape, { shape: "area" }>, by: Projector): void {
  const pieces = runs(shape.points, true, by);
  const colour = shape.colour ?? roleColour(shape.role);
  ink.beginPath();
  pieces.flatMap((run) => run.points).forEach(([x, y], i) => (i === 0 ? ink.moveTo(x, y) : ink.lineTo(x, y)));
  ink.closePath();
  ink.fillStyle = colour;
  ink.globalAlpha = 0.24;
  ink.fill();
  ink.globalAlpha = 1;
  strokeRuns(ink, pieces, colour, 1.5);
}

export function text(ink: CanvasRenderingContext2D, words: string, x: number, y: number, colour = "#ffffff", halo = casing): void {
  ink.font = inkFont;
  ink.lineJoin = "round";
  ink.lineWidth = 3;
  ink.strokeStyle = halo;
  ink.strokeText(words, x, y);
  ink.fillStyle = colour;
  ink.fillText(words, x, y);
}

function dot(ink: CanvasRenderingContext2D, shape: Extract<OverlayShape, { shape: "dot" }>, by: Projector): void {
  const at = by.project(shape.at[0], shape.at[1]);
  if (at === null) return;
  ink.globalAlpha = by.hidden(shape.at[0], shape.at[1]) ? 0.35 : 1;
  const [x, y] = at, colour = roleColour(shape.role);
  ink.beginPath();
  ink.arc(x, y, shape.handle === true ? 5 : 4, 0, 2 * Math.PI);
  ink.fillStyle = colour;
  ink.fill();
  ink.lineWidth = 1.75;
  ink.strokeStyle = shape.handle === true && shape.role === "handle" ? "#0b6e8f" : casing;
  ink.stroke();
  if (shape.label !== undefined) {
    ink.textAlign = "left";
    ink.textBaseline = "middle";
    text(ink, shape.label, x + 9, y);
  }
  ink.globalAlpha = 1;
}

function ring(ink: CanvasRenderingContext2D, x: number, y: number, radius: number, role: Role, by: Projector, dash: number[]): void {
  strokeRuns(ink, runs(circle(x, y, radius), true, by), roleColour(role), 1.5, dash);
}

export function drawShapes(ink: CanvasRenderingContext2D, shapes: readonly OverlayShape[], by: Projector): void {
  for (const shape of shapes) {
    if (shape.only === "map" && !by.flat) continue;
    if (shape.shape === "line") line(ink, shape, by);
    else if (shape.shape === "area") area(ink, shape, by);
    else if (shape.shape === "dot") dot(ink, shape, by);
    else if (shape.shape === "lines") lines(ink, shape, by);
    else if (shape.shape === "dots") dots(ink, shape, by);
    else {
      ring(ink, shape.at[0], shape.at[1], shape.radius_m, shape.role, by, []);
      if (shape.inner_m !== undefined && shape.inner_m > 0) ring(ink, shape.at[0], shape.at[1], shape.inner_m, shape.role, by, [3, 3]);
    }
  }
}
