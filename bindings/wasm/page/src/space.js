// Faces in space on a canvas, turned by dragging or by the arrow keys; the far ones are painted first.

const TURN = 0.01, STEP = 0.12; // [radians per pixel], [radians per key]

export class Space {
  constructor(canvas, label) {
    this.canvas = canvas;
    this.turn = -0.6;
    this.tilt = 0.45;
    this.zoom = 1;
    this.faces = [];
    this.edges = [];
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-label", `${label}. Arrow keys turn it, plus and minus zoom.`);
    canvas.addEventListener("pointerdown", (e) => this.#hold(e));
    canvas.addEventListener("pointermove", (e) => this.#drag(e));
    canvas.addEventListener("wheel", (e) => this.#wheel(e), { passive: false });
    canvas.addEventListener("keydown", (e) => this.#key(e));
    new ResizeObserver(() => this.paint()).observe(canvas);
  }

  // faces: [{points, fill, line}]; edges: [{points: [p, q], line, label}]; fits the view to all points, unless told.
  show(faces, edges = [], { keepFit = false } = {}) {
    this.faces = faces;
    this.edges = edges;
    if (!keepFit || !this.centre) this.#fit();
    this.paint();
  }

  #fit() {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const { points } of [...this.faces, ...this.edges])
      for (const p of points)
        for (let j = 0; j < 3; j++) {
          low[j] = Math.min(low[j], p[j]);
          high[j] = Math.max(high[j], p[j]);
        }
    if (!(low[0] <= high[0])) return;
    this.centre = low.map((c, j) => (c + high[j]) / 2);
    this.size = Math.hypot(...high.map((c, j) => c - low[j])) || 1;
  }

  #hold(e) {
    this.canvas.setPointerCapture(e.pointerId);
    this.held = [e.clientX, e.clientY];
  }

  #drag(e) {
    if (!this.held || !this.canvas.hasPointerCapture(e.pointerId)) return;
    this.turnBy((e.clientX - this.held[0]) * TURN, (e.clientY - this.held[1]) * TURN);
    this.held = [e.clientX, e.clientY];
  }

  #wheel(e) {
    e.preventDefault();
    this.zoomBy(Math.exp(-e.deltaY / 500));
  }

  #key(e) {
    const turns = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, -STEP], ArrowDown: [0, STEP] };
    if (turns[e.key]) this.turnBy(...turns[e.key]);
    else if (e.key === "+") this.zoomBy(1.2);
    else if (e.key === "-") this.zoomBy(1 / 1.2);
    else return;
    e.preventDefault();
  }

  turnBy(turn, tilt) {
    this.turn += turn;
    this.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.tilt + tilt));
    this.paint();
  }

  zoomBy(factor) {
    this.zoom = Math.max(0.2, Math.min(20, this.zoom * factor));
    this.paint();
  }

  // x to the right, y up, and how near.
  #project([x, y, z]) {
    const [a, b, c] = [x - this.centre[0], y - this.centre[1], z - this.centre[2]];
    const cosTurn = Math.cos(this.turn), sinTurn = Math.sin(this.turn), cosTilt = Math.cos(this.tilt), sinTilt = Math.sin(this.tilt);
    const u = cosTurn * a - sinTurn * b, v = sinTurn * a + cosTurn * b;
    return [u, cosTilt * c + sinTilt * v, sinTilt * c - cosTilt * v];
  }

  paint() {
    const { canvas } = this, ratio = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
    if (w === 0 || !this.centre) return;
    canvas.width = w * ratio;
    canvas.height = h * ratio;
    const g = canvas.getContext("2d"), scale = (0.85 * this.zoom * Math.min(w, h)) / this.size;
    g.scale(ratio, ratio);
    g.lineJoin = "round";
    const at = (p) => {
      const [x, y, near] = this.#project(p);
      return [w / 2 + scale * x, h / 2 - scale * y, near];
    };
    const things = [...this.faces, ...this.edges].map((thing) => {
      const points = thing.points.map(at);
      return { ...thing, points, near: points.reduce((sum, p) => sum + p[2], 0) / points.length };
    });
    things.sort((a, b) => a.near - b.near);
    for (const thing of things) this.#paintOne(g, thing);
  }

  #paintOne(g, { points, fill, line, label, width = 1 }) {
    g.beginPath();
    points.forEach(([x, y], k) => (k === 0 ? g.moveTo(x, y) : g.lineTo(x, y)));
    if (fill) {
      g.closePath();
      g.fillStyle = fill;
      g.fill();
    }
    if (line) {
      g.strokeStyle = line;
      g.lineWidth = width;
      g.stroke();
    }
    if (label) {
      g.fillStyle = line;
      g.font = "14px system-ui, sans-serif";
      g.fillText(label, points.at(-1)[0] + 4, points.at(-1)[1] - 4);
    }
  }
}

// The three axes of a box, from its least corner.
export function axesOf(low, high, names, line) {
  return [0, 1, 2].map((j) => ({ points: [low, low.map((c, k) => (k === j ? high[k] + 0.12 * (high[k] - low[k]) : c))], line, label: names[j] }));
}
