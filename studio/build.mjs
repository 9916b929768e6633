// Builds the studio's page into dist/page, with a compressed copy beside each file, as the server hands it out.
import { build } from "esbuild";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const folder = new URL(".", import.meta.url).pathname;

/** Every file below a folder whose name ends so. */
function filesBelow(root, ending) {
  if (!existsSync(root)) return [];
  return readdirSync(root, { withFileTypes: true }).flatMap((entry) => {
    const path = join(root, entry.name);
    if (entry.isDirectory()) return filesBelow(path, ending);
    return entry.name.endsWith(ending) ? [path] : [];
  });
}

/** The licences of the packages whose files are part of the page. */
function licences(files) {
  const packages = new Set(files.map((file) => /^node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1]).filter(Boolean));
  const texts = [...packages].sort().map((name) => {
    const at = join(folder, "node_modules", name);
    const { version } = JSON.parse(readFileSync(join(at, "package.json"), "utf8"));
    const text = readdirSync(at).find((file) => /^licen[cs]e/i.test(file));
    if (!text) throw new Error(`${name} has no licence`);
    return `${name} ${version}\n\n${readFileSync(join(at, text), "utf8").trim()}\n`;
  });
  return `The studio's page contains these packages.\n\n\n${texts.join("\n\n")}`;
}

async function page() {
  const out = join(folder, "dist/page");
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const made = await build({
    absWorkingDir: folder,
    entryPoints: { app: "src/main.tsx", style: "src/style.css" },
    outdir: out,
    bundle: true,
    splitting: true,
    format: "esm",
    target: "es2021",
    minify: true,
    legalComments: "none",
    metafile: true,
    loader: { ".svg": "text", ".glsl": "text" },
    logLevel: "warning",
  });
  writeFileSync(join(out, "licences.txt"), licences(Object.keys(made.metafile.inputs)));
  cpSync(join(folder, "examples"), join(out, "examples"), { recursive: true });
  for (const file of ["index.html", "icon.svg"]) writeFileSync(
    join(out, file), readFileSync(join(folder, "src", file)),
  );
  let bytes = 0;
  for (const file of [".js", ".css", ".html"].flatMap((ending) => filesBelow(out, ending))) {
    const content = readFileSync(file);
    writeFileSync(`${file}.gz`, gzipSync(content, { level: 9 }));
    const small = brotliCompressSync(content, { params: { [constants.BROTLI_PARAM_QUALITY]: 9 } });
    writeFileSync(`${file}.br`, small);
    bytes += small.length;
  }
  console.error(`studio: dist/page, ${Math.round(bytes / 1024)} KiB compressed`);
}

await page();
