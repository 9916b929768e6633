// What can be done with the views, as actions: for shortcuts, the palette and the sheet.
import { Box, Grid3x3, Home, Mountain, Scan, Thermometer, Waves } from "lucide-preact";
import type { Action } from "../actions/registry";
import { climateNames } from "./climate";
import type { GroundStyle, ViewOptions } from "./options";
import type { Viewport } from "./viewport";

export const styleNames: readonly (readonly [GroundStyle, string])[] = [
  ["texture", "Natural"], ["relief", "Stone"], ["slope", "Slope"], ["contours", "Contours"],
];

export function viewActions(viewport: Viewport): Action[] {
  const group = "View", { options } = viewport;
  const change = (part: Partial<ViewOptions>): void => {
    options.value = { ...options.peek(), ...part };
  };
  const steps = [0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8];
  const next = (way: 1 | -1): number => {
    const now = options.peek().exaggeration, sorted = way > 0 ? steps : [...steps].reverse();
    return sorted.find((step) => (step - now) * way > 1e-6) ?? now;
  };
  type Switch = "water" | "wireframe" | "grid";
  const toggle = (name: Switch, title: string, words: string, icon: Action["icon"]): Action => ({
    id: `view.${name}`, title, group, words, ...(icon ? { icon } : {}),
    checked: () => options.value[name], run: () => change({ [name]: !options.peek()[name] }),
  });
  return [
    {
      id: "view.frame_all", title: "Show the whole terrain", group, icon: Home, keys: ["Home"],
      words: "frame all reset camera", run: () => viewport.frameAll(),
    },
    {
      id: "view.frame", title: "Show what is selected", group, icon: Scan, keys: ["F"],
      words: "frame focus selection zoom", run: () => viewport.frameSelection(),
    },
    toggle("water", "Water", "sea show hide", Waves),
    toggle("wireframe", "Wireframe", "mesh triangles", Box),
    toggle("grid", "Grid lines on the map", "graticule kilometres", Grid3x3),
    ...styleNames.map(([style, name]): Action => ({
      id: `view.style_${style}`, title: `Ground: ${name.toLowerCase()}`, group, icon: Mountain,
      words: "texture relief steepness height lines",
      checked: () => options.value.ground === style, run: () => change({ ground: style }),
    })),
    ...climateNames.map(([climate, name, about]): Action => ({
      id: `view.climate_${climate}`, title: `Climate: ${name.toLowerCase()}`, group, icon: Thermometer, words: about,
      checked: () => options.value.climate === climate, run: () => change({ climate }),
    })),
    {
      id: "view.higher", title: "More exaggeration", group, words: "vertical height scale",
      run: () => change({ exaggeration: next(1) }),
    },
    {
      id: "view.lower", title: "Less exaggeration", group, words: "vertical height scale",
      run: () => change({ exaggeration: next(-1) }),
    },
    {
      id: "view.navigation", title: "Middle button pans, as in Gaea", group,
      words: "navigation preset blender orbit mouse",
      checked: () => options.value.navigation === "gaea",
      run: () => change({ navigation: options.peek().navigation === "gaea" ? "blender" : "gaea" }),
    },
  ];
}
