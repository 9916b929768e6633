// The server's events, for as long as the page lives: opened again whenever they end or fall silent.
import { signal } from "@preact/signals";
import { ApiError } from "../api/api";
import type { Api } from "../api/api";
import type { StudioEvent } from "../api/types";

export interface StreamTimes {
  /** The server says something every few seconds; after this long without a word it counts as gone. */
  silence_ms: number;
  first_wait_ms: number;
  longest_wait_ms: number;
}

const kTimes: StreamTimes = { silence_ms: 40_000, first_wait_ms: 250, longest_wait_ms: 5_000 };

export class EventStream {
  readonly connected = signal(false);
  /** The server is another one now: it does not know this window's token. */
  readonly refused = signal(false);
  private ended = false;
  private controller: AbortController | null = null;
  private wake: (() => void) | null = null;

  constructor(
    private api: Pick<Api, "events">, private window: string, private receive: (event: StudioEvent) => void,
    /** A stream is there: with the page, or again. */
    private began: () => void, private times: StreamTimes = kTimes,
  ) {}

  async run(): Promise<void> {
    let wait = this.times.first_wait_ms;
    while (!this.ended) {
      if (await this.listen()) wait = this.times.first_wait_ms;
      this.connected.value = false;
      if (this.ended || this.refused.value) return;
      await this.sleep(wait);
      wait = Math.min(wait * 2, this.times.longest_wait_ms);
    }
  }

  /** Tries now instead of later. */
  hurry(): void {
    this.wake?.();
  }

  close(): void {
    this.ended = true;
    this.controller?.abort();
    this.wake?.();
  }

  /** True: there was a stream. */
  private async listen(): Promise<boolean> {
    const controller = new AbortController();
    this.controller = controller;
    let silence = setTimeout(() => controller.abort(), this.times.silence_ms);
    let heard = false;
    try {
      await this.api.events(this.window, (event) => {
        clearTimeout(silence);
        silence = setTimeout(() => controller.abort(), this.times.silence_ms);
        if (!heard) {
          heard = true;
          this.connected.value = true;
          this.began();
        }
        this.receive(event);
      }, controller.signal);
    } catch (error) {
      if (error instanceof ApiError && error.status === 401) this.refused.value = true;
    } finally {
      clearTimeout(silence);
      controller.abort();
    }
    return heard;
  }

  private sleep(milliseconds: number): Promise<void> {
    return new Promise((resolve) => {
      const timer = setTimeout(resolve, milliseconds);
      this.wake = () => {
        clearTimeout(timer);
        resolve();
      };
    });
  }
}
