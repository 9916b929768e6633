// What steps make and is drawn over the ground may be very much: it is drawn when it, the ground or the eye is another,
// and not with every move of a pen.
import type { Projector } from "./drape";
import { drawShapes } from "./shapes_ink";
import type { OverlayShape } from "./types";

export class ContentInk {
  private canvas: OffscreenCanvas | null = null;
  private state: readonly unknown[] = [];

  /** `state`: all that the picture depends on besides the shapes. `clip`: corners of the picture that it keeps to. */
  draw(
    ink: CanvasRenderingContext2D, shapes: readonly OverlayShape[], by: Projector, state: readonly unknown[],
    clip: readonly [number, number, number, number] | null = null,
  ): void {
    if (shapes.length === 0) {
      this.canvas = null;
      this.state = [];
      return;
    }
    const { width, height } = ink.canvas, now = [shapes, width, height, ...state], transform = ink.getTransform();
    if (this.canvas === null || now.some((part, i) => part !== this.state[i])) {
      this.state = now;
      this.canvas = new OffscreenCanvas(Math.max(1, width), Math.max(1, height));
      const { willReadFrequently = false } = ink.getContextAttributes();
      const to = this.canvas.getContext("2d", { willReadFrequently })! as unknown as CanvasRenderingContext2D;
      to.setTransform(transform);
      if (clip !== null) {
        to.beginPath();
        to.rect(clip[0], clip[1], clip[2] - clip[0], clip[3] - clip[1]);
        to.clip();
      }
      drawShapes(to, shapes, by);
    }
    ink.setTransform(1, 0, 0, 1, 0, 0);
    ink.drawImage(this.canvas, 0, 0);
    ink.setTransform(transform);
  }
}
