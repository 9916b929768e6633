// Sorts what pointers do over a view: strokes for the tool, moves of the view for navigation. The left button, the
// pen's tip and a single finger are the tool's; two fingers, other buttons, Alt and the space bar move the view. A
// second finger takes back the stroke that the first began; once a pen was seen, fingers only navigate, and while it
// is down they (a palm) do nothing.
import type { NavigationPreset } from "./options";

export type Way = "orbit" | "pan" | "dolly" | "fly";

export interface Mover {
  /** Of the 3D view: it can be turned. */
  readonly turns: boolean;
  begin(way: Way, x: number, y: number): void;
  move(way: Way, right_px: number, down_px: number): void;
  end(): void;
  /** Two fingers: their middle moved, they came `factor` times as near, and turned. */
  pinch(x: number, y: number, right_px: number, down_px: number, factor: number, turn_rad: number): void;
  zoom(x: number, y: number, factor: number): void;
  flyKeys(pressed: ReadonlySet<string>): void;
}

export interface Strokes {
  /** Whether a tool takes the left button. */
  active(): boolean;
  down(event: PointerEvent): boolean;
  move(events: PointerEvent[]): void;
  up(event: PointerEvent): void;
  cancel(): void;
  hover(event: PointerEvent | null): void;
  double(event: MouseEvent): void;
}

interface Finger {
  x: number;
  y: number;
}

let penSeen = false;
const flyKeyCodes = new Set(["KeyW", "KeyA", "KeyS", "KeyD", "KeyQ", "KeyE", "ShiftLeft", "ShiftRight"]);

export function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement
    && target.closest("input, textarea, select, [contenteditable], .cm-editor") !== null;
}

export class Gestures {
  private readonly abort = new AbortController();
  private readonly fingers = new Map<number, Finger>();
  private readonly pressed = new Set<string>();
  private stroke: number | null = null;
  private strokeByPen = false;
  private moving: { pointer: number; way: Way } | null = null;
  private last: Finger = { x: 0, y: 0 };
  private space = false;
  private over = false;

  constructor(
    private readonly element: HTMLElement,
    private readonly mover: Mover,
    private readonly strokes: Strokes,
    private readonly preset: () => NavigationPreset,
  ) {
    const signal = this.abort.signal;
    const on = <K extends keyof HTMLElementEventMap>(type: K, run: (event: HTMLElementEventMap[K]) => void): void =>
      element.addEventListener(type, run, { signal, passive: false });
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.moved(event));
    on("pointerup", (event) => this.up(event, false));
    on("pointercancel", (event) => this.up(event, true));
    on("lostpointercapture", (event) => this.up(event, true));
    on("pointerenter", () => (this.over = true));
    on("pointerleave", () => {
      this.over = false;
      if (this.stroke === null) this.strokes.hover(null);
    });
    on("wheel", (event) => this.wheel(event));
    on("dblclick", (event) => {
      if (event.button === 0 && !this.space) this.strokes.double(event);
    });
    on("keydown", (event) => this.steer(event));
    if (!element.hasAttribute("tabindex")) element.tabIndex = 0;
    on("contextmenu", (event) => event.preventDefault());
    window.addEventListener("keydown", (event) => this.key(event, true), { signal });
    window.addEventListener("keyup", (event) => this.key(event, false), { signal });
    window.addEventListener("blur", () => this.released(), { signal });
  }

  /** The view is being moved. */
  get navigating(): boolean {
    return this.moving !== null || this.fingers.size > 1;
  }

  dispose(): void {
    this.abort.abort();
  }

  /** Ends a stroke without a result: Escape, or another tool. */
  cancel(): void {
    if (this.stroke === null) return;
    this.stroke = null;
    this.strokes.cancel();
  }

  private place(event: MouseEvent): Finger {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    const at = this.place(event);
    if (event.pointerType === "pen") penSeen = true;
    if (event.pointerType === "touch" && this.touchDown(event, at)) return;
    if (this.moving !== null || this.stroke !== null) return;
    event.preventDefault();
    const way = this.wayOf(event);
    this.last = at;
    this.element.setPointerCapture(event.pointerId);
    if (way !== null) {
      this.moving = { pointer: event.pointerId, way };
      this.strokes.hover(null);
      this.mover.begin(way, at.x, at.y);
    } else if (event.button === 0 || event.button === 5) {
      if (!this.strokes.down(event)) return;
      this.stroke = event.pointerId;
      this.strokeByPen = event.pointerType === "pen";
    }
  }

  /** True: dealt with. */
  private touchDown(event: PointerEvent, at: Finger): boolean {
    if (this.stroke !== null && this.strokeByPen) return true;
    this.fingers.set(event.pointerId, at);
    if (this.fingers.size < 2) return false;
    this.cancel();
    if (this.moving !== null) this.mover.end();
    this.moving = null;
    this.element.setPointerCapture(event.pointerId);
    event.preventDefault();
    return true;
  }

  private wayOf(event: PointerEvent): Way | null {
    const { turns } = this.mover;
    const rest: Way = turns ? "orbit" : "pan";
    if (event.pointerType === "touch") return penSeen || !this.strokes.active() ? rest : null;
    if (event.pointerType === "pen" && event.button === 2) return "pan";
    if (event.button === 1) {
      if (!turns || event.shiftKey || this.preset() === "gaea") return "pan";
      return event.ctrlKey ? "dolly" : "orbit";
    }
    if (event.button === 2) return turns ? "fly" : null;
    if (event.button !== 0) return null;
    if (this.space) return "pan";
    if (event.altKey && turns) return "orbit";
    return this.strokes.active() ? null : event.shiftKey ? "pan" : rest;
  }

  private moved(event: PointerEvent): void {
    const at = this.place(event);
    if (this.fingers.has(event.pointerId) && this.fingers.size > 1) return this.pinched(event.pointerId, at);
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, at);
    if (this.moving !== null) {
      if (this.moving.pointer !== event.pointerId) return;
      this.mover.move(this.moving.way, at.x - this.last.x, at.y - this.last.y);
      this.last = at;
      return;
    }
    if (this.stroke !== null) {
      if (this.stroke !== event.pointerId) return;
      const all = typeof event.getCoalescedEvents === "function" ? event.getCoalescedEvents() : [];
      this.strokes.move(all.length > 0 ? all : [event]);
      return;
    }
    if (event.pointerType === "pen") penSeen = true;
    if (event.pointerType !== "touch") this.strokes.hover(event);
  }

  private pinched(pointer: number, at: Finger): void {
    const before = [...this.fingers.values()].slice(0, 2);
    this.fingers.set(pointer, at);
    const after = [...this.fingers.values()].slice(0, 2);
    const [a, b, c, d] = [before[0]!, before[1]!, after[0]!, after[1]!];
    const apart = (p: Finger, q: Finger): number => Math.max(8, Math.hypot(q.x - p.x, q.y - p.y));
    const angle = (p: Finger, q: Finger): number => Math.atan2(q.y - p.y, q.x - p.x);
    let turn = angle(c, d) - angle(a, b);
    if (turn > Math.PI) turn -= 2 * Math.PI;
    if (turn < -Math.PI) turn += 2 * Math.PI;
    const x = (c.x + d.x) / 2, y = (c.y + d.y) / 2;
    this.mover.pinch(x, y, x - (a.x + b.x) / 2, y - (a.y + b.y) / 2, apart(a, b) / apart(c, d), turn);
  }

  private up(event: PointerEvent, lost: boolean): void {
    if (this.fingers.delete(event.pointerId) && this.fingers.size >= 1) {
      if (this.fingers.size === 1) this.mover.end();
      return;
    }
    if (this.moving?.pointer === event.pointerId) {
      this.moving = null;
      this.mover.end();
    }
    if (this.stroke === event.pointerId) {
      this.stroke = null;
      if (lost) this.strokes.cancel();
      else this.strokes.up(event);
    }
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const { x, y } = this.place(event);
    const lines = event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1;
    const by = Math.max(-240, Math.min(240, event.deltaY * lines));
    this.mover.zoom(x, y, Math.exp(by * (event.ctrlKey ? 0.008 : 0.0016)));
  }

  /** By keys alone: arrows turn or pan, with Shift they pan, plus and minus zoom. */
  private steer(event: KeyboardEvent): void {
    if (event.target !== this.element || event.ctrlKey || event.altKey || event.metaKey) return;
    const arrow = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const factor = { "+": 0.8, "=": 0.8, "-": 1.25, PageUp: 0.8, PageDown: 1.25 }[event.key];
    const x = this.element.clientWidth / 2, y = this.element.clientHeight / 2;
    if (arrow !== undefined && this.moving === null) {
      const way: Way = this.mover.turns && !event.shiftKey ? "orbit" : "pan";
      this.mover.begin(way, x, y);
      this.mover.move(way, 48 * arrow[0]!, 48 * arrow[1]!);
      this.mover.end();
    } else if (factor !== undefined) this.mover.zoom(x, y, factor);
    else return;
    event.preventDefault();
  }

  private key(event: KeyboardEvent, down: boolean): void {
    if (isTyping(event.target)) return;
    if (event.code === "Space") {
      this.space = down;
      if (down && this.over) event.preventDefault();
    }
    if (!flyKeyCodes.has(event.code)) return;
    if (down) this.pressed.add(event.code);
    else this.pressed.delete(event.code);
    if (this.moving?.way === "fly") {
      event.preventDefault();
      event.stopPropagation();
      this.mover.flyKeys(this.pressed);
    }
  }

  private released(): void {
    this.space = false;
    this.pressed.clear();
  }
}
