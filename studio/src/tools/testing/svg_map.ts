// A plain map for tests and development pages: the pen's events, and what tools show, as SVG. No terrain.
import type { GroundPointer, OverlayShape, PenTarget } from "../../viewport/types";

const kColours: { [role: string]: string } = {
  ink: "#e6eaee", guide: "#a3adb8", selected: "#ffd166", handle: "#ffffff", ridge: "#ff7b72", river: "#5aa9ff", wind: "#c9a3ff",
  height: "#7ee0a1", erase: "#ff6b81", coast: "#ffe08a", contour: "#e0a26e", mountain: "#8c6b4f", beach: "#e3cf8f", lagoon: "#5fc9c4",
  reef: "#d9708f", abyss: "#27518a",
};
const kSpace = "http://www.w3.org/2000/svg";

export class SvgMap {
  readonly svg = document.createElementNS(kSpace, "svg");
  private pen: PenTarget | null = null;
  private pressed = false;

  constructor(place: HTMLElement, readonly width_m: number) {
    place.append(this.svg);
    this.svg.style.width = this.svg.style.height = "100%";
    this.svg.style.touchAction = "none";
    this.svg.setAttribute("data-map", "");
    const on = (name: string, act: (event: PointerEvent) => void) => this.svg.addEventListener(name, act as EventListener);
    on("pointerdown", (event) => {
      this.svg.setPointerCapture(event.pointerId);
      this.pressed = true;
      this.pen?.down(this.at(event));
    });
    on("pointermove", (event) => {
      const path = event.getCoalescedEvents?.() ?? [event];
      if (this.pressed) this.pen?.move((path.length > 0 ? path : [event]).map((one) => this.at(one)));
      else this.pen?.hover?.(this.at(event));
    });
    on("pointerup", (event) => {
      this.pressed = false;
      this.pen?.up(this.at(event));
    });
    on("pointercancel", () => {
      this.pressed = false;
      this.pen?.cancel();
    });
    on("dblclick", (event) => this.pen?.double?.(this.at(event)));
  }

  private scale(): { pixel_m: number; left: number; top: number } {
    const box = this.svg.getBoundingClientRect();
    const pixel_m = this.width_m / Math.min(box.width, box.height);
    return { pixel_m, left: box.left + box.width / 2, top: box.top + box.height / 2 };
  }

  private at(event: PointerEvent): GroundPointer {
    const { pixel_m, left, top } = this.scale();
    const x = (event.clientX - left) * pixel_m, y = (top - event.clientY) * pixel_m;
    const device = event.pointerType === "pen" ? "pen" : event.pointerType === "touch" ? "touch" : "mouse";
    const pressure = device === "pen" ? event.pressure : 1;
    const height = 900 - Math.hypot(x, y) / 8;
    return { x, y, height, pressure, device, shift: event.shiftKey, ctrl: event.ctrlKey, alt: event.altKey, pixel_m };
  }

  setPen(pen: PenTarget | null): void {
    this.pen = pen;
  }

  setOverlayShapes(shapes: readonly OverlayShape[]): void {
    const { pixel_m } = this.scale();
    const half = this.width_m / 2;
    this.svg.setAttribute("viewBox", `${-half} ${-half} ${2 * half} ${2 * half}`);
    this.svg.replaceChildren(...shapes.flatMap((shape) => this.draw(shape, pixel_m)));
  }

  private draw(shape: OverlayShape, pixel_m: number): SVGElement[] {
    const colour = kColours[shape.role] ?? "#fff";
    const make = (name: string, attributes: { [name: string]: string | number }) => {
      const element = document.createElementNS(kSpace, name);
      for (const [key, value] of Object.entries({ fill: "none", stroke: colour, "data-role": shape.role, ...attributes })) {
        element.setAttribute(key, String(value));
      }
      return element;
    };
    const path = (points: readonly (readonly [number, number])[]) => points.map(([x, y]) => `${x},${-y}`).join(" ");
    if (shape.shape === "line") {
      const width = shape.width_m ?? (shape.width_px ?? 2) * pixel_m;
      const opacity = shape.width_m ? 0.25 : 1;
      return [make(shape.closed ? "polygon" : "polyline", {
        points: path(shape.points), "stroke-width": width, "stroke-linejoin": "round", "stroke-linecap": "round", opacity,
      })];
    }
    if (shape.shape === "area") return [make("polygon", { points: path(shape.points), fill: colour, stroke: "none", opacity: 0.15 })];
    if (shape.shape === "circle") {
      const circle = { cx: shape.at[0], cy: -shape.at[1], "stroke-width": 1.5 * pixel_m };
      const inner = shape.inner_m ? [make("circle", { ...circle, r: shape.inner_m, opacity: 0.5 })] : [];
      return [make("circle", { ...circle, r: shape.radius_m }), ...inner];
    }
    const dot = make("circle", {
      cx: shape.at[0], cy: -shape.at[1], r: (shape.handle ? 5 : 3.5) * pixel_m, fill: colour, stroke: "#14171a", "stroke-width": pixel_m,
    });
    if (!shape.label) return [dot];
    const text = make("text", { x: shape.at[0] + 9 * pixel_m, y: -shape.at[1] - 6 * pixel_m, fill: colour, stroke: "none", "font-size": 12 * pixel_m });
    text.textContent = shape.label;
    return [dot, text];
  }
}
