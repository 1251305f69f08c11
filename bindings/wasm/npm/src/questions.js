// The questions about a system: each is a call of <fmb/solve.h> or <fmb/generators.h>.
import { number, query } from "./solver.js";
import { FmbError, must } from "./memory.js";
import { System, parsed } from "./system.js";
import { readProof } from "./proof.js";

const ENDS = ["unknown", "finite", "infinite", "outer"];
const FATES = ["unknown", "kept", "equality", "redundant"];
const GENERATORS = ["vertex", "ray", "line"];
const SENSES = { max: 1, min: 2 };

// The object that a call returned, or null.
function given(memory, out, wrap) {
  const at = memory.int(out);
  return at === 0 ? null : wrap(at);
}

function proofIf(memory, options, v, system) {
  return options.proof ? { proof: readProof(memory, v, system) } : {};
}

function named(system, variables, value) {
  const names = system.variables;
  return Object.fromEntries(variables.map((j, k) => [names[j], value(j, k)]));
}

const all = (system) => system.variables.map((_, j) => j);

/* ---- solve ----------------------------------------------------------------------------------- */

function readPoint(memory, v, system) {
  return named(system, all(system), (j) => number(memory, (to, size) => memory.c.fmb_solver_point_text(v, j, to, size)));
}

function readConflict(memory, v, system, s) {
  const { c } = memory, n = s.out();
  must(memory, c.fmb_solver_conflict(v, n));
  return Array.from({ length: memory.int(n) }, (_, k) => {
    const row = c.fmb_solver_conflict_row(v, k), label = c.fmb_system_label(system.at, row);
    return {
      row,
      label: label === 0 ? null : memory.textAt(label),
      multiplier: number(memory, (to, size) => c.fmb_solver_conflict_multiplier_text(v, k, to, size)),
    };
  });
}

export function solve(memory, system, options = {}) {
  const { c } = memory;
  return query(memory, options, (v, result) => c.fmb_solve(v, system.at, result), (v, s) => {
    const x = s.zeros(8 * Math.max(1, system.variables.length)), answer = { point: null, conflict: null };
    if (options.evidence === "none") return answer;
    if (c.fmb_solver_point(v, x) === 0) answer.point = readPoint(memory, v, system);
    else if (c.fmb_solver_conflict(v, s.out()) === 0) answer.conflict = readConflict(memory, v, system, s);
    return { ...answer, ...proofIf(memory, options, v, system) };
  });
}

/* ---- project, reduce ------------------------------------------------------------------------- */

export function project(memory, system, keep, options = {}) {
  const { c } = memory, variables = system.find(keep).sort((a, b) => a - b);
  let out;
  return query(memory, options, (v, result, s) => {
    out = s.out();
    return c.fmb_project(v, system.at, s.ints(variables), variables.length, out, result);
  }, (v) => ({
    system: given(memory, out, (at) => new System(memory, at)),
    ...proofIf(memory, options, v, system),
  }));
}

export function reduce(memory, system, options = {}) {
  const { c } = memory, n = system.size;
  let out, fates;
  return query(memory, options, (v, result, s) => {
    out = s.out();
    fates = s.zeros(4 * n);
    return c.fmb_reduce(v, system.at, fates, out, result);
  }, (v) => ({
    system: given(memory, out, (at) => new System(memory, at)),
    fates: Array.from({ length: n }, (_, i) => FATES[memory.int(fates + 4 * i)]),
    ...proofIf(memory, options, v, system),
  }));
}

/* ---- bounds, optimize ------------------------------------------------------------------------ */

// A C function that returns a structure writes it to the address in its first argument.
function readEnd(memory, call, text) {
  return memory.scope((s) => {
    const { places } = memory, end = s.structure("fmb_end");
    call(end);
    return {
      kind: ENDS[memory.int(end + places["fmb_end.kind"])],
      attained: memory.view.getUint8(end + places["fmb_end.attained"]) !== 0,
      value: number(memory, text),
    };
  });
}

function readInterval(memory, box, i) {
  const { c } = memory;
  const [lower, upper] = [0, 1].map((side) => readEnd(memory,
    (end) => c.fmb_box_end(end, box, i, side),
    (to, size) => c.fmb_box_end_text(box, i, side, to, size)));
  return { lower, upper };
}

export function bounds(memory, system, variables, options = {}) {
  const { c } = memory, list = variables ? system.find(variables) : all(system);
  let out;
  return query(memory, options, (v, result, s) => {
    out = s.out();
    return c.fmb_bound(v, system.at, s.ints(list), list.length, out, result);
  }, (v) => ({
    box: given(memory, out, (box) => {
      try {
        return named(system, list, (_, k) => readInterval(memory, box, k));
      } finally {
        c.fmb_box_free(box);
      }
    }),
    ...proofIf(memory, options, v, system),
  }));
}

// The form becomes the objective of a copy: the given system is unchanged.
function withObjective(memory, system, sense, form) {
  const { c } = memory;
  const copy = memory.scope((s) => {
    const out = s.out();
    must(memory, c.fmb_system_copy(system.at, out));
    return new System(memory, memory.int(out));
  });
  if (typeof form === "string") {
    parsed(memory, form, (at, length, where) => c.fmb_system_parse_objective(copy.at, SENSES[sense], at, length, where));
  } else {
    if (form.length !== system.variables.length) throw new FmbError(`${form.length} coefficients of ${system.variables.length}`, "argument");
    memory.scope((s) => {
      const { places } = memory, o = s.structure("fmb_objective", { sense: SENSES[sense], coef: s.doubles(form) });
      must(memory, c.fmb_system_set_objective(copy.at, o), () => memory.textAt(c.fmb_system_trouble(copy.at)));
    });
  }
  return copy;
}

function readOptimum(memory, system, o) {
  const { c } = memory;
  const end = readEnd(memory, (at) => c.fmb_optimum_end(at, o), (to, size) => c.fmb_optimum_value_text(o, to, size));
  const vector = (text) => named(system, all(system), (j) => number(memory, (to, size) => text(o, j, to, size)));
  return {
    ...end,
    point: vector(c.fmb_optimum_coordinate_text),
    ray: end.kind === "infinite" ? vector(c.fmb_optimum_ray_text) : null,
  };
}

// what: {max: form} or {min: form}, where a form is text or coefficients; none: the system's objective.
export function optimize(memory, system, what = {}, options = {}) {
  const { c } = memory, sense = Object.keys(SENSES).find((word) => word in what);
  const asked = sense ? withObjective(memory, system, sense, what[sense]) : system;
  let out;
  try {
    return query(memory, options, (v, result, s) => {
      out = s.out();
      return c.fmb_optimize(v, asked.at, 0, out, result);
    }, (v) => ({
      optimum: given(memory, out, (o) => {
        try {
          return readOptimum(memory, asked, o);
        } finally {
          c.fmb_optimum_free(o);
        }
      }),
      ...proofIf(memory, options, v, asked),
    }));
  } finally {
    if (asked !== system) asked.free();
  }
}

/* ---- vertices -------------------------------------------------------------------------------- */

export function readGenerators(memory, g) {
  const { c } = memory, dim = c.fmb_generators_dim(g);
  return Array.from({ length: c.fmb_generators_size(g) }, (_, i) => ({
    kind: GENERATORS[c.fmb_generators_kind(g, i)],
    point: Array.from({ length: dim }, (_, j) => number(memory, (to, size) => c.fmb_generators_coordinate_text(g, i, j, to, size))),
  }));
}

export function vertices(memory, system, options = {}) {
  const { c } = memory;
  let out;
  return query(memory, options, (v, result, s) => {
    out = s.out();
    return c.fmb_generate(v, system.at, out, result);
  }, () => ({
    generators: given(memory, out, (g) => {
      try {
        return readGenerators(memory, g);
      } finally {
        c.fmb_generators_free(g);
      }
    }) ?? [],
  }));
}
