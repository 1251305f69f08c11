// Systems: from text or arrays into the engine, and back.
import { Fraction, exactText } from "./fraction.js";
import { FmbError, must } from "./memory.js";

export const RELATIONS = ["<=", "<", "=", ">=", ">"];
const FORMATS = ["auto", "fmb", "ine", "ieq", "smt2", "mps", "lp"];
const FREED = new FinalizationRegistry(({ c, at }) => c.fmb_system_free(at));

const isText = (x) => typeof x === "string";

function placeOf(list, word, what) {
  const place = list.indexOf(word);
  if (place < 0) throw new FmbError(`${JSON.stringify(word)} is no ${what}: ${list.join(", ")}`, "argument");
  return place;
}

// A number as exact text: doubles mean their binary value.
export function exact(number) {
  return typeof number === "number" ? exactText(number) : String(number);
}

// A system in the engine. It is freed with this object, or at once by free().
export class System {
  #own;

  constructor(memory, at) {
    this.memory = memory;
    this.at = at;
    this.#own = {};
    FREED.register(this, { c: memory.c, at }, this.#own);
  }

  free() {
    if (this.at === 0) return;
    FREED.unregister(this.#own);
    this.memory.c.fmb_system_free(this.at);
    this.at = 0;
  }

  get variables() {
    const { c } = this.memory, n = c.fmb_system_dim(this.at);
    return Array.from({ length: n }, (_, j) => this.memory.textAt(c.fmb_system_name(this.at, j)));
  }

  get size() {
    return this.memory.c.fmb_system_rows(this.at);
  }

  // Row i: its exact terms, relation and right side, and its left side as text.
  row(i) {
    const { memory, at } = this, { c } = memory;
    if (!(i >= 0 && i < this.size)) throw new FmbError(`row ${i} of ${this.size}`, "argument");
    return memory.scope((s) => {
      const n = c.fmb_system_terms(at, i), start = s.zeros(8), vars = s.zeros(4 * n);
      must(memory, c.fmb_system_get_rows(at, i, 1, start, vars, 0, 0, 0));
      const terms = Array.from({ length: n }, (_, k) => ({
        variable: memory.int(vars + 4 * k),
        coefficient: new Fraction(memory.written((to, size) => c.fmb_system_term_text(at, i, k, to, size))),
      }));
      const label = c.fmb_system_label(at, i);
      return {
        terms,
        relation: RELATIONS[c.fmb_system_rel(at, i)],
        right: new Fraction(memory.written((to, size) => c.fmb_system_rhs_text(at, i, to, size))),
        label: label === 0 ? null : memory.textAt(label),
      };
    });
  }

  get rows() {
    return Array.from({ length: this.size }, (_, i) => this.row(i));
  }

  // The text in that format: "fmb", "ine", "smt2", "mps" or "lp".
  toText(format = "fmb") {
    const { memory } = this, f = placeOf(FORMATS, format, "format");
    return memory.printed((to, size, length) => memory.c.fmb_system_print(this.at, f, to, size, length));
  }

  toString() {
    return this.toText();
  }

  // Numbers of variables, which are given by name or number.
  find(variables) {
    return variables.map((v) => {
      const { c } = this.memory, n = c.fmb_system_dim(this.at);
      const j = isText(v) ? this.memory.scope((s) => c.fmb_system_find(this.at, s.text(v))) : v;
      if (!(Number.isInteger(j) && j >= 0 && j < n)) throw new FmbError(`there is no variable ${v}`, "argument");
      return j;
    });
  }
}
System.prototype[Symbol.dispose ?? Symbol.for("dispose")] = System.prototype.free;

/* ---- from text ------------------------------------------------------------------------------- */

// Runs parse(text, length, where, out); an error in the text is thrown with its place.
export function parsed(memory, text, parse) {
  return memory.scope((s) => {
    const at = s.text(text), length = s.length, where = s.structure("fmb_where"), out = s.out();
    const status = parse(at, length, where, out, s);
    if (status !== 0) {
      const why = memory.written((to, size) => memory.c.fmb_where_text(where, 0, to, size));
      const error = new FmbError(why || memory.textAt(memory.c.fmb_status_text(status)), "parse");
      error.line = memory.int(where + memory.places["fmb_where.line"]);
      error.column = memory.int(where + memory.places["fmb_where.column"]);
      throw error;
    }
    return memory.int(out);
  });
}

function fromText(memory, text, format) {
  const f = placeOf(FORMATS, format, "format");
  return parsed(memory, text, (at, length, where, out, s) =>
    memory.c.fmb_system_parse(at, length, s.structure("fmb_reader", { format: f }), out, where));
}

/* ---- from arrays ----------------------------------------------------------------------------- */

function addDoubles(memory, at, matrix, relations, right) {
  memory.scope((s) => {
    const a = s.doubles(matrix.flatMap((row) => Array.from(row))), b = s.doubles(right), rel = s.ints(relations);
    must(memory, memory.c.fmb_system_add_rows(at, matrix.length, 0, 0, a, rel, b),
      () => memory.textAt(memory.c.fmb_system_trouble(at)));
  });
}

function addTexts(memory, at, row, relation, right) {
  memory.scope((s) => {
    const vars = [], texts = [];
    Array.from(row, exact).forEach((text, j) => {
      if (text === "0") return;
      vars.push(j);
      texts.push(s.text(text));
    });
    must(memory, memory.c.fmb_system_add_terms_text(at, vars.length, s.ints(vars), s.ints(texts), relation, s.text(exact(right))),
      () => memory.textAt(memory.c.fmb_system_trouble(at)));
  });
}

function fromArrays(memory, { matrix, relations, right, variables, labels }) {
  const n = variables?.length ?? matrix[0]?.length ?? 0, { c } = memory;
  const rel = matrix.map((_, i) => placeOf(RELATIONS, relations?.[i] ?? "<=", "relation"));
  if (right.length !== matrix.length) throw new FmbError(`${matrix.length} rows, ${right.length} right sides`, "argument");
  for (const [i, row] of matrix.entries())
    if (row.length !== n) throw new FmbError(`row ${i} has ${row.length} numbers, not ${n}`, "argument");
  const system = new System(memory, memory.scope((s) => {
    const out = s.out();
    must(memory, c.fmb_system_new(n, 0, out));
    return memory.int(out);
  }));
  const trouble = () => memory.textAt(c.fmb_system_trouble(system.at));
  variables?.forEach((name, j) => memory.scope((s) => must(memory, c.fmb_system_set_name(system.at, j, s.text(name)), trouble)));
  const doubles = matrix.every((row, i) => typeof right[i] === "number" && Array.prototype.every.call(row, (x) => typeof x === "number"));
  if (doubles) addDoubles(memory, system.at, matrix, rel, right);
  else matrix.forEach((row, i) => addTexts(memory, system.at, row, rel[i], right[i]));
  labels?.forEach((label, i) => label && memory.scope((s) => must(memory, c.fmb_system_set_label(system.at, i, s.text(label)), trouble)));
  return system;
}

// A system from text in any format, from arrays, or a System itself.
export function systemOf(memory, from, { format = "auto" } = {}) {
  if (from instanceof System) return from;
  if (isText(from)) return new System(memory, fromText(memory, from, format));
  return fromArrays(memory, from);
}
