// Measures: how long a line is and how much the ground rises along it; or the ground along it from the side.
import type { GroundPointer, OverlayShape } from "../../viewport/types";
import { pointOf, type Desk, type Pen, type PenKey } from "../desk";
import { fitLine, type Sample } from "../fit";
import { distance, lengthOf, type Point } from "../geometry";
import { formatLength, kClick_px } from "./line_pen";

export class MeasurePen implements Pen {
  readonly cursor = "crosshair" as const;
  private corners: Point[] = [];
  private heights: (number | null)[] = [];
  private samples: Sample[] = [];
  private start: GroundPointer | null = null;
  private free = false;
  private done = false;

  constructor(private readonly desk: Desk, private readonly side: boolean) {}

  down(at: GroundPointer): void {
    if (this.done) this.clear();
    this.start = at;
    this.free = false;
    this.samples = [{ x: at.x, y: at.y, pressure: 1 }];
    if (this.corners.length === 0) this.add(at);
  }

  private add(at: GroundPointer): void {
    this.corners.push(pointOf(at));
    this.heights.push(at.height);
  }

  move(path: GroundPointer[]): void {
    const at = path[path.length - 1];
    if (!at || !this.start) return;
    for (const { x, y } of path) this.samples.push({ x, y, pressure: 1 });
    this.free ||= distance(pointOf(at), pointOf(this.start)) > kClick_px * at.pixel_m;
    if (this.free) this.show(this.whole(at), at.height);
  }

  /** A profile follows the hand; a distance is straight from press to release. */
  private whole(at: GroundPointer): Point[] {
    if (!this.free) return this.corners;
    if (!this.side) return [...this.corners, pointOf(at)];
    return [...this.corners, ...fitLine(this.samples, this.desk.fitting(at)).slice(this.corners.length === 1 ? 1 : 0)];
  }

  up(at: GroundPointer): void {
    if (!this.start) return;
    this.start = null;
    if (this.free) {
      this.corners = this.whole(at);
      this.heights.push(at.height);
      return this.end();
    }
    const last = this.corners[this.corners.length - 1]!;
    if (distance(last, pointOf(at)) > kClick_px * at.pixel_m) this.add(at);
    this.show(this.corners, at.height);
  }

  private end(): void {
    this.done = true;
    this.show(this.corners, this.heights[this.heights.length - 1] ?? null);
    if (this.side) this.desk.profile(this.corners.length > 1 ? this.corners : null);
  }

  private show(points: readonly Point[], height: number | null): void {
    const shapes: OverlayShape[] = points.length > 1 ? [{ shape: "line", points, role: "selected", width_px: 2 }] : [];
    const last = points[points.length - 1];
    const length = formatLength(lengthOf(points));
    if (points[0]) shapes.push({ shape: "dot", at: points[0], role: "selected" });
    if (last && points.length > 1) shapes.push({ shape: "dot", at: last, role: "selected", label: length });
    this.desk.draw(shapes);
    const first = this.heights[0];
    const rise = typeof first === "number" && height !== null ? Math.round(height - first) : null;
    const along = lengthOf(points);
    const slope = rise === null || along < 1 ? ""
      : `, ${rise >= 0 ? "+" : "−"}${Math.abs(rise)} m, ${Math.round(Math.abs((100 * rise) / along))} %`;
    this.desk.say(points.length > 1 ? `${length}${slope}` : "");
    if (this.side && points.length > 1) this.desk.profile(points);
  }

  private clear(): void {
    this.corners = [];
    this.heights = [];
    this.samples = [];
    this.start = null;
    this.done = false;
    this.desk.draw([]);
    this.desk.say("");
  }

  hover(at: GroundPointer | null): void {
    if (
      at && !this.done && !this.start && this.corners.length > 0
    ) this.show([...this.corners, pointOf(at)], at.height);
  }

  double(): void {
    this.end();
  }

  cancel(): void {
    this.clear();
  }

  leave(): void {
    this.clear();
    if (this.side) this.desk.profile(null);
  }

  key({ key }: PenKey): boolean {
    if (this.corners.length === 0) return false;
    if (key === "Escape") {
      this.clear();
      if (this.side) this.desk.profile(null);
    } else if (key === "Enter") this.end();
    else return false;
    return true;
  }
}
