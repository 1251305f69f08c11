// The plane as an SVG picture: coordinates to pixels and back, a grid, moving and zooming by pointer, wheel, pinch
// and keys. The owner of the view draws the contents; `onview` notifies it of changes.
import { draw } from "./dom.js";

const KEYS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };

export class Plane {
  constructor(svg, label, onview) {
    this.svg = svg;
    this.onview = onview;
    this.centre = [0, 0];
    this.height = 10; // [units] of what is seen
    this.pointers = new Map();
    svg.setAttribute("tabindex", "0");
    svg.setAttribute("role", "group");
    svg.setAttribute("aria-label", `${label}. Arrow keys move the view, plus and minus zoom.`);
    svg.addEventListener("pointerdown", (e) => this.#hold(e));
    svg.addEventListener("pointermove", (e) => this.#drag(e));
    for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, (e) => this.pointers.delete(e.pointerId));
    svg.addEventListener("wheel", (e) => this.#wheel(e), { passive: false });
    svg.addEventListener("keydown", (e) => e.target === svg && this.#key(e));
    new ResizeObserver(() => this.onview()).observe(svg);
  }

  get pixels() {
    return [this.svg.clientWidth || 300, this.svg.clientHeight || 300];
  }

  get scale() {
    return this.pixels[1] / this.height;
  }

  // [least x, least y, greatest x, greatest y] of the visible area.
  get frame() {
    const [w, h] = this.pixels, x = w / this.scale / 2, y = h / this.scale / 2;
    return [this.centre[0] - x, this.centre[1] - y, this.centre[0] + x, this.centre[1] + y];
  }

  to([x, y]) {
    const [w, h] = this.pixels;
    return [w / 2 + (x - this.centre[0]) * this.scale, h / 2 - (y - this.centre[1]) * this.scale];
  }

  from(event) {
    const r = this.svg.getBoundingClientRect(), [w, h] = this.pixels;
    return [this.centre[0] + (event.clientX - r.left - w / 2) / this.scale, this.centre[1] - (event.clientY - r.top - h / 2) / this.scale];
  }

  // Shows all of these points, with a margin.
  fit(points) {
    const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]), [w, h] = this.pixels;
    if (points.length === 0) return;
    const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.centre = [(x0 + x1) / 2, (y0 + y1) / 2];
    this.height = 1.3 * Math.max(y1 - y0, ((x1 - x0) * h) / w, 1e-6) || 1;
    if (x1 - x0 < 1e-9 && y1 - y0 < 1e-9) this.height = 4;
  }

  zoomBy(factor, about = this.centre) {
    this.centre = this.centre.map((c, j) => about[j] + (c - about[j]) / factor);
    this.height = Math.min(1e9, Math.max(1e-9, this.height / factor));
    this.onview();
  }

  #hold(e) {
    if (e.target.closest("[data-handle]")) return;
    this.svg.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, this.from(e));
  }

  // One pointer moves the view, two zoom it.
  #drag(e) {
    if (!this.pointers.has(e.pointerId)) return;
    const held = this.pointers.get(e.pointerId), now = this.from(e);
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== e.pointerId)[1];
      const factor = Math.hypot(now[0] - other[0], now[1] - other[1]) / Math.hypot(held[0] - other[0], held[1] - other[1]);
      this.zoomBy(factor || 1, other);
      this.pointers.set(e.pointerId, this.from(e));
      return;
    }
    this.centre = this.centre.map((c, j) => c + held[j] - now[j]);
    this.onview();
  }

  #wheel(e) {
    e.preventDefault();
    this.zoomBy(Math.exp(-e.deltaY / 500), this.from(e));
  }

  #key(e) {
    if (KEYS[e.key]) {
      this.centre = this.centre.map((c, j) => c + KEYS[e.key][j] * this.height);
      this.onview();
    } else if (e.key === "+" || e.key === "=") this.zoomBy(1.25);
    else if (e.key === "-") this.zoomBy(0.8);
    else return;
    e.preventDefault();
  }

  // Lines at round numbers, with these at the edge.
  grid(names = ["", ""]) {
    const [x0, y0, x1, y1] = this.frame, [w, h] = this.pixels, step = niceStep(80 / this.scale), marks = [];
    for (let x = Math.ceil(x0 / step) * step; x <= x1; x += step) {
      const [at] = this.to([x, 0]);
      marks.push(draw("line", { x1: at, x2: at, y1: 0, y2: h, class: nearZero(x, step) ? "axis" : "grid" }));
      marks.push(draw("text", { x: at + 3, y: h - 5, class: "tick" }, tick(x, step)));
    }
    for (let y = Math.ceil(y0 / step) * step; y <= y1; y += step) {
      const at = this.to([0, y])[1];
      marks.push(draw("line", { y1: at, y2: at, x1: 0, x2: w, class: nearZero(y, step) ? "axis" : "grid" }));
      if (at < h - 24) marks.push(draw("text", { x: 4, y: at - 3, class: "tick" }, tick(y, step)));
    }
    marks.push(draw("text", { x: w - 8, y: h - 22, class: "name", "text-anchor": "end" }, names[0]));
    marks.push(draw("text", { x: 8, y: 18, class: "name" }, names[1]));
    return draw("g", { "aria-hidden": "true" }, marks);
  }
}

const nearZero = (x, step) => Math.abs(x) < step / 2;
const tick = (x, step) => String(Number(x.toFixed(Math.max(0, -Math.floor(Math.log10(step))))));

// The least of 1, 2 or 5 times a power of ten that is at least the argument.
export function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].find((m) => m * power >= least) * power;
}
