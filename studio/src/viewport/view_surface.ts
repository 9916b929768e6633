// A view's place in the page: the canvas that shows what was rendered and, over it, the one that shapes are drawn on.
// Pictures of the one WebGL canvas are copied here; several of a still view are averaged, which smooths its edges.
// Those of a moving view are handed over as they are, without a copy, and the page stretches them.

export class ViewSurface {
  readonly ink: CanvasRenderingContext2D;
  width = 0;
  height = 0;
  /** Device pixels a CSS pixel. */
  ratio = 1;
  /** Pictures of the present state that are in the average. */
  samples = 0;
  private readonly picture: CanvasRenderingContext2D;
  private readonly quick: ImageBitmapRenderingContext;
  private shownCanvas: HTMLCanvasElement;
  private readonly observer: ResizeObserver;

  /** `software`: the processor draws, so that canvases that pretend to have a graphics processor would only cost. */
  constructor(readonly element: HTMLElement, label: string, private readonly software: boolean, resized: () => void) {
    element.dataset["groundView"] = "";
    const picture = this.layer("view-picture"), quick = this.layer("view-picture"), ink = this.layer("view-ink");
    picture.setAttribute("role", "img");
    picture.setAttribute("aria-label", label);
    picture.style.visibility = quick.style.visibility = "hidden";  // until there is something to see
    this.quick = quick.getContext("bitmaprenderer")!;
    this.shownCanvas = picture;
    this.picture = picture.getContext("2d", { alpha: false, willReadFrequently: software })!;
    this.ink = ink.getContext("2d", { willReadFrequently: software })!;
    this.observer = new ResizeObserver(() => {
      if (this.measure()) resized();
    });
    this.observer.observe(element);
    this.measure();
  }

  get shown(): boolean {
    return this.width > 0 && this.height > 0;
  }

  /** CSS pixels. */
  get area(): number {
    return this.width * this.height;
  }

  /** The picture that is seen. */
  get canvas(): HTMLCanvasElement {
    return this.shownCanvas;
  }

  /** Size in device pixels. */
  get pixels(): { width: number; height: number } {
    return {
      width: Math.max(1, Math.round(this.width * this.ratio)),
      height: Math.max(1, Math.round(this.height * this.ratio)),
    };
  }

  /** Takes over a rendered picture of a still view from the lower left corner of a canvas. */
  show(source: CanvasImageSource & { height: number }): void {
    const { canvas } = this.picture, { width, height } = this.pixels;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    this.picture.globalAlpha = 1 / (this.samples + 1);
    this.picture.drawImage(source, 0, source.height - height, width, height, 0, 0, width, height);
    this.bring(canvas);
  }

  /** Shows a rendered picture of a moving view, the lower left part of what is given. */
  showQuick(picture: ImageBitmap, size: { width: number; height: number }): void {
    const canvas = this.quick.canvas as HTMLCanvasElement;
    canvas.style.width = `${(100 * picture.width) / size.width}%`;
    canvas.style.height = `${(100 * picture.height) / size.height}%`;
    canvas.style.top = `${100 - (100 * picture.height) / size.height}%`;
    this.quick.transferFromImageBitmap(picture);
    this.bring(canvas);
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
    (this.quick.canvas as HTMLCanvasElement).remove();
    this.ink.canvas.remove();
    delete this.element.dataset["groundView"];
  }

  private bring(canvas: HTMLCanvasElement): void {
    this.shownCanvas = canvas;
    for (const each of [this.picture.canvas, this.quick.canvas as HTMLCanvasElement]) {
      each.style.visibility = each === canvas ? "" : "hidden";
    }
    ++this.samples;
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

  private measure(): boolean {
    const width = this.element.clientWidth, height = this.element.clientHeight;
    const ratio = Math.min(this.software ? 1 : 2, Math.max(1, window.devicePixelRatio || 1));
    if (width === this.width && height === this.height && ratio === this.ratio) return false;
    this.ratio = ratio;
    this.width = width;
    this.height = height;
    this.ink.canvas.width = Math.max(1, Math.round(width * this.inkRatio));
    this.ink.canvas.height = Math.max(1, Math.round(height * this.inkRatio));
    return true;
  }
}
