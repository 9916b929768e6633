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

async function page() {
  const out = join(folder, "dist/page");
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  await build({
    absWorkingDir: folder,
    entryPoints: { app: "src/main.tsx", style: "src/style.css" },
    outdir: out,
    bundle: true,
    splitting: true,
    format: "esm",
    target: "es2021",
    minify: true,
    legalComments: "linked",
    loader: { ".svg": "text", ".glsl": "text" },
    logLevel: "warning",
  });
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
