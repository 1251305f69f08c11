// The page's calls of the library: each task takes and returns plain data, as it runs in a worker.
import { FmbError, loadNow } from "../../npm/src/index.js";

const PATIENCE = { maxSeconds: 10, maxBytes: 500e6 };
const fmb = loadNow();

const plain = (data) => JSON.parse(JSON.stringify(data));
const double = (fraction) => (fraction === null ? null : Number(fraction));

// Rows with their coefficients by variable, as texts and as doubles.
function describe(system) {
  const n = system.variables.length;
  return {
    variables: system.variables,
    rows: system.rows.map(({ terms, relation, right, label }) => {
      const texts = Array(n).fill("0"), doubles = Array(n).fill(0);
      for (const { variable, coefficient } of terms) {
        texts[variable] = String(coefficient);
        doubles[variable] = double(coefficient);
      }
      return { texts, doubles, relation, right: String(right), rightDouble: double(right), label };
    }),
  };
}

function box(system) {
  const { box } = fmb.bounds(system, undefined, PATIENCE);
  return box && plain(box);
}

// Is the proof accepted, and what are the rows of the claim of that kind?
function proved(system, proof, kind) {
  const claim = proof.claims.find((c) => c.kind === kind);
  return {
    accepted: fmb.check(system, proof.text).accepted,
    text: proof.text,
    multipliers: claim ? plain(claim.multipliers) : [],
  };
}

// Verdict, point or conflict with its proof, box, and the best value of an objective.
function answer({ text }) {
  const system = fmb.system(text);
  const { verdict, stop, point, proof, stats } = fmb.solve(system, { ...PATIENCE, proof: true });
  const result = { ...describe(system), verdict, stop, seconds: stats.seconds, point: plain(point), proof: proved(system, proof, verdict) };
  if (verdict === "feasible") {
    result.box = box(system);
    if (/^\s*(max|min)\w*\s*:[^<>=]*$/im.test(text)) result.optimum = best(system);
  }
  system.free();
  return result;
}

function best(system) {
  const { optimum, proof } = fmb.optimize(system, {}, { ...PATIENCE, proof: true });
  return optimum && { ...plain(optimum), proof: proved(system, proof, "bound") };
}

// The projection on the variables of those names: its rows, irredundant.
function project({ text, keep }) {
  const { system, stop } = fmb.project(text, keep, PATIENCE);
  const found = { ...describe(system), stop };
  system.free();
  return found;
}

// Elimination of all variables, watched row by row.
function eliminate({ text, order, rules }) {
  const system = fmb.system(text);
  const options = { method: "fm", presolve: "none", order, rules, maxRows: 3000, maxSeconds: 5, trace: "rows" };
  const { verdict, stop, trace } = fmb.solve(system, options);
  const result = { ...describe(system), verdict, stop, events: trace };
  system.free();
  return result;
}

// Two frames: do they meet, when and where exactly; how far apart or how deep in each other.
function frames({ a, b, moving }) {
  const found = plain(fmb.intersect(a, b));
  if (found.meet && moving) found.exact = plain(fmb.exactBox(a, b).box);
  if (moving) return found;
  const points = (list) => list.map((p) => p.map(Number));
  if (found.meet) {
    found.common = points(fmb.common(a, b).vertices);
    const { measure, length } = fmb.depth(a, b);
    Object.assign(found, { measure: String(measure), length });
  } else {
    const { measure, length, points: ends } = fmb.distance(a, b);
    const { row } = fmb.separate(a, b);
    Object.assign(found, { measure: String(measure), length, ends: points(ends) });
    found.row = { coefficients: a.orig.map((_, j) => double(row.terms.find((t) => t.variable === j)?.coefficient ?? 0)), right: double(row.right) };
  }
  return found;
}

// A mesh from the bytes of a file: the places of its cells, and which of them meet.
function mesh({ bytes }) {
  const m = fmb.mesh(bytes), begin = performance.now();
  const { hits, tested, stop } = fmb.meshMeet(m, null, { maxSeconds: 20 });
  const result = { points: m.points, cells: m.cells, corners: m.corners, hits, tested, stop, seconds: (performance.now() - begin) / 1000 };
  m.free();
  return result;
}

const TASKS = { answer, project, eliminate, frames, mesh };

self.onmessage = ({ data: { number, task, about } }) => {
  try {
    self.postMessage({ number, result: TASKS[task](about) });
  } catch (error) {
    // Any other exception leaves the engine in an undefined state.
    const isFatal = !(error instanceof FmbError);
    self.postMessage({ number, error: { message: error.message, line: error.line, column: error.column, isFatal } });
  }
};
self.postMessage({ version: fmb.version });
