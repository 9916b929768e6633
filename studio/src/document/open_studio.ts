// Puts the window's document, its results and the stream together: the one thing that all parts of the page share.
import { computed, effect, signal } from "@preact/signals";
import type { Api, OpenRequest } from "../api/api";
import type { DocumentAnswer, DocumentEvent, JobEvent, StudioEvent } from "../api/types";
import { operatorOf, stepOf } from "./connections";
import { parameterValue } from "./parameters";
import { equalJson } from "./pointer";
import { Results } from "./results";
import { shownOf } from "./shown";
import { DocumentStore } from "./store";
import { EventStream } from "./stream";
import type { Message, Shown, Studio } from "./studio";

/** What the shell needs besides what every part may use. */
export interface OpenedStudio extends Studio {
  /** The server does not know this window's token: it was started anew. */
  readonly refused: EventStream["refused"];
  /** Runs what changes the document by other ways than edits (the text pane), in its turn; says nothing of refusals. */
  command(run: (base: number) => Promise<DocumentEvent>): Promise<boolean>;
  /** Opens another document, for every window. */
  open(request: OpenRequest): Promise<void>;
  /** Rejects with the server's refusal. */
  save(path?: string): Promise<boolean>;
  retry(): void;
  close(): void;
}

export function randomName(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(9));
  return Array.from(bytes, (byte) => byte.toString(36).padStart(2, "0")).join("");
}

/** What the server has to say about how it opened the document. */
function noticeOf({ notice }: DocumentAnswer & { notice?: string }): Message | null {
  return notice ? { kind: "warning", text: notice } : null;
}

function upsertJob(jobs: readonly JobEvent[], job: JobEvent): JobEvent[] {
  const known = jobs.some((one) => one.job === job.job);
  return known ? jobs.map((one) => (one.job === job.job ? job : one)) : [...jobs, job];
}

export async function openStudio(api: Api, window = randomName()): Promise<OpenedStudio> {
  const [schema, answer] = await Promise.all([api.schema(), api.document()]);
  const message = signal<Message | null>(noticeOf(answer));
  const store = new DocumentStore(api, window, answer, (said) => (message.value = said));
  const results = new Results(api, window);
  const jobs = signal<readonly JobEvent[]>([]);
  const selected = signal<string | null>(null);
  const pinned = signal<string | null>(null);
  let shownBefore: Shown = { terrain: null, overlay: null, objects: null, things: null };
  const shown = computed(() => {  // the same object as long as the same is shown
    const next = shownOf(store.state.value.recipe, schema, selected.value, pinned.value);
    if (!equalJson({ ...next }, { ...shownBefore })) shownBefore = next;
    return shownBefore;
  });

  function replace(answer: DocumentAnswer): void {
    store.forget();
    results.clear();
    selected.value = null;
    pinned.value = null;
    store.replace(answer);
    message.value = noticeOf(answer) ?? message.value;
    results.askAgain();
  }

  let ownOpens = 0;  // of which the stream will tell, too
  async function open(request: OpenRequest): Promise<void> {
    ownOpens += 1;
    try {
      replace(await api.open(request));
    } catch (error) {
      ownOpens -= 1;
      throw error;
    }
  }

  function opened(): void {
    if (ownOpens > 0) ownOpens -= 1;
    else api.document().then(replace).catch(() => undefined);
  }

  const stream = new EventStream(api, window, receive, began);
  /** What was said while there was no stream is not known. */
  function began(): void {
    ownOpens = 0;
    store.resume();
    results.askAgain();
  }

  function receive(event: StudioEvent): void {
    switch (event.event) {
      case "document":
        return store.receive(event);
      case "opened":
        return opened();
      case "state": {
        const { event: _name, ...state } = event;
        return results.state(state);
      }
      case "value":
        return results.receive(event);
      case "gone":
        return results.gone(event.source);
      case "job":
        jobs.value = upsertJob(jobs.value, event);
        return;
      case "hello":
      case "alive":
        return;
    }
  }
  const effects = [
    effect(() => {
      const { terrain, overlay, objects, things } = shown.value;
      results.want("shown", [terrain, overlay, objects, things].filter((source): source is string => source !== null));
    }),
    effect(() => {  // a step that is gone is not selected any more
      const { recipe } = store.state.value;
      if (selected.value !== null && !stepOf(recipe, selected.value)) selected.value = null;
      if (pinned.value !== null && !stepOf(recipe, pinned.value.split(".")[0]!)) pinned.value = null;
    }),
    effect(() => {
      if (!stream.connected.value) store.pause();
    }),
  ];
  void stream.run();

  return {
    api, schema, window, message, jobs, selected, pinned, shown,
    document: store.state,
    busy: store.busy,
    engine: results.engine,
    values: results.values,
    connected: stream.connected,
    refused: stream.refused,
    edit: (edits, label, gesture = "", ends = false) => store.edit(edits, label, gesture, ends),
    overtaken: (revision) => store.overtaken(revision),
    undo: () => store.undo(),
    redo: () => store.redo(),
    command: (run) => store.command(run, true),
    open,
    save: (path) => store.save(path),
    want: (who, sources) => results.want(who, sources),
    raster: (source, level) => results.raster(source, level),
    content: (source, form) => results.content(source, form),
    step: (id) => stepOf(store.state.value.recipe, id),
    operator: (op) => operatorOf(schema, op),
    param: (step, path) => {
      const { recipe } = store.state.value;
      const found = stepOf(recipe, step);
      return found && parameterValue(recipe, schema, found, path);
    },
    retry: () => stream.hurry(),
    close: () => {
      for (const end of effects) end();
      stream.close();
    },
  };
}
