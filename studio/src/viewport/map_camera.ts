// The part of the ground that the map shows: north is up. Pure: every move gives a new one.

export interface MapEye {
  /** Place in the middle of the picture. */
  readonly x: number;
  readonly y: number;
  /** Metres a pixel. */
  readonly pixel_m: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

export function toScreen(eye: MapEye, size: Size, x: number, y: number): [number, number] {
  return [size.width / 2 + (x - eye.x) / eye.pixel_m, size.height / 2 - (y - eye.y) / eye.pixel_m];
}

export function toGround(eye: MapEye, size: Size, px: number, py: number): [number, number] {
  return [eye.x + (px - size.width / 2) * eye.pixel_m, eye.y - (py - size.height / 2) * eye.pixel_m];
}

export function panned(eye: MapEye, right_px: number, down_px: number): MapEye {
  return { ...eye, x: eye.x - right_px * eye.pixel_m, y: eye.y + down_px * eye.pixel_m };
}

/** Zooms so that the place under a pixel stays there. */
export function zoomed(
  eye: MapEye, size: Size, px: number, py: number, factor: number, least: number, most: number,
): MapEye {
  const pixel_m = Math.min(most, Math.max(least, eye.pixel_m * factor));
  const [x, y] = toGround(eye, size, px, py);
  return { x: x - (px - size.width / 2) * pixel_m, y: y + (py - size.height / 2) * pixel_m, pixel_m };
}

export interface Rectangle {
  readonly west: number;
  readonly east: number;
  readonly south: number;
  readonly north: number;
}

/** What is seen. */
export function visible(eye: MapEye, size: Size): Rectangle {
  const across = 0.5 * size.width * eye.pixel_m, down = 0.5 * size.height * eye.pixel_m;
  return { west: eye.x - across, east: eye.x + across, south: eye.y - down, north: eye.y + down };
}

/** Shows a rectangle with a margin around it. */
export function fitted(r: Rectangle, size: Size, margin_px = 24): MapEye {
  const across = Math.max(40, size.width - 2 * margin_px), down = Math.max(40, size.height - 2 * margin_px);
  const pixel_m = Math.max((r.east - r.west) / across, (r.north - r.south) / down, 1e-6);
  return { x: 0.5 * (r.west + r.east), y: 0.5 * (r.south + r.north), pixel_m };
}
