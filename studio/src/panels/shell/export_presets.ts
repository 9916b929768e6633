// What can be written, for whom, and the recipe's output that says so.
import type { FormatInfo, Json, Output, ParamInfo, Recipe, Schema } from "../../api/types";
import { operatorOf } from "../../document/connections";

export interface ExportPreset {
  id: string;
  title: string;
  about: string;
  format: FormatInfo;
  path: string;
  /** The format has to be named: the extension alone would choose another. */
  named: boolean;
}

const kKnown: readonly (Omit<ExportPreset, "format"> & { of: string })[] = [
  { id: "unreal", of: "unreal", title: "Unreal Engine", about: "16-bit landscape", path: "unreal.r16", named: true },
  { id: "unity", of: "unity", title: "Unity", about: "16-bit RAW terrain", path: "unity.raw", named: true },
  { id: "godot", of: "godot", title: "Godot", about: "Terrain3D, HTerrain", path: "godot.exr", named: true },
  { id: "blender", of: "blender", title: "Blender", about: "EXR to displace with", path: "blender.exr", named: true },
  {
    id: "geotiff", of: "raster", title: "GeoTIFF", about: "heights in metres, for GIS", path: "height.tif",
    named: false,
  },
  { id: "gltf", of: "mesh", title: "glTF mesh", about: "triangles with a texture", path: "terrain.glb", named: false },
  {
    id: "picture", of: "perspective", title: "Picture", about: "with sun, sky and water", path: "view.png", named: true,
  },
];

/** Those for engines and programs first, then every other format by its own name. */
export function presetsOf(schema: Schema): ExportPreset[] {
  const known = kKnown.flatMap(({ of, ...preset }) => {
    const format = schema.formats.find((one) => one.name === of);
    return format ? [{ ...preset, format }] : [];
  });
  const used = new Set(known.map((preset) => preset.format.name));
  const others = schema.formats.filter((format) => !used.has(format.name)).map((format) => ({
    id: format.name, title: titleOf(format.name), about: format.summary, format,
    path: `${format.name}${format.extensions[0] ?? ""}`, named: true,
  }));
  return [...known, ...others];
}

function titleOf(name: string): string {
  const words = name.replace(/_/g, " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** "step.port" of every output in the document that the format writes, the last steps first. */
export function sourcesFor(recipe: Recipe, schema: Schema, format: FormatInfo): string[] {
  return [...recipe.steps].reverse().flatMap((step) => (
    (operatorOf(schema, step.op)?.out ?? []).filter(
      (port) => format.accepts.includes(port.kind),
    ).map((port) => `${step.id}.${port.name}`)
  ));
}

/** Parameters that a plain form can ask for; lists and groups are written in the recipe. */
export function plainParams(format: FormatInfo): ParamInfo[] {
  return format.params.filter(
    (param) => ["number", "integer", "switch", "choice", "text", "colour"].includes(param.kind),
  );
}

/** Only what differs from the default is stated. */
export function outputOf(preset: ExportPreset, path: string, from: string, values: { [name: string]: Json }): Output {
  const stated = Object.entries(values).filter(([name, value]) => {
    const param = preset.format.params.find((one) => one.name === name);
    return param !== undefined && value !== "" && value !== param.default;
  });
  return { from, path, ...(preset.named ? { as: preset.format.name } : {}), ...Object.fromEntries(stated) };
}

/** The path with an extension that the format knows. */
export function withExtension(format: FormatInfo, path: string): string {
  const known = format.extensions.some((extension) => path.toLowerCase().endsWith(extension));
  return known || format.extensions.length === 0 ? path : `${path}${format.extensions[0]}`;
}
