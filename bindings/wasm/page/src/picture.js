// The projection on two or three chosen variables, drawn; rows over these alone can be dragged.
import { byId, draw, make, replace } from "./dom.js";
import { ask } from "./engine.js";
import { polygonOf, polyhedronOf } from "./clip.js";
import { niceStep, Plane } from "./plane.js";
import { axesOf, Space } from "./space.js";
import { showLabel, showRow } from "./rational.js";

const BEYOND = 3; // how far a region without end is drawn, in sizes of its vertices
const CHOICES = ["across", "up", "deep"];

// The projection of a point with all its coordinates.
const pick = (point, keep) => keep.map((name) => fractionValue(point[name]));
const fractionValue = (text) => {
  const [top, bottom = "1"] = text.split("/");
  return Number(top) / Number(bottom);
};

export class Picture {
  constructor(onMove) {
    this.onMove = onMove; // (row, delta, step): a row was dragged
    this.plane = new Plane(byId("plane"), "Projection on two variables", () => this.#drawPlane());
    this.space = new Space(byId("space"), "Projection on three variables");
    this.forget();
    for (const id of CHOICES) byId(id).addEventListener("change", () => this.#choose());
    byId("zoom-in").addEventListener("click", () => this.#zoom(1.4));
    byId("zoom-out").addEventListener("click", () => this.#zoom(1 / 1.4));
    byId("fit").addEventListener("click", () => {
      this.isFitted = false;
      this.#draw();
    });
  }

  // The next system is a different one: resets the view and the choice of variables.
  forget() {
    this.isFitted = false;
    this.chosen = null;
  }

  get keep() {
    return CHOICES.map((id) => byId(id).value).filter((name) => name !== "");
  }

  #zoom(factor) {
    if (this.keep.length === 3) this.space.zoomBy(factor);
    else this.plane.zoomBy(factor);
  }

  #choose() {
    this.chosen = CHOICES.map((id) => byId(id).value);
    this.isFitted = false;
    this.#ask();
  }

  show(text, answer) {
    this.text = text;
    this.answer = answer;
    this.#offer(answer.variables);
    this.#ask();
  }

  #offer(names) {
    const wanted = this.chosen ?? [names[0] ?? "", names[1] ?? "", names.length === 3 ? names[2] : ""];
    CHOICES.forEach((id, k) => {
      const none = k === 0 ? [] : [make("option", { value: "" }, "none")];
      replace(byId(id), none, names.map((name) => make("option", { value: name }, name)));
      byId(id).value = names.includes(wanted[k]) ? wanted[k] : k === 0 ? names[0] ?? "" : "";
    });
  }

  async #ask() {
    const keep = [...new Set(this.keep)], { text, answer } = this;
    if (keep.length === 0) {
      this.shape = null;
      return this.#draw();
    }
    if (answer.verdict !== "feasible") {
      this.shape = { rows: [], keep: keep.slice(0, 2), stop: answer.stop, answer, isEmpty: true };
      return this.#draw();
    }
    try {
      const shape = await ask("project", { text, keep });
      if (!shape) return;
      this.shape = { ...shape, keep: shape.variables, answer };
    } catch (error) {
      this.shape = null;
      byId("projection").textContent = error.message;
    }
    this.#draw();
  }

  #draw() {
    const inSpace = this.shape?.keep.length === 3;
    byId("plane").toggleAttribute("hidden", inSpace);
    byId("space").toggleAttribute("hidden", !inSpace);
    if (!this.shape) {
      replace(byId("plane"));
      byId("projection").textContent = "";
      return;
    }
    const { rows, keep, stop, isEmpty } = this.shape;
    byId("projection").textContent = isEmpty ? "" : rows.map((r) => showRow(r, keep)).join("\n") || "(everything)";
    if (stop !== "done") byId("projection").textContent += `\n(cut short: ${stop})`;
    if (inSpace) this.#drawSpace();
    else this.#drawPlane();
  }

  /* ---- two variables ------------------------------------------------------------------------- */

  // Rows of the system over the variables shown, with their coefficients there.
  #movable() {
    const { answer, keep } = this.shape, at = keep.map((name) => answer.variables.indexOf(name));
    return answer.rows.flatMap((row, i) => {
      const a = at.map((j) => row.doubles[j]), others = row.doubles.some((c, j) => c !== 0 && !at.includes(j));
      return others || a.every((c) => c === 0) ? [] : [{ i, row, a, b: row.rightDouble }];
    });
  }

  #drawPlane() {
    if (!this.shape || this.shape.keep.length === 3) return;
    const { rows, keep, answer, isEmpty } = this.shape, { plane } = this;
    if (isEmpty) return this.#drawNothing(keep);
    const flat = rows.map((row) => ({ ...row, doubles: [row.doubles[0], row.doubles[1] ?? 0] }));
    if (!this.isFitted) this.#fitPlane(flat, keep, answer);
    const region = polygonOf(flat, plane.frame);
    replace(byId("plane"), plane.grid([keep[0], keep[1] ?? ""]), this.#region(region, flat), this.#movable().map((m) => this.#line(m)), this.#points(keep, answer));
  }

  // Infeasible: draws the lines, which can be dragged until there is a solution.
  #drawNothing(keep) {
    const lines = this.#movable(), { plane } = this;
    if (!this.isFitted) plane.fit([[0, 0], ...lines.map(({ a: [p, q = 0], b }) => [(p * b) / (p * p + q * q), (q * b) / (p * p + q * q)])]);
    this.isFitted = true;
    const words = draw("text", { x: "50%", y: 20, "text-anchor": "middle", class: "nothing" }, "Nothing satisfies all rows.");
    replace(byId("plane"), plane.grid([keep[0], keep[1] ?? ""]), lines.map((m) => this.#line(m)), words);
  }

  #fitPlane(rows, keep, answer) {
    const far = 1e6, corners = polygonOf(rows, [-far, -far, far, far]);
    let points = corners.map((c) => [c.x, c.y]).filter((p) => p.every((c) => Math.abs(c) < far / 2));
    points.push(pick(answer.point, keep).concat(0).slice(0, 2));
    this.plane.fit(points);
    if (points.length < corners.length) this.plane.height = Math.max(this.plane.height * BEYOND, 8);
    this.isFitted = true;
  }

  #region(region, rows) {
    const corners = region.map((c) => this.plane.to([c.x, c.y])), n = region.length;
    const edges = region.map(({ row }, k) => {
      const [x1, y1] = corners[k], [x2, y2] = corners[(k + 1) % n];
      return row < 0 ? null : draw("line", { x1, y1, x2, y2, class: rows[row].relation === "<" ? "edge open" : "edge" });
    });
    return draw("g", { role: "img", "aria-label": `The projection: ${rows.length} rows` },
      draw("polygon", { points: corners.map((c) => c.join()).join(" "), class: "region" }), edges);
  }

  #points(keep, answer) {
    const marks = [["point", "a solution", answer.point], ["best", "the best point", answer.optimum?.point]].filter(([, , p]) => p);
    return marks.map(([kind, words, point]) => {
      const [cx, cy] = this.plane.to(pick(point, keep).concat(0).slice(0, 2));
      return draw("circle", { cx, cy, r: 5, class: kind }, draw("title", {}, words));
    });
  }

  // The line of a row across the visible area: it can be dragged, or moved by the arrow keys.
  #line({ i, row, a: [p, q = 0], b }) {
    const { plane } = this, [x0, y0, x1, y1] = plane.frame, size = Math.hypot(p, q);
    const at = [(x0 + x1) / 2, (y0 + y1) / 2], far = (p * at[0] + q * at[1] - b) / size;
    const foot = [at[0] - (far * p) / size, at[1] - (far * q) / size], reach = Math.hypot(x1 - x0, y1 - y0);
    const [from, to] = [-reach, reach].map((r) => plane.to([foot[0] - (r * q) / size, foot[1] + (r * p) / size]));
    const ends = { x1: from[0], y1: from[1], x2: to[0], y2: to[1] }, step = niceStep((size * plane.height) / 400);
    const move = (delta) => this.onMove(i, delta, step);
    const guide = draw("line", { ...ends, class: "guide" });
    const grip = draw("line", { ...ends, class: "grip", tabindex: "0", role: "slider", "data-handle": i, "aria-label": `${showLabel(row, i)}, right side`,
      "aria-valuenow": b, "aria-valuetext": row.right, "aria-orientation": Math.abs(p) > Math.abs(q) ? "horizontal" : "vertical" },
    draw("title", {}, `${showLabel(row, i)}: ${showRow(row, this.shape.answer.variables)}`));
    grip.addEventListener("pointerdown", (e) => this.#dragLine(e, { p, q, b, move, step }));
    grip.addEventListener("keydown", (e) => {
      const sign = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[e.key];
      if (!sign) return;
      e.preventDefault();
      this.refocus = i;
      move(sign * niceStep((size * plane.height) / 60));
    });
    const isFree = document.activeElement === document.body || byId("plane").contains(document.activeElement);
    if (this.refocus === i && isFree) queueMicrotask(() => grip.isConnected && grip.focus());
    return draw("g", {}, guide, grip);
  }

  // The pointer moves the row's right side; the line is drawn again and again meanwhile, so the window listens.
  #dragLine(e, { p, q, b, move, step }) {
    e.preventDefault();
    const value = (event) => {
      const [x, y] = this.plane.from(event);
      return p * x + q * y;
    };
    const begin = value(e);
    let moved = 0;
    const go = (event) => {
      const wanted = Math.round((value(event) - begin) / step) * step;
      if (wanted === moved) return;
      move(wanted - moved);
      moved = wanted;
    };
    const stop = () => {
      removeEventListener("pointermove", go);
      removeEventListener("pointerup", stop);
      removeEventListener("pointercancel", stop);
    };
    addEventListener("pointermove", go);
    addEventListener("pointerup", stop);
    addEventListener("pointercancel", stop);
  }

  /* ---- three variables ----------------------------------------------------------------------- */

  #drawSpace() {
    const { rows, keep, answer } = this.shape, style = getComputedStyle(document.documentElement);
    const [fill, line, dim] = ["--region", "--edge", "--dim"].map((name) => style.getPropertyValue(name).trim());
    const [low, high] = this.#boxOf(keep, answer);
    const faces = polyhedronOf(rows, low, high).map(({ points, row }) => ({ points, fill: row < 0 ? "transparent" : fill, line: row < 0 ? dim : line }));
    this.space.show(faces, axesOf(low, high, keep, dim), { keepFit: this.isFitted });
    this.isFitted = true;
  }

  // A little more than the box of the projection; where it is unbounded, the range around the point.
  #boxOf(keep, { box, point }) {
    const ends = keep.map((name) => [box[name].lower, box[name].upper].map((e) => (e.value === null ? null : fractionValue(e.value))));
    const known = ends.flat().filter((e) => e !== null).concat(pick(point, keep));
    const size = Math.max(1, Math.max(...known) - Math.min(...known)), at = pick(point, keep);
    const low = ends.map(([l], j) => (l === null ? at[j] - size : l)), high = ends.map(([, u], j) => (u === null ? at[j] + size : u));
    return [low.map((c, j) => c - 1e-3 * (high[j] - c + 1e-6)), high.map((c, j) => c + 1e-3 * (c - low[j] + 1e-6))];
  }
}
