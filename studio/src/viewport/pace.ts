// How much a picture may cost: from what the last ones took, whether the next is drawn finely, how often a still one is
// averaged, and how coarse one is while the view moves. Pure.

/** Parts of the full size that pictures of a moving view have. */
const sizes = [1, 0.6, 0.45] as const;

export class Pace {
  private quick: number;
  private fine = 0;
  private size: number;

  constructor(private readonly software: boolean) {
    this.size = software ? 1 : 0;
    this.quick = software ? 45 : 10;
  }

  /** A picture took so many milliseconds until it was done. */
  took(ms: number, fine: boolean): void {
    if (fine) {
      this.fine = this.fine === 0 ? ms : 0.5 * (this.fine + ms);
      return;
    }
    this.quick += 0.3 * (ms - this.quick);
    if (this.quick > 24 && this.size + 1 < sizes.length) {
      ++this.size;
      this.quick *= 0.6;
    } else if (this.quick < 16 && this.size > 0) {
      --this.size;
      this.quick *= 1.8;
    }
  }

  get quickSize(): number {
    return sizes[this.size]!;
  }
  get quickMs(): number {
    return this.quick;
  }

  /** Asked once for each picture of a still view: what was too slow is tried again after a while. */
  mayBeFine(): boolean {
    if (!this.software || this.fine < 900) return true;
    this.fine *= 0.85;
    return false;
  }

  /** Pictures that are averaged. */
  samples(wanted: number): number {
    if (!this.software) return wanted;
    return Math.min(wanted, this.fine < 160 ? 4 : this.fine < 320 ? 2 : 1);
  }
}
