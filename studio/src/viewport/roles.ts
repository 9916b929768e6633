// Colours of what is drawn over the ground. They stand over pictures, not over panels, so they are the same in both
// themes; a dark casing keeps them readable on any ground.
import { labelColours, labelNames } from "./tints";
import type { Role } from "./types";

const colours: { [role in Exclude<Role, (typeof labelNames)[number]>]: string } = {
  ink: "#ffffff",
  guide: "#e4edf3",
  selected: "#5fd0f5",
  handle: "#ffffff",
  ridge: "#ff8a4c",
  river: "#5aa9ff",
  wind: "#d9d2ff",
  height: "#ffd54a",
  erase: "#ff7b72",
  coast: "#fff0b8",
  contour: "#f0b070",
};

export const casing = "rgba(8, 16, 22, 0.62)";

export function roleColour(role: Role): string {
  const label = (labelNames as readonly string[]).indexOf(role);
  if (label >= 0) return `rgb(${labelColours[label]!.join(" ")})`;
  return colours[role as keyof typeof colours];
}
