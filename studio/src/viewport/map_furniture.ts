// What stands around a map: the scale bar, marks of kilometres at the edge, lines of the grid, a north arrow.
import { toGround, toScreen, type MapEye, type Size } from "./map_camera";
import { text } from "./shapes_ink";
import { gridStep, lengthText, multiples, scaleBarLength } from "./ticks";

/** Marks are read on the map and on the page around it, which is dark or light. */
interface Palette {
  text: string;
  halo: string;
  line: string;
  half: string;
}
const dark: Palette = { text: "rgba(255, 255, 255, 0.92)", halo: "rgba(8, 16, 22, 0.55)", line: "rgba(255, 255, 255, 0.16)", half: "rgba(255, 255, 255, 0.35)" };
const light: Palette = { text: "#1b2228", halo: "rgba(255, 255, 255, 0.78)", line: "rgba(10, 20, 30, 0.16)", half: "rgba(27, 34, 40, 0.35)" };

export interface FurnitureOptions {
  grid: boolean;
  /** The page is light. */
  light: boolean;
}

/** Small views have only a scale bar. */
export function drawFurniture(ink: CanvasRenderingContext2D, eye: MapEye, size: Size, options: FurnitureOptions): void {
  const palette = options.light ? light : dark;
  if (size.width > 420 && size.height > 280) edgeMarks(ink, eye, size, options, palette);
  scaleBar(ink, eye, size, palette);
  if (size.width > 420) northArrow(ink, size, palette);
}

/** Places as the document has them, the same that the status line says. */
function edgeMarks(ink: CanvasRenderingContext2D, eye: MapEye, size: Size, options: FurnitureOptions, palette: Palette): void {
  const step = gridStep(eye.pixel_m);
  const [west, north] = toGround(eye, size, 0, 0), [east, south] = toGround(eye, size, size.width, size.height);
  ink.lineWidth = 1;
  const marks = (vertical: boolean, at: number): void => {
    const p = vertical ? toScreen(eye, size, at, 0)[0] : toScreen(eye, size, 0, at)[1];
    const q = Math.round(p) + 0.5;
    const segment = (from: number, to: number, colour: string): void => {
      ink.strokeStyle = colour;
      ink.beginPath();
      ink.moveTo(vertical ? q : from, vertical ? from : q);
      ink.lineTo(vertical ? q : to, vertical ? to : q);
      ink.stroke();
    };
    if (options.grid) segment(0, vertical ? size.height : size.width, palette.line);
    segment(0, 6, palette.text);
    ink.textBaseline = vertical ? "top" : "middle";
    ink.textAlign = vertical ? "center" : "left";
    text(ink, at === 0 ? "0" : lengthText(at), vertical ? q : 9, vertical ? 8 : q, palette.text, palette.halo);
  };
  for (const x of multiples(west, east, step)) if ((x - west) / eye.pixel_m > 60 && (east - x) / eye.pixel_m > 48) marks(true, x);
  for (const y of multiples(south, north, step)) if ((north - y) / eye.pixel_m > 34 && (y - south) / eye.pixel_m > 44) marks(false, y);
}

function scaleBar(ink: CanvasRenderingContext2D, eye: MapEye, size: Size, palette: Palette): void {
  const length_m = scaleBarLength(eye.pixel_m, Math.min(150, 0.4 * size.width)), across = length_m / eye.pixel_m;
  const x = 14, y = size.height - 16;
  ink.fillStyle = palette.halo;
  ink.fillRect(x - 1.5, y - 1.5, across + 3, 7);
  for (let half = 0; half < 2; ++half) {
    ink.fillStyle = half === 0 ? palette.text : palette.half;
    ink.fillRect(x + (half * across) / 2, y, across / 2, 4);
  }
  ink.textAlign = "left";
  ink.textBaseline = "bottom";
  text(ink, lengthText(length_m), x, y - 4, palette.text, palette.halo);
}

function northArrow(ink: CanvasRenderingContext2D, size: Size, palette: Palette): void {
  const x = size.width - 24, y = 18;
  const side = (right: number, colour: string): void => {
    ink.beginPath();
    ink.moveTo(x, y);
    ink.lineTo(x + 6 * right, y + 18);
    ink.lineTo(x, y + 13.5);
    ink.closePath();
    ink.fillStyle = colour;
    ink.fill();
  };
  ink.lineWidth = 3;
  ink.strokeStyle = palette.halo;
  ink.lineJoin = "round";
  ink.beginPath();
  ink.moveTo(x, y);
  ink.lineTo(x + 6, y + 18);
  ink.lineTo(x, y + 13.5);
  ink.lineTo(x - 6, y + 18);
  ink.closePath();
  ink.stroke();
  side(-1, palette.text);
  side(1, palette === light ? "#8a97a3" : "#aab8c2");
  ink.textAlign = "center";
  ink.textBaseline = "top";
  text(ink, "N", x, y + 21, palette.text, palette.halo);
}
