// Two frames that are dragged and thrown until they meet.
import { byId, draw, make, replace, tell } from "./dom.js";
import { ask } from "./engine.js";
import { Plane } from "./plane.js";
import { Space } from "./space.js";
import { hullOf } from "./clip.js";
import { brief } from "./rational.js";

const GRID = 64; // positions are multiples of 1/64: exact, and short as fractions
const WALL = 5; // |x|, |y|, |z| stay below [units]
const CALM = matchMedia("(prefers-reduced-motion: reduce)");

const snap = (x) => Math.round(x * GRID) / GRID;
const plus = (p, q) => p.map((c, j) => c + q[j]);

const START = {
  2: { A: { type: "cuboid", orig: [-3, -1.5], comp: [[2, 0.5], [-0.5, 1.5]] }, B: { type: "simplex", orig: [1, 0], comp: [[2, 0.5], [0.5, 2]] } },
  3: { A: { type: "cuboid", orig: [-3, -1, -1], comp: [[2, 0.5, 0], [-0.5, 1.5, 0], [0, 0.25, 2]] }, B: { type: "simplex", orig: [1, 0, -1], comp: [[2, 0, 0.5], [0.5, 2, 0], [0.5, 0.5, 2]] } },
};

let dim = 2, bodies, found, plane, space, flight = 0;

/* ---- corners and faces ----------------------------------------------------------------------- */

function cornersOf({ type, orig, comp }) {
  if (type === "simplex") return [orig, ...comp.map((edge) => plus(orig, edge))];
  let corners = [orig];
  for (const edge of comp) corners = [...corners, ...corners.map((p) => plus(p, edge))];
  return corners;
}

// The outline of a frame in the plane.
function outline(body) {
  const { orig, comp: [u, v], type } = body;
  return type === "simplex" ? [orig, plus(orig, u), plus(orig, v)] : [orig, plus(orig, u), plus(plus(orig, u), v), plus(orig, v)];
}

/* ---- drawing --------------------------------------------------------------------------------- */

function polygon(points, attributes) {
  return draw("polygon", { points: points.map((p) => plane.to(p).join()).join(" "), ...attributes });
}

function drawBody(name) {
  const body = bodies[name], shape = polygon(outline(body), { class: `body ${name}`, "data-handle": name, tabindex: "0", role: "application",
    "aria-label": `${body.type === "simplex" ? "Triangle" : "Parallelogram"} ${name} at ${body.orig.join(", ")}. Arrow keys move it; with Shift they throw it.` });
  shape.addEventListener("pointerdown", (e) => drag(e, name));
  shape.addEventListener("keydown", (e) => moveByKey(e, name));
  const tips = body.comp.map((edge, k) => {
    const [cx, cy] = plane.to(plus(body.orig, edge)), tip = draw("circle", { cx, cy, r: 8, class: `tip ${name}`, "data-handle": `${name}${k}` });
    tip.addEventListener("pointerdown", (e) => stretch(e, name, k));
    return tip;
  });
  const [x, y] = plane.to(outline(body).reduce(plus).map((c) => c / outline(body).length));
  return draw("g", {}, shape, draw("text", { x, y, class: "letter", "aria-hidden": "true" }, name), tips);
}

function drawBetween() {
  if (!found) return null;
  if (found.common) return polygon(found.common, { class: "common" });
  if (!found.ends) return null;
  const [[x1, y1], [x2, y2]] = found.ends.map((p) => plane.to(p));
  return draw("g", {}, separator(found.row), draw("line", { x1, y1, x2, y2, class: "distance" }));
}

function separator({ coefficients: [p, q], right }) {
  const size = Math.hypot(p, q), foot = [(p * right) / size / size, (q * right) / size / size];
  const [[x1, y1], [x2, y2]] = [-30, 30].map((r) => plane.to([foot[0] - (r * q) / size, foot[1] + (r * p) / size]));
  return draw("line", { x1, y1, x2, y2, class: "separator" });
}

function paint() {
  byId("yard").toggleAttribute("hidden", dim === 3);
  byId("yard3").toggleAttribute("hidden", dim === 2);
  if (dim === 3) return paintSpace();
  const focused = document.activeElement?.dataset?.handle;
  replace(byId("yard"), plane.grid(), polygon([[-WALL, -WALL], [WALL, -WALL], [WALL, WALL], [-WALL, WALL]], { class: "wall" }), drawBody("A"), drawBody("B"), drawBetween());
  if (focused) byId("yard").querySelector(`[data-handle="${focused}"]`)?.focus();
}

function paintSpace() {
  const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(name).trim();
  const faces = ["A", "B"].flatMap((name) => hullOf(cornersOf(bodies[name])).map((points) => ({ points, fill: colour(`--body-${name.toLowerCase()}`), line: colour("--edge") })));
  const common = found?.common?.length > 3 ? hullOf(found.common).map((points) => ({ points, fill: colour("--common"), line: colour("--edge") })) : [];
  const edges = found?.ends ? [{ points: found.ends, line: colour("--bad"), width: 2 }] : [];
  const walls = Array.from({ length: 8 }, (_, k) => [0, 1, 2].map((j) => ((k >> j) & 1 ? WALL : -WALL)));
  for (const [i, p] of walls.entries()) for (const [j, q] of walls.entries()) if (i < j && p.filter((c, k) => c !== q[k]).length === 1) edges.push({ points: [p, q], line: colour("--dim") });
  space.show([...faces, ...common], edges, { keepFit: true });
}

/* ---- questions ------------------------------------------------------------------------------- */

const size = (length, measure) => `${length.toPrecision(6).replace(/\.?0+$/, "")} (exactly √(${brief(measure)}))`;

async function test() {
  const about = { a: { ...bodies.A }, b: { ...bodies.B }, moving: false };
  const answer = await ask("frames", about).catch((error) => say(error.message));
  if (!answer || flight !== 0) return;
  found = answer;
  if (answer.meet) say("They meet.", `Depth ${size(answer.length, answer.measure)}; the common part has ${answer.common.length} corners.`, "infeasible");
  else say("They are apart.", `Distance ${size(answer.length, answer.measure)}; the dashed line is between them, and proves it.`, "feasible");
  paint();
}

function say(words, more = "", kind = "") {
  replace(byId("contact"), words, more ? make("small", {}, ` ${more}`) : null);
  byId("contact").className = `verdict ${kind}`;
  tell(`${words} ${more}`);
}

/* ---- dragging -------------------------------------------------------------------------------- */

function follow(e, moved, done) {
  e.preventDefault();
  e.stopPropagation();
  flight = 0;
  const go = (event) => moved(plane.from(event), event.timeStamp);
  const stop = () => {
    removeEventListener("pointermove", go);
    removeEventListener("pointerup", stop);
    removeEventListener("pointercancel", stop);
    done();
  };
  addEventListener("pointermove", go);
  addEventListener("pointerup", stop);
  addEventListener("pointercancel", stop);
}

function drag(e, name) {
  const begin = plane.from(e), orig = bodies[name].orig;
  let path = [{ at: begin, time: e.timeStamp }];
  follow(e, (at, time) => {
    path = [...path.filter((p) => time - p.time < 120), { at, time }];
    bodies[name].orig = inside(name, orig.map((c, j) => snap(c + at[j] - begin[j])));
    paint();
    test();
  }, () => {
    const [first, last] = [path[0], path.at(-1)], seconds = (last.time - first.time) / 1000;
    const speed = seconds > 0.02 ? last.at.map((c, j) => (c - first.at[j]) / seconds) : [0, 0];
    if (Math.hypot(...speed) > 1.5) throwBody(name, speed);
  });
}

function stretch(e, name, k) {
  const { orig, comp } = bodies[name];
  follow(e, (at) => {
    comp[k] = at.map((c, j) => snap(Math.max(-WALL, Math.min(WALL, c)) - orig[j]));
    paint();
    test();
  }, () => {});
}

// The place of the origin at which all of the frame is between the walls.
function inside(name, orig) {
  const corners = cornersOf({ ...bodies[name], orig });
  return orig.map((c, j) => {
    const low = Math.min(...corners.map((p) => p[j])), high = Math.max(...corners.map((p) => p[j]));
    return c + Math.max(0, -WALL - low) + Math.min(0, WALL - high);
  });
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function moveByKey(e, name) {
  const way = ARROWS[e.key];
  if (!way) return;
  e.preventDefault();
  if (e.shiftKey) return throwBody(name, way.map((c) => 4 * c));
  nudge(name, way.map((c) => c / 4));
}

function nudge(name, by) {
  flight = 0;
  bodies[name].orig = inside(name, bodies[name].orig.map((c, j) => snap(c + by[j])));
  paint();
  test();
}

/* ---- throwing -------------------------------------------------------------------------------- */

// How far it flies at that speed until it reaches a wall, on the grid; and the speed behind the wall.
function flightOf(name, speed) {
  const corners = cornersOf(bodies[name]);
  let time = Infinity, wall = 0;
  speed.forEach((v, j) => {
    if (v === 0) return;
    const room = v > 0 ? WALL - Math.max(...corners.map((p) => p[j])) : Math.min(...corners.map((p) => p[j])) + WALL;
    if (room / Math.abs(v) < time) [time, wall] = [room / Math.abs(v), j];
  });
  return { shift: speed.map((v) => snap(v * time)), seconds: time, after: speed.map((v, j) => 0.85 * (j === wall ? -v : v)) };
}

// A frame flies, from wall to wall, until it meets the other one or is slow. Before each stretch the library says
// whether, and at which time of it, they meet: nothing is missed between two pictures.
async function throwBody(name, speed) {
  const mine = (flight = performance.now()), other = name === "A" ? "B" : "A";
  found = null;
  say(`${name} flies.`);
  for (let k = 0; Math.hypot(...speed) > 0.6 && k < 40; k++) {
    const { shift, seconds, after } = flightOf(name, speed), orig = bodies[name].orig;
    if (shift.some((c) => c !== 0)) {
      const moving = { ...bodies[name], vel: shift };
      const answer = await ask("frames", { a: bodies[other], b: moving, moving: true }, "flight").catch(() => null);
      if (flight !== mine || !answer) return;
      const until = answer.meet ? answer.time[0] : 1;
      await animate(mine, name, orig, shift, until, seconds);
      if (flight !== mine) return;
      if (answer.meet) return land(name, answer);
      bodies[name].orig = inside(name, orig.map((c, j) => c + shift[j]));
    }
    speed = after;
  }
  flight = 0;
  test();
}

function animate(mine, name, orig, shift, until, seconds) {
  const begin = performance.now(), lasts = 1000 * Math.max(seconds, CALM.matches ? 0 : 0.02) * until;
  return new Promise((resolve) => {
    const step = (now) => {
      if (flight !== mine) return resolve();
      const t = lasts > 0 && !CALM.matches ? Math.min(1, Math.max(0, now - begin) / lasts) * until : until;
      bodies[name].orig = orig.map((c, j) => c + t * shift[j]);
      paint();
      if (t >= until) resolve();
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  });
}

function land(name, { exact }) {
  flight = 0;
  const at = Object.entries(exact).filter(([v]) => v !== "t").map(([v, { lower, upper }]) => `${v} from ${brief(lower.value)} to ${brief(upper.value)}`);
  say("They meet.", `First at t = ${brief(exact.t.lower.value)} of this flight. Over all of it they share points with ${at.join(", ")}.`, "infeasible");
  paint();
}

/* ---- controls -------------------------------------------------------------------------------- */

function begin(newDim) {
  dim = newDim;
  flight = 0;
  found = null;
  bodies = structuredClone(START[dim]);
  byId("shape-a").value = bodies.A.type;
  byId("shape-b").value = bodies.B.type;
  byId("deep-buttons").toggleAttribute("hidden", dim === 2);
  paint();
  test();
}

export function startFrames() {
  plane = new Plane(byId("yard"), "The yard with the two frames", paint);
  new ResizeObserver(() => {
    const [w, h] = plane.pixels;
    plane.height = 2.2 * WALL * Math.max(1, h / w); // all of the yard
    paint();
  }).observe(byId("yard"));
  space = new Space(byId("yard3"), "The two frames in space");
  space.centre = [0, 0, 0];
  space.size = 2.4 * WALL;
  for (const name of ["A", "B"])
    byId(`shape-${name.toLowerCase()}`).addEventListener("change", (e) => {
      bodies[name].type = e.target.value;
      bodies[name].orig = inside(name, bodies[name].orig);
      nudge(name, Array(dim).fill(0));
    });
  for (const choice of document.querySelectorAll("[name=dim]")) choice.addEventListener("change", () => begin(Number(choice.value)));
  for (const button of document.querySelectorAll("[data-nudge]")) {
    const [x, y, z] = button.dataset.nudge.split(",").map(Number);
    button.addEventListener("click", () => nudge("B", [x / 4, y / 4, z / 4].slice(0, dim)));
  }
  byId("throw").addEventListener("click", () => throwBody("B", Array.from({ length: dim }, () => 8 * Math.random() - 4)));
  byId("again").addEventListener("click", () => begin(dim));
  bodies = structuredClone(START[2]);
  return () => (found ? paint() : begin(dim));
}
