// The eraser of the drawing: sweeps over lines and places of the selected step.
import type { GroundPointer } from "../../viewport/types";
import { pointOf, type Desk, type Pen, type PenKey } from "../desk";
import { eraseEdits } from "../erase";
import { tolerance } from "../fit";
import { roundingStep, simplified, type Point } from "../geometry";

export class EraserPen implements Pen {
  readonly cursor = "none" as const;
  private way: Point[] = [];
  private down_ = false;

  constructor(private readonly desk: Desk) {}

  down(at: GroundPointer): void {
    this.down_ = true;
    this.way = [pointOf(at)];
    this.show(at);
  }

  move(path: GroundPointer[]): void {
    if (!this.down_) return;
    const reach = this.desk.reach();
    for (const at of path) {
      const last = this.way[this.way.length - 1]!;
      const far = Math.hypot(at.x - last[0], at.y - last[1]);
      for (let i = 1; i * reach * 0.3 < far; ++i) {  // no gaps in a quick stroke
        const share = (i * reach * 0.3) / far;
        this.way.push([last[0] + (at.x - last[0]) * share, last[1] + (at.y - last[1]) * share]);
      }
      this.way.push(pointOf(at));
    }
    if (path.length > 0) this.show(path[path.length - 1]!);
  }

  up(at: GroundPointer): void {
    if (!this.down_) return;
    this.down_ = false;
    const step = roundingStep(tolerance(this.desk.fitting(at)));
    const edits = eraseEdits(this.desk.features(), this.way, this.desk.reach(), step);
    this.way = [];
    this.show(at);
    if (edits.length === 0) return;
    this.desk.select([]);
    void this.desk.begin("erased").finish(() => edits);
    this.desk.end();
  }

  cancel(): void {
    this.down_ = false;
    this.way = [];
    this.desk.draw([]);
  }

  leave(): void {
    this.cancel();
  }

  key({ key }: PenKey): boolean {
    if (key !== "Escape" || !this.down_) return false;
    this.cancel();
    return true;
  }

  hover(at: GroundPointer | null): void {
    if (this.down_) return;
    if (at) this.show(at);
    else this.desk.draw([]);
  }

  private show(at: GroundPointer): void {
    const reach = this.desk.reach();
    const circle = { shape: "circle" as const, at: pointOf(at), radius_m: reach, role: "erase" as const };
    const swept = simplified(this.way, reach / 8);
    const ink = swept.length > 1 ? [
      { shape: "line" as const, points: swept, role: "erase" as const, width_m: 2 * reach },
    ]
      : [];
    this.desk.draw([...ink, circle]);
  }
}
