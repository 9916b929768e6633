// The document as this window holds it: what the server has confirmed, and over it the window's own edits that are on
// their way. Edits are sent one request at a time and in order; what the server says of others' edits is put under
// them.
import { signal } from "@preact/signals";
import type { Signal } from "@preact/signals";
import { ApiError, Disconnected } from "../api/api";
import type { Api } from "../api/api";
import type { DocumentAnswer, DocumentEvent, Edit, Json, Recipe } from "../api/types";
import { applyChanges, applyEdits } from "./apply";
import { followHistory } from "./history";
import { equalJson, freeze, NoSuchPlace } from "./pointer";
import { enqueue } from "./queue";
import type { Waiting } from "./queue";
import { refusalMessage } from "./refusals";
import type { DocumentState, Message } from "./studio";

/** What waits to be sent: edits, or something of which the window does not know what it will change. */
type Task =
  | { kind: "edits"; edits: Waiting }
  | { kind: "command"; run: Command; quiet: boolean; settle: (taken: boolean) => void };
type Command = (base: number) => Promise<DocumentEvent>;

const kMostTries = 20;

function frozenRecipe(recipe: Recipe): Recipe {
  return freeze(recipe as unknown as Json) as unknown as Recipe;
}

export function stateOf(answer: DocumentAnswer): DocumentState {
  const { recipe, revision, file, saved, history, done, missing } = answer;
  return { recipe: frozenRecipe(recipe), revision, file, saved, history, done, missing };
}

export class DocumentStore {
  readonly state: Signal<DocumentState>;
  /** Edits are on their way. */
  readonly busy = signal(false);
  private confirmed: DocumentState;
  private tasks: Task[] = [];
  private sending: Task | null = null;
  /** The stream has told of the request that is being sent before its answer came. */
  private told = false;
  /** The newest edit of this window was the last one of its gesture. */
  private gestureOver = false;
  /** What the last gesture of this window ended with. */
  private endRevision = 0;
  private base = 0;
  private paused = false;
  private loading: Promise<void> | null = null;

  constructor(
    private api: Api, readonly window: string, answer: DocumentAnswer, private say: (message: Message) => void,
  ) {
    this.confirmed = stateOf(answer);
    this.state = signal(this.confirmed);
  }

  edit(edits: Edit[], label: string, gesture: string, ends = false): Promise<boolean> {
    const own = structuredClone(edits);  // the caller's lists go on changing under its pen
    this.gestureOver = ends;
    if (ends) this.endRevision = this.confirmed.revision;  // or what its answer says
    let idle = false;
    try {
      const after = applyEdits(this.state.value.recipe, own);
      idle = ends && equalJson(after as unknown as Json, this.state.value.recipe as unknown as Json);
    } catch (error) {
      if (!(error instanceof NoSuchPlace)) throw error;
      this.say({ kind: "error", text: `This cannot be changed: ${error.message}` });
      return Promise.resolve(false);
    }
    return new Promise((settle) => {
      const next = { edits: own, label, gesture, ends, idle, settle: [settle] };
      const last = this.tasks[this.tasks.length - 1];
      if (last?.kind === "edits") {
        this.tasks.splice(-1, 1, ...enqueue([last.edits], next).map((edits) => ({ kind: "edits" as const, edits })));
      } else {
        this.tasks.push({ kind: "edits", edits: next });
      }
      this.show();
      void this.pump();
    });
  }

  /** A result of a revision is not worth showing any more: the gesture that it is of has ended, and what it ended with
   * is being computed. While one goes on, nothing is: the view follows the hand. */
  overtaken(revision: number): boolean {
    const changes = (task: Task): boolean => task.kind !== "edits" || !task.edits.idle;
    return this.gestureOver && (this.onTheWay.some(changes) || revision < this.endRevision);
  }

  undo(): Promise<boolean> {
    return this.command((base) => this.api.undo(this.window, base));
  }

  redo(): Promise<boolean> {
    return this.command((base) => this.api.redo(this.window, base));
  }

  /** Whatever else changes the document, after all edits that wait; not tried again where it is out of date. Quiet:
   * its caller says itself why it was refused. */
  command(run: Command, quiet = false): Promise<boolean> {
    return new Promise((settle) => {
      this.tasks.push({ kind: "command", run, quiet, settle });
      this.show();
      void this.pump();
    });
  }

  /** An event of the stream, or of an answer: in the order of revisions, and each at most once. */
  receive(event: DocumentEvent): void {
    if (event.window === this.window && this.sending && event.revision > this.base) this.told = true;
    if (event.window === this.window && this.sending?.kind === "edits" && this.sending.edits.ends) {
      this.endRevision = event.revision;
    }
    if (event.revision <= this.confirmed.revision) return this.receiveAgain(event);
    const history = followHistory(this.confirmed, event);
    if (event.revision !== this.confirmed.revision + 1 || !history) {
      void this.reload();
      return;
    }
    try {
      const recipe = frozenRecipe(applyChanges(this.confirmed.recipe, structuredClone(event.changes)));
      const { revision, saved, missing } = event;
      this.confirmed = { ...this.confirmed, recipe, revision, saved, missing, ...history };
      this.show();
    } catch {
      void this.reload();
    }
  }

  /** What is known already, or what changes nothing but whether it is saved; where is known to the window that did
   * it. */
  private receiveAgain(event: DocumentEvent): void {
    if (event.revision === this.confirmed.revision && event.changes.length === 0) {
      this.confirmed = { ...this.confirmed, saved: event.saved, missing: event.missing };
      if (event.window !== this.window) void this.reload();
    }
    this.show();
  }

  /** The document as the server has it, from scratch. */
  reload(): Promise<void> {
    this.loading ??= this.api
      .document()
      .then((answer) => {
        if (answer.revision >= this.confirmed.revision) this.replace(answer);
      })
      .catch(() => undefined)
      .finally(() => (this.loading = null));
    return this.loading;
  }

  replace(answer: DocumentAnswer): void {
    this.confirmed = stateOf(answer);
    this.show();
  }

  /** After all edits that wait. Without a path: to the file that it came from. */
  async save(path?: string): Promise<boolean> {
    let refusal: unknown = null;
    const taken = await this.command(async (base) => {
      try {
        return await this.api.save(this.window, base, path);
      } catch (error) {
        refusal = error;
        throw error;
      }
    }, true);
    if (!taken && refusal instanceof ApiError) throw refusal;
    if (taken && path !== undefined) await this.reload();
    return taken;
  }

  /** Another document was opened: what waits belongs to the one before. */
  forget(): void {
    const gone = this.tasks.splice(0);
    for (const task of gone) settleTask(task, false);
  }

  /** While the server is gone nothing is sent, and what waits is kept. */
  pause(): void {
    this.paused = true;
  }

  /** The server is there: what waits is sent, and what it has become meanwhile is fetched. A request that was not
   * answered is sent again: whether it was carried out, and what else was, is told by its refusal. */
  resume(): void {
    if (this.unanswered === null) void this.reload();
    this.paused = false;
    void this.pump();
  }

  /** What the document does not have yet. */
  private get onTheWay(): Task[] {
    return [...(this.sending && !this.told ? [this.sending] : []), ...this.tasks];
  }

  private show(): void {
    let recipe = this.confirmed.recipe;
    const { onTheWay } = this;
    for (const task of onTheWay) {
      if (task.kind !== "edits") continue;
      try {
        recipe = applyEdits(recipe, task.edits.edits);
      } catch (error) {
        if (!(error instanceof NoSuchPlace)) throw error;  // another window took the place away: the server will say so
      }
    }
    this.busy.value = onTheWay.length > 0;
    this.state.value = sameAs(this.state.value, { ...this.confirmed, recipe });
  }

  private async pump(): Promise<void> {
    while (!this.sending && !this.paused) {
      const task = this.tasks.shift();
      if (!task) return;
      this.sending = task;
      this.told = false;
      const taken = await this.send(task);
      this.sending = null;
      if (taken === null) {  // the connection is gone: it stays first, and is sent again under its old base
        this.tasks.unshift(task);
        this.paused = true;
      } else {
        settleTask(task, taken);
      }
      this.show();
    }
  }

  /** Null: whether the server took it is not known. */
  private async send(task: Task): Promise<boolean | null> {
    this.base = this.resendBase(task);
    for (let tries = 0; tries < kMostTries; ++tries) {
      try {
        this.receive(await this.ask(task));
        return true;
      } catch (error) {
        if (error instanceof Disconnected) {
          this.unanswered = { task, base: this.base };
          return this.told ? true : null;
        }
        if (!(error instanceof ApiError)) throw error;
        if (error.status !== 409) return this.refuse(task, error);
        await this.catchUp(error);
        if (this.told) return true;
        if (task.kind === "command") return this.refuse(task, error);
        this.base = this.confirmed.revision;
      }
    }
    this.say({ kind: "error", text: "Another window changes the document all the time; this was not taken over" });
    return false;
  }

  private unanswered: { task: Task; base: number } | null = null;

  /** A request that was not answered may have been carried out: under its old base the server tells. */
  private resendBase(task: Task): number {
    const again = this.unanswered?.task === task ? this.unanswered.base : this.confirmed.revision;
    this.unanswered = null;
    return again;
  }

  private ask(task: Task): Promise<DocumentEvent> {
    if (task.kind === "command") return task.run(this.base);
    const { edits, label, gesture, ends } = task.edits;
    return this.api.edits({ window: this.window, base: this.base, gesture, ends, label, edits: [...edits] });
  }

  private async catchUp(error: ApiError): Promise<void> {
    const missed = error.answer.missed ?? [];
    for (const event of missed) this.receive(event);
    if (missed.length === 0) await this.reload();
    if (this.loading) await this.loading;
  }

  private refuse(task: Task, error: ApiError): boolean {
    const quiet = task.kind === "command" && (task.quiet || error.status === 404);
    if (!quiet) this.say(refusalMessage(error, this.state.value.recipe));
    return false;
  }
}

/** The state before, or its recipe, where nothing has changed but that the server has confirmed it: panels are not
 * drawn again then. */
function sameAs(before: DocumentState, now: DocumentState): DocumentState {
  const same = (name: keyof DocumentState): boolean => equalJson(before[name] as Json, now[name] as Json);
  const names = Object.keys(now) as (keyof DocumentState)[];
  if (names.every(same)) return before;
  return { ...now, recipe: same("recipe") ? before.recipe : frozenRecipe(now.recipe) };
}

function settleTask(task: Task, taken: boolean): void {
  if (task.kind === "command") task.settle(taken);
  else for (const settle of task.edits.settle) settle(taken);
}
