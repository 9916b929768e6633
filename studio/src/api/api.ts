// What the page asks of the server, as functions. client.ts speaks to a real one; document/fake.ts stands in for it.
import type {
  Diagnostic, DocumentAnswer, DocumentEvent, EditRequest, ErrorAnswer, Json, Output, Schema, StudioEvent, WantRequest,
} from "./types";

/** A part of a raster: every 2^level-th cell from (x, y) of that level on. */
export interface RasterPart {
  level?: number;
  x?: number;
  y?: number;
  columns?: number;
  rows?: number;
  /** Of heights: 1 asks which of them are dry though they lie below the sea. */
  dry?: 1;
}

export interface RasterData {
  columns: number;
  rows: number;
  /** Currents: two a cell, east and north. */
  values: Float32Array | Uint8Array;
  /** 255 on ground below the sea that is no sea, and on land that touches it, else 0. Absent: all water is sea. */
  dry?: Uint8Array;
}

export interface ExampleInfo {
  name: string;
  title: string;
  about: string;
  group: string;
  /** There is a picture of it. */
  picture?: boolean;
}

export interface FileInfo {
  path: string;
  bytes: number;
  modified: string;
}

export interface Uploaded {
  /** As a recipe beside the document's names it. */
  file: string;
  /** "": of none that can be read. */
  kind: string;
  /** What is known of it, by name; "problem": why it cannot be read. */
  info: { [name: string]: string };
}

export interface UploadHow {
  /** What of it is sent, 0 to 1. */
  progress?(share: number): void;
  /** Calls it back. */
  signal?: AbortSignal;
}

export type OpenRequest = { example: string } | { path: string } | {
  blank: true; width_m: number; height_m: number; cell_m: number;
};

/** What a step's value can be fetched as, besides rasters. */
export type ValueForm = "shapes" | "json" | "things";

/** Every function rejects with an ApiError where the server refuses, and with a Disconnected where it is not there. */
export interface Api {
  schema(): Promise<Schema>;
  document(): Promise<DocumentAnswer>;
  edits(request: EditRequest): Promise<DocumentEvent>;
  undo(window: string, base: number): Promise<DocumentEvent>;
  redo(window: string, base: number): Promise<DocumentEvent>;
  text(window: string, base: number, text: string): Promise<DocumentEvent>;
  check(text: string): Promise<{ diagnostics: Diagnostic[] }>;
  want(request: WantRequest): Promise<void>;
  /** Ends when the server or `signal` ends the stream; rejects where there is none. */
  events(window: string, receive: (event: StudioEvent) => void, signal: AbortSignal): Promise<void>;
  raster(key: string, part?: RasterPart): Promise<RasterData>;
  value(key: string, form: ValueForm): Promise<Json>;
  picture(key: string): Promise<Blob>;
  examples(): Promise<ExampleInfo[]>;
  examplePicture(name: string): Promise<Blob | null>;
  files(): Promise<{ folder: string; files: FileInfo[] }>;
  open(request: OpenRequest): Promise<DocumentAnswer>;
  /** Without a path: to the file that it came from. */
  save(window: string, base: number, path?: string): Promise<DocumentEvent>;
  upload(name: string, content: Blob, how?: UploadHow): Promise<Uploaded>;
  download(path: string): Promise<Blob>;
  exportOutputs(window: string, outputs: Output[], folder: string): Promise<{ job: string }>;
  cancel(job?: string): Promise<void>;
  /** Has the files that steps read looked at again. */
  refresh(): Promise<void>;
}

/** The server's refusal. */
export class ApiError extends Error {
  readonly status: number;
  readonly answer: ErrorAnswer;

  constructor(status: number, answer: ErrorAnswer) {
    super(answer.error);
    this.name = "ApiError";
    this.status = status;
    this.answer = answer;
  }
}

/** No answer: whether the request was carried out is not known. */
export class Disconnected extends Error {
  constructor() {
    super("The studio's server does not answer");
    this.name = "Disconnected";
  }
}
