// Which part of the graph is seen: panned by dragging, zoomed at the pointer, fitted into its box.

export interface PanZoom {
  x: number;
  y: number;
  scale: number;
}

export const MIN_SCALE = 0.25;
export const MAX_SCALE = 2;

export function zoomedAt(view: PanZoom, px: number, py: number, factor: number): PanZoom {
  const scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, view.scale * factor));
  const by = scale / view.scale;
  return { scale, x: px - (px - view.x) * by, y: py - (py - view.y) * by };
}

/** All of it in the middle, no larger than life. */
export function fitted(content: { width: number; height: number }, box: { width: number; height: number },
  margin = 20): PanZoom {
  const scale = Math.max(MIN_SCALE, Math.min(1, (box.width - 2 * margin) / Math.max(1, content.width),
    (box.height - 2 * margin) / Math.max(1, content.height)));
  return { scale, x: Math.max(margin, (box.width - content.width * scale) / 2),
    y: Math.max(margin, (box.height - content.height * scale) / 2) };
}

export function toGraph(view: PanZoom, px: number, py: number): readonly [number, number] {
  return [(px - view.x) / view.scale, (py - view.y) / view.scale];
}
