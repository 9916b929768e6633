// Pictures of the tools: Lucide's where there is one, our own for what only terrains have. 24 by 24, strokes of 1.75.
import {
  Brush, ChartArea, CirclePlus, ClipboardPaste, Copy, Ellipsis, Eraser, FlagTriangleRight,
  Lasso, LocateFixed, Lock, MapPin, MousePointer2, Move, PaintBucket, Ruler, Scissors, Spline, Tornado, Trash2, Wind,
} from "lucide-preact";
import type { LucideIcon } from "lucide-preact";
import type { JSX } from "preact";

const kLucide: { [name: string]: LucideIcon } = {
  select: MousePointer2, eraser: Eraser, measure: Ruler, profile: ChartArea,
  wind: Wind, trash: Trash2, copy: Copy, cut: Scissors, paste: ClipboardPaste,
  fill: PaintBucket, lasso: Lasso, place: MapPin, centre: LocateFixed, move: Move,
  lock: Lock, add: CirclePlus, storm: Tornado, brush: Brush, line: Spline,
  more: Ellipsis, height: FlagTriangleRight,
};

/** Paths of our own pictures. */
const kOwn: { [name: string]: string[] } = {
  // Sculpting: the ground, and what happens to it.
  raise: ["M2 19h4c3 0 3.5-8 6-8s3 8 6 8h4", "M12 8V2.5", "m9.5 5 2.5-2.5L14.5 5"],
  lower: ["M2 9h4c3 0 3.5 9 6 9s3-9 6-9h4", "M12 2.5V11", "m9.5 8.5 2.5 2.5 2.5-2.5"],
  smooth: ["M2 15c3 0 4-6 7-6s3.5 6 6.5 6 3.5-3 6.5-3", "M2 20h20"],
  flatten: ["M2 13h20", "M5 18h14", "M12 3v6", "m9.5 6.5 2.5 2.5 2.5-2.5"],
  ramp: ["M2 19h4l12-11h4", "M6 19h16"],
  roughen: ["m2 17 3-5 2.5 3 3-8 3 6 2.5-4 2.5 5L22 11", "M2 21h20"],
  // Plans.
  coast: [
    "M3 12C1.8 6 7.5 2 12 2.6c3.6.5 4 3 6.5 4.2 3.5 1.7 4 5 2.3 8.7"
      + "-1.7 3.5-3.5 2.3-5.8 4.7-2 2-6 2.3-9 .3C3.8 18 3.5 15 3 12Z",
  ],
  polar: [
    "M3 12.5C2.5 7 6.5 3 12 3s9.5 3.5 9 9-3.5 9-9 9-8.5-3.5-9-8.5Z",
    "M12 12.5 17 7",
    "M13.5 7H17v3.5",
    "M12 12.5h.01",
  ],
  region: [
    "M3.5 12c-.5-5 4-8.5 9-8s8.5 4 8 9-5 8-9.5 7.5-7-4-7.5-8.5Z",
    "M8.5 12c0-2 1.5-3.5 4-3.5s3.5 2 3 4-2 3.5-4 3-3-1.5-3-3.5Z",
  ],
  summit: ["m2.5 19 6-9.5 3 4.5 3.5-7.5L21.5 19Z", "M15 6.5V2l3.5 1.5L15 5"],
  ridge: ["m2 19 5-8 3 4 5-9 7 13", "M15 6v4l-2 3 2 3"],
  river: ["M6 3c0 3.5 4.5 4 4.5 7.5S6 14.5 6 18v3", "M13 3c0 3.5 5 4.5 5 8s-4.5 4-4.5 7.5V21"],
  current: ["M2 8c3-3 5-3 8 0s5 3 8 0", "M2 16c3-3 5-3 8 0s5 3 8 0", "m19.5 13.5 2.5 2.5-2.5 2.5"],
  // Contours.
  warp: ["M3 17c4 0 5-9 9-9s5 9 9 9", "M3 21c5 0 6-5 9-5s4 5 9 5", "M12 5V2", "m10 4 2-2 2 2"],
  slope: ["M3 5c6 0 12 1 18 4", "M3 10c6 0 12 .5 18 2", "M3 15c6 0 12 0 18 0", "M3 20c6 0 12-1 18-2"],
  bend: ["M4 20C4 10 8 5 20 5", "M12 12l6 6", "M18 13.5V18h-4.5"],
  fault: ["M2 9h8v0l3 6h9", "M2 14h6.5", "M15.5 20H22", "m9 3 6 18"],
  rise: ["M3 20h18", "M12 16V5", "m8 9 4-4 4 4", "M5 16h2M17 16h2"],
  kernel: [
    "M12 21v-7",
    "M12 14c-3 0-5-2-5-5",
    "M12 14c3 0 5-2 5-5",
    "M7 9c-2 0-3-1-3-3M7 9c0-2 1-3 2-4",
    "M17 9c2 0 3-1 3-3M17 9c0-2-1-3-2-4",
    "M12 14V8",
  ],
};

export function ToolIcon({ name, size = 20 }: { name: string; size?: number }): JSX.Element {
  const paths = kOwn[name];
  if (paths) {
    return (
      <svg
        class="lucide"
        width={size}
        height={size}
        viewBox="0 0 24 24"
        fill="none"
        stroke="currentColor"
        stroke-width="1.75"
        stroke-linecap="round"
        stroke-linejoin="round"
        aria-hidden="true"
      >
        {paths.map((d) => (
          <path key={d} d={d} />
        ))}
      </svg>
    );
  }
  const Known = kLucide[name] ?? Spline;
  return <Known size={size} aria-hidden />;
}
