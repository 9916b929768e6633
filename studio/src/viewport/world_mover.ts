// Moves the eye of the 3D view: around, along and towards what is under the cursor, or flying.
import type { Mover, Way } from "./gestures";
import {
  add, approach, axes, between, direction, dot, fly, look, orbit, pan, type Eye, type Lens, type Vector,
} from "./world_camera";

export interface WorldPlace {
  eye(): Eye;
  lens(): Lens;
  /** Ground under a pixel, with exaggerated height; null: beside it. */
  ground(x: number, y: number): Vector | null;
  /** A distance to go by where there is nothing under the cursor. */
  reach(): number;
  /** How near one may come. */
  nearest(): number;
  set(eye: Eye): void;
}

const turnPerPixel = 0.0075;

export class WorldMover implements Mover {
  readonly turns = true;
  private pivot: Vector = [0, 0, 0];
  private depth = 1;
  private keys: ReadonlySet<string> = new Set();
  private flying = 0;
  private lastTime = 0;

  constructor(private readonly at: WorldPlace) {}

  begin(way: Way, x: number, y: number): void {
    this.aim(x, y);
    if (way === "fly") this.flyKeys(this.keys);
  }

  end(): void {
    this.keys = new Set();
    cancelAnimationFrame(this.flying);
    this.flying = 0;
  }

  move(way: Way, right_px: number, down_px: number): void {
    const eye = this.at.eye();
    if (way === "orbit") this.at.set(orbit(eye, this.pivot, right_px * turnPerPixel, -down_px * turnPerPixel));
    else if (way === "fly") this.at.set(look(eye, right_px * 0.004, -down_px * 0.004));
    else if (way === "pan") this.at.set(pan(eye, this.at.lens(), this.depth, right_px, down_px));
    else this.at.set(approach(eye, this.pivot, Math.exp(down_px * 0.008), this.at.nearest()));
  }

  pinch(x: number, y: number, right_px: number, down_px: number, factor: number, turn_rad: number): void {
    this.aim(x, y);
    let eye = orbit(this.at.eye(), this.pivot, -turn_rad, 0);
    eye = pan(eye, this.at.lens(), this.depth, right_px, down_px);
    this.at.set(approach(eye, this.pivot, factor, this.at.nearest()));
  }

  zoom(x: number, y: number, factor: number): void {
    this.aim(x, y);
    this.at.set(approach(this.at.eye(), this.pivot, factor, this.at.nearest()));
  }

  flyKeys(pressed: ReadonlySet<string>): void {
    this.keys = new Set(pressed);
    if (this.flying !== 0 || this.keys.size === 0) return;
    this.lastTime = performance.now();
    const step = (now: number): void => {
      const seconds = Math.min(0.1, (now - this.lastTime) / 1000);
      this.lastTime = now;
      const has = (a: string, b: string): number => (this.keys.has(a) ? 1 : 0) - (this.keys.has(b) ? 1 : 0);
      const fast = this.keys.has("ShiftLeft") || this.keys.has("ShiftRight") ? 4 : 1;
      const way = fast * seconds * 0.5 * this.at.reach();
      this.at.set(fly(this.at.eye(), way * has("KeyW", "KeyS"), way * has("KeyD", "KeyA"), way * has("KeyE", "KeyQ")));
      this.flying = this.keys.size > 0 ? requestAnimationFrame(step) : 0;
    };
    this.flying = requestAnimationFrame(step);
  }

  private aim(x: number, y: number): void {
    const eye = this.at.eye(), ray = direction(eye, this.at.lens(), x, y);
    this.pivot = this.at.ground(x, y) ?? add(eye.at, ray, this.at.reach());
    this.depth = Math.max(this.at.nearest(), dot(between(eye.at, this.pivot), axes(eye).forward));
  }
}
