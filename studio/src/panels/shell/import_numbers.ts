// What to type into an engine after an export: it stands in the side-car beside each file.
import type { Json } from "../../api/types";
import { isObject } from "../../document/pointer";

export interface ImportNumbers {
  file: string;
  target: string;
  rows: readonly (readonly [name: string, value: string])[];
  note: string;
}

/** Paths of the side-cars among written files: "unreal.r16.json" beside "unreal.r16". */
export function sidecarsOf(paths: readonly string[]): string[] {
  return paths.filter((path) => path.endsWith(".json") && paths.includes(path.slice(0, -".json".length)));
}

/** Null: nothing is to be typed in for this file. */
export function importNumbers(sidecar: Json): ImportNumbers | null {
  if (!isObject(sidecar) || !isObject(sidecar["import"])) return null;
  const entries = Object.entries(sidecar["import"]);
  const rows = entries.filter(([name]) => name !== "note").map(([name, value]) => [name, String(value)] as const);
  if (rows.length === 0) return null;
  const note = sidecar["import"]["note"];
  return {
    file: String(sidecar["file"] ?? ""), target: String(sidecar["target"] ?? ""), rows,
    note: typeof note === "string" ? note : "",
  };
}

/** For the clipboard: a line each. */
export function numbersText(numbers: readonly ImportNumbers[], notes: readonly string[]): string {
  const lines = numbers.flatMap(
    ({ file, rows, note }) => [
      file, ...rows.map(([name, value]) => `  ${name}: ${value}`), ...(note ? [`  (${note})`] : []),
    ],
  );
  return [...lines, ...notes].join("\n");
}
