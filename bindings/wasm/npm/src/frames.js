// Two frames: cuboids or simplices, still or moving. As in the lines that `fmb intersect` reads:
// {type, orig, comp, vel}, or {type, points}.
import { FmbError, must } from "./memory.js";
import { number, query, VERDICTS } from "./solver.js";
import { System, exact } from "./system.js";
import { bounds, readGenerators } from "./questions.js";

const SHAPES = { cuboid: 0, simplex: 1, triangle: 1, tetrahedron: 1 };
const BY_CORNERS = 2; // added to a shape
const CONTACTS = { closed: 0, open: 1 };
const NORMS = { euclidean: 0, max: 1 };

function wordIn(table, word, what) {
  if (word in table) return table[word];
  throw new FmbError(`${JSON.stringify(word)} is no ${what}: ${Object.keys(table).join(", ")}`, "argument");
}

// Origin, axes and shape of a frame in either form.
function partsOf(frame) {
  const shape = wordIn(SHAPES, frame.type, "type of a frame");
  if (frame.points) return { shape: shape + BY_CORNERS, origin: frame.points[0], axes: frame.points.slice(1) };
  return { shape, origin: frame.orig, axes: frame.comp };
}

// Both frames side by side, as an array of C.
function framesIn(memory, s, pair) {
  const { places } = memory, size = places.fmb_frame, at = s.zeros(2 * size);
  pair.forEach((frame, k) => {
    const { shape, origin, axes } = partsOf(frame), dim = origin.length;
    if (axes.some((axis) => axis.length !== dim)) throw new FmbError(`frame ${k}: an axis is not of ${dim} numbers`, "argument");
    const fields = {
      shape, dim, naxes: axes.length, origin: s.doubles(origin), axes: s.doubles(axes.flat()),
      speed: frame.vel ? s.doubles(frame.vel) : 0,
    };
    for (const [name, value] of Object.entries(fields))
      memory.view.setInt32(at + k * size + places[`fmb_frame.${name}`], value, true);
  });
  return at;
}

function intervals(memory, at, n) {
  const ends = memory.doubles(at, 2 * n);
  return Array.from({ length: n }, (_, i) => [ends[2 * i], ends[2 * i + 1]]);
}

// Do they meet, where, when? Ends are doubles, rounded outward; the verdict is exact.
export function intersect(memory, a, b, { contact = "closed" } = {}) {
  const { c } = memory, dim = partsOf(a).origin.length, naxes = partsOf(b).axes.length;
  return memory.scope((s) => {
    const how = s.structure("fmb_pair_options", { contact: wordIn(CONTACTS, contact, "contact"), tightest: 1 }), out = s.out();
    const at = framesIn(memory, s, [a, b]);
    must(memory, c.fmb_pair_new(dim, how, 0, out));
    const k = memory.int(out);
    try {
      const verdict = s.zeros(4), world = s.zeros(16 * dim), inside = s.zeros(16 * Math.max(naxes, 1));
      const time = s.zeros(16), witness = s.zeros(8 * dim);
      const answers = s.structure("fmb_pair_answers", { verdict, world, time, witness, ...(naxes <= dim && { inside }) });
      must(memory, c.fmb_pair_test(k, 1, at, at + memory.places.fmb_frame, answers),
        () => memory.textAt(c.fmb_pair_trouble(k)));
      const word = VERDICTS[memory.int(verdict)];
      if (word !== "feasible") return { meet: word === "unknown" ? null : false };
      return {
        meet: true,
        world: intervals(memory, world, dim),
        inside: naxes <= dim ? intervals(memory, inside, naxes) : null,
        time: a.vel || b.vel ? intervals(memory, time, 1)[0] : null,
        witness: Array.from(memory.doubles(witness, dim)),
      };
    } finally {
      c.fmb_pair_free(k);
    }
  });
}

// A frame with its numbers as exact texts, in the form of a line that `fmb intersect` reads.
function exactFrame({ type, ...parts }) {
  const texts = (list) => list.map((x) => (Array.isArray(x) ? texts(x) : exact(x)));
  const given = Object.entries(parts).filter(([, list]) => list).map(([name, list]) => [name, texts(list)]);
  return { type: type === "triangle" ? "simplex" : type, ...Object.fromEntries(given) };
}

// The system that says where they meet: the point x1, x2, ..., coordinates in both frames, the time. Numbers may be
// texts here, "3/5".
export function systemOfFrames(memory, a, b, { contact = "closed" } = {}) {
  const { c } = memory;
  return memory.scope((s) => {
    const at = s.text(JSON.stringify({ A: exactFrame(a), B: exactFrame(b) })), length = s.length, out = s.out();
    const where = s.structure("fmb_where");
    must(memory, c.fmb_frame_reader_from_text(at, length, 0, out));
    const reader = memory.int(out);
    try {
      must(memory, c.fmb_frame_reader_next(reader, out, where), () => memory.written((to, size) => c.fmb_where_text(where, 0, to, size)));
      must(memory, c.fmb_system_from_line(memory.int(out), wordIn(CONTACTS, contact, "contact"), 0, out));
      return new System(memory, memory.int(out));
    } finally {
      c.fmb_frame_reader_free(reader);
    }
  });
}

// The tightest intervals of x1, x2, ... and of the time t as fractions; null if they do not meet.
export function exactBox(memory, a, b, { contact, ...options } = {}) {
  const system = systemOfFrames(memory, a, b, { contact }), dim = partsOf(a).origin.length;
  const wanted = system.variables.filter((name, j) => j < dim || name === "t");
  try {
    return bounds(memory, system, wanted, options);
  } finally {
    system.free();
  }
}

// Reads and frees the object that a call about two frames returns.
function asked(memory, a, b, options, call, read, free) {
  let out;
  return query(memory, options, (v, result, s) => {
    out = s.out();
    return call(v, framesIn(memory, s, [a, b]), out, result);
  }, () => {
    const at = memory.int(out);
    if (at === 0) return {};
    try {
      return read(at);
    } finally {
      free(at);
    }
  });
}

const vector = (memory, dim, text) => Array.from({ length: dim }, (_, j) => number(memory, (to, size) => text(j, to, size)));

// The distance, and the nearest points. measure: the distance, or its square (Euclidean).
export function distance(memory, a, b, { norm = "euclidean", ...options } = {}) {
  const { c } = memory, dim = partsOf(a).origin.length;
  return asked(memory, a, b, options,
    (v, f, out, result) => c.fmb_distance(v, f, wordIn(NORMS, norm, "norm"), out, result),
    (p) => ({
      length: c.fmb_proximity_length(p),
      measure: number(memory, (to, size) => c.fmb_proximity_measure_text(p, to, size)),
      points: [0, 1].map((which) => vector(memory, dim, (j, to, size) => c.fmb_proximity_point_text(p, which, j, to, size))),
      time: number(memory, (to, size) => c.fmb_proximity_time_text(p, to, size)),
    }), c.fmb_proximity_free);
}

// The penetration depth, and the translation of the second frame that separates them.
export function depth(memory, a, b, { norm = "euclidean", ...options } = {}) {
  const { c } = memory, dim = partsOf(a).origin.length;
  return asked(memory, a, b, options,
    (v, f, out, result) => c.fmb_depth(v, f, wordIn(NORMS, norm, "norm"), out, result),
    (p) => ({
      length: c.fmb_proximity_length(p),
      measure: number(memory, (to, size) => c.fmb_proximity_measure_text(p, to, size)),
      shift: vector(memory, dim, (j, to, size) => c.fmb_proximity_shift_text(p, j, to, size)),
    }), c.fmb_proximity_free);
}

// A separating row: the first frame satisfies it, the second violates it.
export function separate(memory, a, b, { contact = "closed", ...options } = {}) {
  const { c } = memory;
  return asked(memory, a, b, options,
    (v, f, out, result) => c.fmb_separate(v, f, wordIn(CONTACTS, contact, "contact"), out, result),
    (at) => ({ row: new System(memory, at).row(0) }), () => {});
}

// Vertices of the intersection; in the plane in their order around it.
export function common(memory, a, b, options = {}) {
  const { c } = memory;
  return asked(memory, a, b, options, (v, f, out, result) => c.fmb_common(v, f, out, result),
    (g) => ({ vertices: readGenerators(memory, g).map((one) => one.point) }), c.fmb_generators_free);
}
