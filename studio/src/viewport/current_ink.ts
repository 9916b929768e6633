// Currents on the map: arrows at equal distances in the picture, as long as the water is fast.
import type { MapEye, Size } from "./map_camera";
import { toGround } from "./map_camera";
import { casing } from "./roles";
import type { Raster } from "./types";

const gap_px = 30;

export function drawCurrent(ink: CanvasRenderingContext2D, raster: Raster, eye: MapEye, size: Size): void {
  const { frame, values } = raster;
  let fastest = 1e-9;
  for (let i = 0; i + 1 < values.length; i += 2) {
    const speed = Math.hypot(values[i]!, values[i + 1]!);
    if (speed > fastest) fastest = speed;
  }
  const arrows = new Path2D();
  for (let py = gap_px / 2; py < size.height; py += gap_px) {
    for (let px = gap_px / 2; px < size.width; px += gap_px) {
      const [x, y] = toGround(eye, size, px, py);
      const column = Math.floor((x - frame.west) / frame.cell_m), row = Math.floor((frame.north - y) / frame.cell_m);
      if (column < 0 || row < 0 || column >= frame.columns || row >= frame.rows) continue;
      const i = 2 * (row * frame.columns + column), east = values[i]!, north = values[i + 1]!;
      const speed = Math.hypot(east, north);
      if (!(speed > 0.02 * fastest)) continue;
      const long = 5 + 0.62 * gap_px * Math.sqrt(speed / fastest), dx = (east / speed) * long;
      const dy = (-north / speed) * long;
      const tx = px + dx / 2, ty = py + dy / 2;
      arrows.moveTo(px - dx / 2, py - dy / 2);
      arrows.lineTo(tx, ty);
      arrows.moveTo(tx - 0.34 * dx - 0.2 * dy, ty - 0.34 * dy + 0.2 * dx);
      arrows.lineTo(tx, ty);
      arrows.lineTo(tx - 0.34 * dx + 0.2 * dy, ty - 0.34 * dy - 0.2 * dx);
    }
  }
  ink.lineCap = ink.lineJoin = "round";
  for (const [colour, width] of [[casing, 3.2], ["#ffffff", 1.4]] as const) {
    ink.strokeStyle = colour;
    ink.lineWidth = width;
    ink.stroke(arrows);
  }
}
