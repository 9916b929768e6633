// A view's place in the page: the canvas that shows what was rendered and, over it, the one that shapes are drawn on.
// Pictures of the one WebGL canvas are copied here; several of a still view are averaged, which smooths its edges.

export class ViewSurface {
  readonly ink: CanvasRenderingContext2D;
  width = 0;
  height = 0;
  /** Device pixels a CSS pixel. */
  ratio = 1;
  /** Pictures of the present state that are in the average. */
  samples = 0;
  private readonly picture: CanvasRenderingContext2D;
  private readonly observer: ResizeObserver;

  constructor(readonly element: HTMLElement, label: string, private readonly mostRatio: number, resized: () => void) {
    element.dataset["groundView"] = "";
    const picture = this.layer("view-picture"), ink = this.layer("view-ink");
    picture.setAttribute("role", "img");
    picture.setAttribute("aria-label", label);
    picture.style.visibility = "hidden";  // until there is something to see
    this.picture = picture.getContext("2d", { alpha: false })!;
    // Where a processor plays the graphics card, paths are drawn hundreds of times as fast without it.
    this.ink = ink.getContext("2d", { willReadFrequently: mostRatio <= 1 })!;
    this.observer = new ResizeObserver(() => {
      if (this.measure()) resized();
    });
    this.observer.observe(element);
    this.measure();
  }

  get shown(): boolean {
    return this.width > 0 && this.height > 0;
  }

  get canvas(): HTMLCanvasElement {
    return this.picture.canvas;
  }

  /** Size in device pixels. */
  get pixels(): { width: number; height: number } {
    return { width: this.picture.canvas.width, height: this.picture.canvas.height };
  }

  /** Takes over a rendered picture of that size from the lower left corner of a canvas. */
  show(source: CanvasImageSource & { height: number }, width: number, height: number): void {
    const { canvas } = this.picture;
    this.picture.globalAlpha = 1 / (this.samples + 1);
    this.picture.imageSmoothingEnabled = width !== canvas.width;
    this.picture.imageSmoothingQuality = "low";
    this.picture.drawImage(source, 0, source.height - height, width, height, 0, 0, canvas.width, canvas.height);
    if (canvas.style.visibility === "hidden") canvas.style.visibility = "";
    ++this.samples;
  }

  /** Clears the upper canvas; drawing on it is in CSS pixels. */
  beginInk(): CanvasRenderingContext2D {
    const { canvas } = this.ink;
    this.ink.setTransform(1, 0, 0, 1, 0, 0);
    this.ink.clearRect(0, 0, canvas.width, canvas.height);
    this.ink.setTransform(this.inkRatio, 0, 0, this.inkRatio, 0, 0);
    return this.ink;
  }

  dispose(): void {
    this.observer.disconnect();
    this.picture.canvas.remove();
    this.ink.canvas.remove();
    delete this.element.dataset["groundView"];
  }

  private get inkRatio(): number {
    return Math.max(1, window.devicePixelRatio || 1);
  }

  private layer(name: string): HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.className = name;
    this.element.append(canvas);
    return canvas;
  }

  /** What was shown is stretched until there is a new picture: no flicker. */
  private resizePicture(width: number, height: number): void {
    const { canvas } = this.picture;
    const before = canvas.width > 1 && canvas.style.visibility !== "hidden"
      ? new OffscreenCanvas(canvas.width, canvas.height) : null;
    before?.getContext("2d", { alpha: false })!.drawImage(canvas, 0, 0);
    canvas.width = width;
    canvas.height = height;
    this.picture.globalAlpha = 1;
    if (before !== null) this.picture.drawImage(before, 0, 0, width, height);
  }

  private measure(): boolean {
    const width = this.element.clientWidth, height = this.element.clientHeight;
    this.ratio = Math.min(this.mostRatio, Math.max(1, window.devicePixelRatio || 1));
    const across = Math.round(width * this.ratio), down = Math.round(height * this.ratio);
    const same = width === this.width && height === this.height && across === this.picture.canvas.width;
    if (same) return false;
    this.width = width;
    this.height = height;
    this.resizePicture(Math.max(1, across), Math.max(1, down));
    this.ink.canvas.width = Math.max(1, Math.round(width * this.inkRatio));
    this.ink.canvas.height = Math.max(1, Math.round(height * this.inkRatio));
    return true;
  }
}
