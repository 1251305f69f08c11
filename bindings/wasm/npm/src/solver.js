// One query: a solver with its options, its answer, and a trace.
import { Fraction } from "./fraction.js";
import { FmbError, must } from "./memory.js";

export const VERDICTS = ["unknown", "feasible", "infeasible"];
export const STOPS = ["done", "time", "rows", "bytes", "cancelled"];
const FEASIBLE = [null, true, false];
const COUNTS = ["rounds", "pairs", "rows_made", "rows_kept", "rows_dropped", "rows_peak", "pivots", "lps"];
const CAMEL = /_(.)/g;

// maxSeconds becomes max_seconds; true and numbers become text.
function setOptions(memory, s, at, options) {
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined) continue;
    const field = name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
    const status = memory.c.fmb_options_set(at, s.text(field), s.text(String(value)));
    must(memory, status, () => `${name}: ${JSON.stringify(value)} is no such option`);
  }
}

function readStats(memory, result) {
  const { places } = memory, at = result + places["fmb_result.stats"], stats = {};
  for (const name of COUNTS)
    stats[name.replace(CAMEL, (_, letter) => letter.toUpperCase())] = memory.long(at + places[`fmb_stats.${name}`]);
  stats.seconds = memory.double(at + places["fmb_stats.seconds"]);
  return stats;
}

// The fields of every answer.
function readResult(memory, result) {
  const verdict = memory.int(result + memory.places["fmb_result.verdict"]);
  return {
    verdict: VERDICTS[verdict],
    feasible: FEASIBLE[verdict],
    stop: STOPS[memory.int(result + memory.places["fmb_result.stop"])],
    stats: readStats(memory, result),
  };
}

function traced(memory, v, trace, ask) {
  if (!trace) return [ask(), undefined];
  const { c } = memory;
  if (!c.engine_trace_begin(v)) throw new FmbError("out of memory", "memory");
  let status, at;
  try {
    status = ask();
  } finally {
    at = c.engine_trace_end(v);
  }
  const lines = memory.textAt(at).split("\n").filter(Boolean);
  c.free(at);
  return [status, lines.map((line) => JSON.parse(line))];
}

// Query a fresh solver: ask(v, result, s) calls the library, read(v, s) reads its
// answer while the solver lives. `trace` and `proof` are no options of the library.
export function query(memory, { trace = false, proof = false, ...options }, ask, read) {
  const { c } = memory;
  return memory.scope((s) => {
    const how = s.structure("fmb_options"), out = s.out();
    setOptions(memory, s, how, options);
    if (trace === "rows") must(memory, c.fmb_options_set(how, s.text("trace_rows"), s.text("true")));
    must(memory, c.fmb_solver_new(how, 0, out),
      () => memory.written((to, size) => c.fmb_options_trouble(how, to, size)));
    const v = memory.int(out);
    try {
      const result = s.structure("fmb_result");
      const [status, events] = traced(memory, v, trace, () => ask(v, result, s));
      must(memory, status, () => memory.textAt(c.fmb_solver_trouble(v)));
      const answer = { ...readResult(memory, result), ...read(v, s) };
      if (events) answer.trace = events;
      return answer;
    } finally {
      c.fmb_solver_free(v);
    }
  });
}

// The number that a function *_text(..., to, size) writes.
export function number(memory, writes) {
  const text = memory.written(writes);
  return text === "" ? null : new Fraction(text);
}
