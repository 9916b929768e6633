// Light or dark: as the system says, or as chosen here, which this browser remembers.
import { effect, signal } from "@preact/signals";
import { remembered } from "../../document/remember";

export type ThemeChoice = "system" | "dark" | "light";
export type Theme = "dark" | "light";

export const themeChoice = remembered<ThemeChoice>("theme", "system", (value) => (
  value === "dark" || value === "light" || value === "system" ? value : undefined
));

/** The one in force. */
export const theme = signal<Theme>("dark");

export function themeOf(choice: ThemeChoice, systemIsLight: boolean): Theme {
  return choice === "system" ? (systemIsLight ? "light" : "dark") : choice;
}

export function followTheme(root: HTMLElement): void {
  const system = matchMedia("(prefers-color-scheme: light)");
  const systemIsLight = signal(system.matches);
  system.addEventListener("change", () => (systemIsLight.value = system.matches));
  effect(() => {
    theme.value = themeOf(themeChoice.value, systemIsLight.value);
    root.dataset["theme"] = theme.value;
  });
}
