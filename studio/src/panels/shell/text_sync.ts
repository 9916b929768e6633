// Keeps the text pane and the document alike: what is typed becomes edits as soon as it is a recipe, what changes
// elsewhere is changed in the text, and a text that is no recipe stays here with its errors marked.
import { effect, signal } from "@preact/signals";
import { ApiError } from "../../api/api";
import type { Diagnostic, Json } from "../../api/types";
import type { OpenedStudio } from "../../document/open_studio";
import { equalJson } from "../../document/pointer";

/** What the editor does for it. */
export interface SyncedEditor {
  readonly text: string;
  readonly focused: boolean;
  merge(before: string, after: string): void;
  mark(diagnostics: readonly Diagnostic[]): void;
}

const kPause_ms = 300;

export type TextStanding = "same" | "typing" | "errors" | "offline";

export class TextSync {
  readonly diagnostics = signal<readonly Diagnostic[]>([]);
  readonly standing = signal<TextStanding>("same");
  private timer: ReturnType<typeof setTimeout> | undefined;
  private pushing = false;
  /** Something is to be looked at that came while a text was being pushed. */
  private again = false;
  private fetching = false;
  private ended = false;
  private end: () => void;

  constructor(
    private studio: OpenedStudio, private editor: SyncedEditor, private base: string, private revision: number,
    private pause_ms = kPause_ms,
  ) {
    this.end = effect(() => {
      const { revision: now } = studio.document.value;
      if (now !== this.revision) void this.fetch();
    });
  }

  /** Something was typed: looked at as soon as the hand rests. */
  typed(): void {
    this.standing.value = "typing";
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.push(), this.pause_ms);
  }

  /** The document's own writing is shown as soon as nobody writes. */
  blurred(): void {
    if (this.standing.value === "same" && !this.editor.focused) this.editor.merge(this.editor.text, this.base);
  }

  close(): void {
    this.ended = true;
    clearTimeout(this.timer);
    this.end();
  }

  private async fetch(): Promise<void> {
    if (this.fetching) return;
    this.fetching = true;
    try {
      for (;;) {
        const { text, revision } = await this.studio.api.document();
        if (this.ended) return;
        this.takeOver(text, revision);
        if (this.studio.document.value.revision <= revision) break;
      }
    } catch {
      this.standing.value = "offline";  // fetched with the next revision, or when something is typed
    } finally {
      this.fetching = false;
    }
  }

  private takeOver(text: string, revision: number): void {
    const ours = this.editor.text;
    const sameMeaning = this.meansSame(ours, text);
    if (!(this.editor.focused && sameMeaning)) this.editor.merge(sameMeaning ? ours : this.base, text);
    this.base = text;
    this.revision = revision;
    if (this.meansSame(this.editor.text, text)) this.settle([]);
    else this.typed();
  }

  private meansSame(a: string, b: string): boolean {
    if (a === b) return true;
    try {
      return equalJson(JSON.parse(a) as Json, JSON.parse(b) as Json);
    } catch {
      return false;
    }
  }

  private settle(diagnostics: readonly Diagnostic[]): void {
    this.diagnostics.value = diagnostics;
    this.standing.value = diagnostics.length > 0 ? "errors" : "same";
    this.editor.mark(diagnostics);
  }

  private async push(): Promise<void> {
    if (this.ended) return;
    this.again = this.pushing;
    if (this.pushing) return;
    const text = this.editor.text, revision = this.revision;  // of one another: both change when a change is fetched
    if (this.meansSame(text, this.base)) return this.settle([]);
    this.pushing = true;
    try {
      await this.send(text, revision);
      await this.markOpenInputs();
    } catch {
      this.standing.value = "offline";
    } finally {
      this.pushing = false;
    }
    if (!this.ended && (this.again || this.editor.text !== text)) this.typed();
  }

  /** An open input is no error, but its place is worth seeing. */
  private async markOpenInputs(): Promise<void> {
    if (this.ended || this.standing.value !== "same" || this.studio.document.value.missing.length === 0) return;
    const text = this.editor.text;
    const { diagnostics } = await this.studio.api.check(text);
    if (!this.ended && this.editor.text === text) this.editor.mark(diagnostics);
  }

  /** Out of date: the document's change is fetched, put under what was typed, and it is sent again. */
  private async send(text: string, revision: number): Promise<void> {
    const { api, window } = this.studio;
    const taken = await this.studio.command(async () => {
      try {
        return await api.text(window, revision, text);
      } catch (error) {
        if (
          error instanceof ApiError && error.status === 422 && !this.ended
        ) this.settle(error.answer.diagnostics ?? []);
        throw error;
      }
    });
    if (taken || this.standing.value !== "errors") await this.fetch();
  }
}
