// From events of pointers over a view to places on the ground.
import type { GroundPointer } from "./types";

/** What a view knows of the ground under a pixel. */
export interface Under {
  x: number;
  y: number;
  height: number | null;
  pixel_m: number;
}

export function groundPointer(
  event: MouseEvent & { pointerType?: string; pressure?: number }, under: Under,
): GroundPointer {
  const device = event.pointerType === "pen" ? "pen" : event.pointerType === "touch" ? "touch" : "mouse";
  // The other end of a pen does what Ctrl does: it takes away.
  const eraser = device === "pen" && ((event.buttons & 32) !== 0 || event.button === 5);
  return {
    ...under,
    pressure: device === "pen" ? (event.pressure ?? 1) : 1,
    device,
    shift: event.shiftKey,
    ctrl: event.ctrlKey || event.metaKey || eraser,
    alt: event.altKey,
  };
}
