// How long something that reports its share done will still take.

export class Estimate {
  private began: { fraction: number; at_ms: number } | null = null;
  private last = 0;

  /** Seconds that are left; null: not known yet. Begins anew when the share goes back. */
  left_s(fraction: number, now_ms: number): number | null {
    if (!this.began || fraction < this.last) this.began = { fraction, at_ms: now_ms };
    this.last = fraction;
    const gone = fraction - this.began.fraction;
    const seconds = (now_ms - this.began.at_ms) / 1000;
    if (gone < 0.03 || seconds < 1) return null;
    return (seconds * (1 - fraction)) / gone;
  }
}
