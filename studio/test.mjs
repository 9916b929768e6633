// Runs the studio's tests: `node test.mjs unit` those beside the sources (*.test.ts), `node test.mjs browser` those
// that drive the real server and Chromium (*.browser.ts); further words choose files whose path holds one of them.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { readdirSync, rmSync } from "node:fs";
import { join } from "node:path";

const folder = new URL(".", import.meta.url).pathname;
const [sort, ...words] = process.argv.slice(2);
const ending = { unit: ".test.ts", browser: ".browser.ts" }[sort];
if (!ending) throw new Error("usage: node test.mjs unit|browser [WORD...]");

/** Every file below a folder whose name ends so. */
function filesBelow(root, end) {
  return readdirSync(root, { withFileTypes: true }).flatMap((entry) => {
    const path = join(root, entry.name);
    if (entry.isDirectory()) return filesBelow(path, end);
    return entry.name.endsWith(end) ? [path] : [];
  });
}

const chosen = ["src", "tests"]
  .flatMap((part) => filesBelow(join(folder, part), ending))
  .filter((path) => words.length === 0 || words.some((word) => path.includes(word)));
if (chosen.length === 0) throw new Error("no test file has such a name");
const out = join(folder, "dist", sort);
rmSync(out, { recursive: true, force: true });
await build({
  absWorkingDir: folder,
  entryPoints: chosen,
  outdir: out,
  outbase: folder,
  outExtension: { ".js": ".mjs" },
  bundle: true,
  platform: "node",
  format: "esm",
  target: "node18",
  external: ["playwright-core"],
  loader: { ".svg": "text", ".glsl": "text" },
  logLevel: "warning",
});
const run = spawnSync(process.execPath, ["--test", ...filesBelow(out, ".mjs")], { stdio: "inherit", cwd: folder });
process.exit(run.status ?? 1);
