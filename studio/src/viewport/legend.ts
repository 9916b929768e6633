// The legend of what is laid over the ground: a small box in the corner of a view.
import type { Legend } from "./ground_overlay";
import { fieldText } from "./ticks";

const css = (c: readonly [number, number, number]): string => `rgb(${c.map(Math.round).join(" ")})`;

function element(name: string, className: string, words = ""): HTMLElement {
  const made = document.createElement(name);
  made.className = className;
  made.textContent = words;
  return made;
}

export function legendElement(legend: Legend): HTMLElement {
  const box = element("div", "view-legend");
  if (legend.bar !== undefined) {
    const { min, max, colour } = legend.bar;
    const bar = element("div", "view-legend-bar");
    const stops = Array.from({ length: 13 }, (_, i) => css(colour(i / 12)));
    bar.style.background = `linear-gradient(to right, ${stops.join(", ")})`;
    const ends = element("div", "view-legend-ends");
    ends.append(element("span", "", fieldText(min)), element("span", "", fieldText(max)));
    box.append(bar, ends);
  }
  for (const { name, colour } of legend.swatches ?? []) {
    const row = element("div", "view-legend-row"), swatch = element("span", "view-legend-swatch");
    swatch.style.background = css(colour);
    row.append(swatch, element("span", "", name));
    box.append(row);
  }
  return box;
}
