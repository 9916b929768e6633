// What every part of the page holds on to: the document as the window sees it, what is computed of it, and what is
// selected. Panels and tools read its signals and call edit(); nothing else changes the document.
import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Api, ValueForm } from "../api/api";
import type {
  Diagnostic, Edit, EngineState, JobEvent, Json, OperatorInfo, Output, Recipe, Schema, Step, ValueEvent,
} from "../api/types";
import type { Raster } from "../viewport/types";

export interface DocumentState {
  /** With the window's own edits that are still on their way. Frozen: never changed in place. */
  recipe: Recipe;
  revision: number;
  file: string;
  saved: boolean;
  history: readonly { label: string; window: string }[];
  done: number;
  missing: readonly Diagnostic[];
}

/** Something that went wrong or should be known, at its step where it has one. */
export interface Message {
  kind: "error" | "warning" | "note";
  text: string;
  step?: string;
}

export interface Studio {
  /** What is neither the document nor a result: pictures, files, exports, examples. */
  readonly api: Api;
  readonly schema: Schema;
  readonly window: string;
  readonly document: ReadonlySignal<DocumentState>;
  readonly engine: ReadonlySignal<EngineState>;
  /** The newest result of each wanted source. */
  readonly values: ReadonlySignal<ReadonlyMap<string, ValueEvent>>;
  readonly jobs: ReadonlySignal<readonly JobEvent[]>;
  /** Lost: the server is gone or the stream is being opened again. */
  readonly connected: ReadonlySignal<boolean>;
  /** Edits are on their way: not yet safe. */
  readonly busy: ReadonlySignal<boolean>;
  /** Id of the step whose parameters are shown and whose tools are offered; null: the document itself. */
  readonly selected: Signal<string | null>;
  /** Source that the views show: a pinned one, or what follows from the selection (its terrain; of masks and labels
   * the terrain under them, with them as overlay). */
  readonly shown: ReadonlySignal<Shown>;
  readonly pinned: Signal<string | null>;
  /** The newest thing that went wrong or should be known, for a toast; with its step where it has one. */
  readonly message: Signal<Message | null>;

  /** Changes the window's copy at once, and the server's as soon as it can; edits of one gesture that are overtaken
   * (set at the same pointer) are not sent. `ends`: the gesture is over with these. False: refused; the copy is the
   * server's again and `message` says why. */
  edit(edits: Edit[], label: string, gesture?: string, ends?: boolean): Promise<boolean>;
  /** A result of a revision is not worth showing: the gesture that it is of has ended, and a newer one will come. */
  overtaken(revision: number): boolean;
  undo(): Promise<boolean>;
  redo(): Promise<boolean>;

  /** More sources that are wanted besides `shown`, by who wants them (thumbnails); [] withdraws. */
  want(who: string, sources: string[]): void;
  /** Whole raster of a wanted source, every 2^level-th cell; null: nothing there or no raster. Cached by key. */
  raster(source: string, level?: number): Promise<Raster | null>;
  /** A wanted source in another form: its lines and areas, its things, its numbers. Cached by key. */
  content(source: string, form: ValueForm): Promise<Json | null>;

  step(id: string): Step | undefined;
  operator(op: string): OperatorInfo | undefined;
  /** Value of a parameter by its path ("walk/stickiness"): what the step states, else the preset's, else the
   * default. */
  param(step: string, path: string): Json | undefined;
}

export interface Shown {
  terrain: string | null;
  overlay: string | null;
  /** Objects that come with the terrain, and the step that says what they look like, where there are any. */
  objects: string | null;
  things: string | null;
}

export type { Output };
