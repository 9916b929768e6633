// Moves the map.
import type { Mover, Way } from "./gestures";
import { panned, zoomed, type MapEye, type Size } from "./map_camera";

export interface MapPlace {
  eye(): MapEye;
  size(): Size;
  limits(): { least: number; most: number };
  set(eye: MapEye): void;
}

export class MapMover implements Mover {
  readonly turns = false;
  constructor(private readonly at: MapPlace) {}

  begin(): void {}
  end(): void {}
  flyKeys(): void {}

  move(way: Way, right_px: number, down_px: number): void {
    if (way === "pan") this.at.set(panned(this.at.eye(), right_px, down_px));
  }

  pinch(x: number, y: number, right_px: number, down_px: number, factor: number): void {
    this.at.set(panned(this.at.eye(), right_px, down_px));
    this.zoom(x, y, factor);
  }

  zoom(x: number, y: number, factor: number): void {
    const { least, most } = this.at.limits();
    this.at.set(zoomed(this.at.eye(), this.at.size(), x, y, factor, least, most));
  }
}
