// One gesture of the pen as one entry of the history: edits while the hand moves, at most one batch a frame, under one
// name; cancelled, it is as if it had not been.
import type { Edit } from "../api/types";
import type { Studio } from "../document/studio";

type Frame = (run: () => void) => void;
export type Editor = Pick<Studio, "edit" | "undo">;

const nextFrame: Frame = (run) => {
  if (typeof requestAnimationFrame === "function") requestAnimationFrame(run);
  else setTimeout(run, 16);
};

function randomName(): string {
  return Math.random().toString(36).slice(2, 10) + Date.now().toString(36);
}

export class Gesture {
  readonly id: string;
  private waiting: (() => Edit[]) | null = null;
  private scheduled = false;
  private last: Promise<boolean> = Promise.resolve(true);
  private sent = 0;
  private refused = false;
  private over = false;

  constructor(
    private readonly studio: Editor, private label: string, private readonly frame: Frame = nextFrame, id?: string,
  ) {
    this.id = id ?? `pen-${randomName()}`;
  }

  /** The server did not take what was sent; the whole is sent once more at the end. */
  get wasRefused(): boolean {
    return this.refused;
  }

  /** Whether anything was sent; nothing: cancelling leaves nothing to take back. */
  get begun(): boolean {
    return this.sent > 0;
  }

  rename(label: string): void {
    this.label = label;
  }

  /** The edits of this moment, made when the frame comes: what was not sent by then is overtaken. */
  live(edits: () => Edit[]): void {
    if (this.over) return;
    this.waiting = edits;
    if (this.scheduled) return;
    this.scheduled = true;
    this.frame(() => {
      this.scheduled = false;
      if (!this.over && !this.refused) this.flush();
    });
  }

  private flush(): void {
    const edits = this.waiting?.() ?? [];
    this.waiting = null;
    if (edits.length === 0) return;
    ++this.sent;
    const answer = this.studio.edit(edits, this.label, this.id, this.over);
    this.last = Promise.all([this.last, answer]).then(([, done]) => {
      if (!done) this.refused = true;
      return done;
    });
  }

  /** The last edits, and the end. After a refusal on the way they are tried once more: the whole may be right where a
   * part was not. False: nothing of it stays. */
  async finish(edits?: () => Edit[]): Promise<boolean> {
    if (this.over) return false;
    if (edits) this.waiting = edits;
    this.over = true;
    if (this.waiting) this.flush();
    return this.last;
  }

  /** Takes back what was sent. */
  async cancel(): Promise<void> {
    if (this.over) return;
    this.over = true;
    this.waiting = null;
    if (this.sent === 0) return;
    if (await this.last) await this.studio.undo();
  }
}
