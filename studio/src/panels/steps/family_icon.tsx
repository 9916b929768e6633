// An icon for each family of operators; where no general one says it, our own on the same 24 x 24 grid.
import type { ComponentChildren, JSX } from "preact";
import { BrainCircuit, Camera, Droplets, MountainSnow, PencilLine, ScanSearch, Shapes, Spline, Sprout, Tags,
  TreePalm } from "lucide-preact";

function Own({ children }: { children: ComponentChildren }): JSX.Element {
  return <svg class="lucide" viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="1.75"
    stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">{children}</svg>;
}

const Terrain = () => <Own><path d="M2 19 8.5 7l4 7 2.5-4L22 19Z" /><path d="m6.4 11 2.1 1.6 2-1.8" /></Own>;
const Contour = () => <Own><path d="M12 3c5.5 0 9 3.4 9 8.4S17 21 11.5 21 3 17 3 12s3.500-9 9-9Z" />
  <path d="M12.500 7c3 0 4.800 1.900 4.800 4.600s-2.200 5.200-5.300 5.200-5-2.300-5-5S9.500 7 12.500 7Z" />
  <path d="M12.500 10.600c1 0 1.500.600 1.500 1.400s-.700 1.500-1.600 1.500" /></Own>;
const Reef = () => <Own><path d="M12 21v-7" /><path d="M12 14c0-3-4-3-4-7V4" /><path d="M12 14c0-3 4-3 4-7V5" />
  <path d="M8 9H5V6" /><path d="M16 9.500h3V7" /><path d="M4 21h16" /></Own>;
const Erosion = () => <Own><path d="M3 6c4 0 4 3 7 3s4-3 11-3" /><path d="M3 21c5 0 6-4 9-7 2-2 5-2 9-2" />
  <path d="M10 9c0 3 2 3 2 5" /><path d="M7 21c3-1 4-3 6-4.500" /></Own>;

const ICONS: { readonly [family: string]: () => JSX.Element } = {
  terrain: Terrain, island: () => <TreePalm />, contour: Contour, drawing: () => <Spline />, reef: Reef,
    hydrology: () => <Droplets />,
  erosion: Erosion, glacier: () => <MountainSnow />, sketch: () => <PencilLine />, learned: () => <BrainCircuit />,
    ecosystem: () => <Sprout />,
  amplify: () => <ScanSearch />, classify: () => <Tags />, render: () => <Camera />,
};

export function familyOf(op: string): string {
  return op.slice(0, Math.max(0, op.indexOf(".")));
}

export function FamilyIcon({ op }: { op: string }): JSX.Element {
  const Icon = ICONS[familyOf(op)] ?? (() => <Shapes />);
  return <span class="family-icon" aria-hidden="true"><Icon /></span>;
}
