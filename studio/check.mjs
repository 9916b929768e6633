// Holds what the compiler does not: lines of at most 120 columns.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const folder = new URL(".", import.meta.url).pathname;
const most = 120;
/** Made by the program, not written. */
const skipped = ["src/generated"];
/** Every file below a folder that somebody wrote. */
function written(path) {
  return readdirSync(join(folder, path), { withFileTypes: true }).flatMap((entry) => {
    const below = `${path}/${entry.name}`;
    if (skipped.includes(below)) return [];
    if (entry.isDirectory()) return written(below);
    return /\.(tsx?|css)$/.test(entry.name) ? [below] : [];
  });
}

const long = ["src", "tests"].flatMap(written).flatMap((path) => {
  const lines = readFileSync(join(folder, path), "utf8").split("\n");
  return lines.flatMap((line, i) => ([...line].length > most ? [`${path}:${i + 1}: ${[...line].length} columns`] : []));
});
for (const place of long) console.error(place);
process.exit(long.length > 0 ? 1 : 0);
