// What the server and the page say to each other. The server's side of the same is src/seamount/server.
//
// Requests to /api carry "Authorization: Bearer TOKEN"; the token comes in the fragment of the opened address. Answers
// are JSON but for rasters and pictures. A refusal is an ErrorAnswer: 400 wrong request, 401 no token, 404 no such
// thing, 409 out of date, 413 too large, 422 the document would be no recipe.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

export interface Diagnostic {
  /** JSON pointer into the recipe. */
  pointer: string;
  message: string;
  /** From 1; 0: unknown. */
  line: number;
  column: number;
}

export interface ErrorAnswer {
  error: string;
  diagnostics?: Diagnostic[];
  /** 409: what the sender has missed since its base. */
  missed?: DocumentEvent[];
}

// ---------------------------------------------------------------------------------------------------- GET /api/schema
export interface Schema {
  version: string;
  operators: OperatorInfo[];
  formats: FormatInfo[];
  kinds: { name: string; about: string; files: string[] }[];
  /** Members of the document's "domain": width_m, height_m, cell_m, size ... */
  domain: ParamInfo[];
}

export interface OperatorInfo {
  /** "island.coral"; the family is what stands before the dot. */
  name: string;
  summary: string;
  source: string;
  stochastic: boolean;
  /** One of its inputs is needed, whichever, though none is required alone. */
  needs_one?: boolean;
  in: PortInfo[];
  out: PortInfo[];
  params: ParamInfo[];
}

export interface PortInfo {
  name: string;
  /** terrain, labels, field, current, image, things, catalogue, objects, drawing, tin, contours, report */
  kind: string;
  help: string;
  required: boolean;
}

export type ParamKind =
  | "number" | "integer" | "switch" | "choice" | "preset" | "text" | "file" | "model" | "files" | "colour" | "point"
  | "curve" | "numbers" | "integers" | "texts" | "points" | "strokes" | "outlines" | "polygons" | "regions" | "rivers"
  | "group" | "groups" | "tools";

export interface ParamInfo {
  name: string;
  kind: ParamKind;
  unit: string;
  /** Left out where there is no bound. */
  min?: number;
  max?: number;
  choices?: string[];
  help: string;
  /** null: derived. */
  default: Json;
  /** "tools": each tool by name; "group" and "groups": one without a name, whose params are the members. */
  tools?: { name: string; about: string; params: ParamInfo[] }[];
  /** "preset": what each word sets. */
  presets?: { name: string; about: string; values: { [param: string]: Json } }[];
}

export interface FormatInfo {
  name: string;
  summary: string;
  /** ".tif" ... */
  extensions: string[];
  /** Kinds that it writes. */
  accepts: string[];
  params: ParamInfo[];
}

// -------------------------------------------------------------------------------------------------- GET /api/document
export interface DocumentAnswer {
  revision: number;
  /** Relative to the studio's folder; "" for one that was never saved. */
  file: string;
  folder: string;
  /** False: there are edits that the file does not have (the journal has them). */
  saved: boolean;
  recipe: Recipe;
  text: string;
  /** Gestures, oldest first; the first `done` are in force, the others can be made again. */
  history: { label: string; window: string }[];
  done: number;
  /** Open inputs. */
  missing: Diagnostic[];
}

/** As it is written; see docs/guide/recipes.md. Steps and outputs may use its shorthand. */
export interface Recipe {
  seamount: 1;
  about?: string;
  variables?: { [name: string]: Json };
  domain?: { [member: string]: number };
  seed?: number;
  steps: Step[];
  outputs?: Output[];
}

export interface Step {
  id: string;
  op: string;
  about?: string;
  seed?: number;
  bypass?: boolean;
  /** Port to source; or a step whose outputs go to the inputs of the same names; left out: the step before. */
  in?: { [port: string]: Source | Source[] } | string | string[];
  params?: { [name: string]: Json };
}

/** "step.port", "step", or a file. */
export type Source = string | { file: string };

export interface Output {
  path: string;
  from?: Source;
  as?: string;
  [param: string]: Json | undefined;
}

// -------------------------------------------------------------------------------------------------- POST /api/edits
/** Places are JSON pointers in which a step may be named by its id: "/steps/reef/params/subsidence". */
export type Edit =
  /** Without a value the member is taken out: a parameter has its default again. Objects on the way are made. */
  | { do: "set"; pointer: string; value?: Json }
  /** Into a list (steps, outputs, strokes) before the item at `index`; at the end without. */
  | { do: "insert"; list: string; index?: number; value: Json }
  | { do: "remove"; item: string }
  | { do: "move"; item: string; index: number }
  | { do: "rename"; id: string; new_id: string }
  /** What read from it is connected to what it would have passed on. */
  | { do: "remove_step"; id: string };

export interface EditRequest {
  /** A random name of the sending window. */
  window: string;
  /** The revision that the sender knows. */
  base: number;
  /** Edits in a row of one gesture are undone as one; "" belongs to none. */
  gesture: string;
  /** The gesture is over with these: what is computed in a moment gets no coarse result before it. */
  ends?: boolean;
  /** For the history: "reef: subsidence 0.2 → 0.4". */
  label: string;
  edits: Edit[];
}

/** One elementary change, with indices only: `before` or `after` absent: put in, or taken out, at `index`. */
export interface Change {
  pointer: string;
  index: number;
  before?: Json;
  after?: Json;
}

/** Answer to edits, undo, redo and text, once it is safe on disk; and an event of the stream for every window. */
export interface DocumentEvent {
  event: "document";
  revision: number;
  window: string;
  changes: Change[];
  label: string;
  done: number;
  undone: number;
  saved: boolean;
  missing: Diagnostic[];
}
// POST /api/undo, /api/redo {window, base}: DocumentEvent; 404 where there is nothing.
// POST /api/text {window, base, text}: the differences become edits; 422 with diagnostics, and nothing has changed.
// POST /api/check {text}: {diagnostics, text}: what is wrong with a text, without taking it over.

// ------------------------------------------------------------------------------------------------------ POST /api/want
export interface WantRequest {
  window: string;
  /** "step.port"; "step": its first output. What the window shows, and nothing else is computed. */
  sources: string[];
  quality: "coarse" | "full" | "coarse_then_full";
}

// ----------------------------------------------------------------------------------- GET /api/events?window=W  (lines)
/** The stream is one JSON object a line, the newest of each kind: a slow reader misses states, never documents. */
export type StudioEvent =
  | { event: "hello"; version: string; revision: number }
  | DocumentEvent
  | { event: "opened"; file: string }
  | ({ event: "state" } & EngineState)
  | ValueEvent
  | { event: "gone"; source: string }
  | JobEvent
  | { event: "alive" };

export type Standing =
  | "fresh" | "stale" | "queued" | "running" | "failed" | "blocked" | "incomplete" | "bypassed";

export interface EngineState {
  revision: number;
  settled: boolean;
  /** A coarse result is being computed, the full one waits. */
  coarse: boolean;
  fraction: number;
  steps: StepState[];
}

export interface StepState {
  id: string;
  op: string;
  standing: Standing;
  fraction: number;
  seconds: number;
  cached: boolean;
  message: string;
  notes: string[];
}

/** A result that can be fetched under its key until a newer one of the same source is there. Keys are of content: the
 * same key has the same bytes for ever. */
export interface ValueEvent {
  event: "value";
  source: string;
  key: string;
  kind: string;
  revision: number;
  coarse: boolean;
  frame?: Frame;
  /** Of rasters: range of the values that are known. */
  min?: number;
  max?: number;
}

/** Where a raster lies: cell (0, 0) is the north-west corner's, rows go south. Metres of the document's system. */
export interface Frame {
  columns: number;
  rows: number;
  cell_m: number;
  /** West and north edge of the raster (cells are areas). */
  west: number;
  north: number;
  /** "EPSG:32627"; "" for local metres. */
  crs: string;
}

// GET /api/values/KEY/raster?level=L&x=X&y=Y&columns=C&rows=R : every 2^L-th cell of each row and column, those from
//   (X, Y) of that level on; left out: all. f32 little endian, row-major, NaN unknown; labels are u8
//   (0 mountain, 1 beach, 2 lagoon, 3 reef, 4 abyss). Header X-Raster: "COLUMNS ROWS f32|u8". 404: the key is gone.
//   Currents: two f32 a cell, east and north.
// GET /api/values/KEY/picture : PNG of an image value.
// GET /api/values/KEY/shapes : GeoJSON-like {type: "FeatureCollection"} in the document's metres, for drawing,
//   contours, tin (edges), objects.
// GET /api/values/KEY/json : reports, catalogues.
// GET /api/values/KEY/things : {models: [{name, triangles: base64 f32 xyz normal rgb}], instances: [{model, x, y, z,
//   angle_deg, scale}]}, at most 20 000 instances, the largest.

// ---------------------------------------------------------------------------------------------------- files and jobs
// GET  /api/examples : {examples: [{name, title, about, group, picture: is there one}]}; GET
// /api/examples/NAME/picture (PNG, 404 without)
// GET  /api/files : {folder, files: [{path, bytes, modified}]}: recipes and data in the studio's folder
// POST /api/open {example} | {path} | {blank: true, width_m, height_m? (square), cell_m} : DocumentAnswer; an "opened"
// event
//   for all windows
// POST /api/save {path?} : {file, saved}
// POST /api/upload?name=N, body = bytes : {file, kind, about}: kept beside the document under the hash of its content
// GET  /api/download?path=P : an exported file
// POST /api/export {window, outputs: Output[], folder} : {job}: writes like `run`
// POST /api/cancel {job?} : stops a job, or all computing until the next edit
export interface JobEvent {
  event: "job";
  job: string;
  what: string;
  fraction: number;
  state: "running" | "done" | "failed" | "cancelled";
  message: string;
  files: { path: string; bytes: number }[];
  notes: string[];
}
