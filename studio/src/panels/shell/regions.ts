// The parts of the window that F6 goes through.

const kRegions = [".top-bar", ".rail-place", ".view.whole, .view.half", ".side-panel", ".dock", ".status-line"];
const kFocusable =
  "button:not(:disabled):not([tabindex='-1']), input:not(:disabled), select, textarea, a[href], [tabindex='0']";

/** The focus goes to what can take it in the next part that is there. */
export function goToRegion(by: 1 | -1): void {
  const regions = kRegions.map(
    (selector) => document.querySelector<HTMLElement>(selector),
  ).filter((one) => one !== null);
  const active = document.activeElement;
  const at = regions.findIndex((region) => region.contains(active));
  for (let i = 1; i <= regions.length; ++i) {
    const region = regions[(at + by * i + 2 * regions.length) % regions.length]!;
    const target = region.querySelector<HTMLElement>("canvas[tabindex='0']")
      ?? region.querySelector<HTMLElement>(kFocusable);
    if (!target) continue;
    target.focus();
    return;
  }
}
