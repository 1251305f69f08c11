// Evidence: claims with the numbers that prove them, as the library returns them; and its checker.
import { number, VERDICTS } from "./solver.js";
import { must } from "./memory.js";
import { parsed, RELATIONS } from "./system.js";

export const KINDS = ["none", "feasible", "infeasible", "bound", "unbounded", "implied", "redundant",
  "equality", "irredundant", "corner", "whole", "follows"];
const NONE = 0xffffffff; // a row that there is none of

function readMultipliers(memory, e, i) {
  const { c } = memory, list = [];
  for (let row = 0; (row = c.fmb_evidence_next_row(e, i, row) >>> 0) !== NONE; row++)
    list.push({ row, multiplier: number(memory, (to, size) => c.fmb_evidence_multiplier_text(e, i, row, to, size)) });
  return list;
}

function readForm(memory, e, i) {
  const { c } = memory;
  return Array.from({ length: c.fmb_evidence_terms(e, i) }, (_, k) => ({
    variable: c.fmb_evidence_term(e, i, k, 0),
    coefficient: number(memory, (to, size) => c.fmb_evidence_term_text(e, i, k, to, size)),
  }));
}

function readClaim(memory, e, system, i) {
  const { c } = memory, row = c.fmb_evidence_row(e, i) >>> 0, variable = c.fmb_evidence_var(e, i);
  return {
    kind: KINDS[c.fmb_evidence_kind(e, i)],
    words: memory.printed((to, size, length) => c.fmb_evidence_print_claim(e, system.at, i, to, size, length)).trimEnd(),
    row: row === NONE ? null : row,
    variable: variable < 0 ? null : variable,
    side: c.fmb_evidence_side(e, i) === 0 ? "lower" : "upper",
    relation: RELATIONS[c.fmb_evidence_rel(e, i)],
    form: readForm(memory, e, i),
    value: number(memory, (to, size) => c.fmb_evidence_value_text(e, i, to, size)),
    multipliers: readMultipliers(memory, e, i),
  };
}

// The evidence of the last query of v about that system, read as a whole: what `fmb check` reads,
// and its claims.
export function readProof(memory, v, system) {
  const { c } = memory;
  return memory.scope((s) => {
    const out = s.out();
    must(memory, c.fmb_solver_evidence(v, out), () => memory.textAt(c.fmb_solver_trouble(v)));
    const e = memory.int(out);
    try {
      return {
        text: memory.printed((to, size, length) => c.fmb_evidence_print(e, system.at, to, size, length)),
        claims: Array.from({ length: c.fmb_evidence_claims(e) }, (_, i) => readClaim(memory, e, system, i)),
      };
    } finally {
      c.fmb_evidence_free(e);
    }
  });
}

// Do the claims of a proof, given as text, hold of that system?
export function check(memory, system, text) {
  const { c, places } = memory;
  const e = parsed(memory, text, (at, length, where, out) => c.fmb_evidence_parse(at, length, system.at, out, where));
  try {
    return memory.scope((s) => {
      const j = s.structure("fmb_judgement");
      must(memory, c.fmb_check(system.at, e, j));
      const claim = memory.int(j + places["fmb_judgement.claim"]) >>> 0;
      return {
        accepted: memory.view.getUint8(j + places["fmb_judgement.accepted"]) !== 0,
        verdict: VERDICTS[memory.int(j + places["fmb_judgement.verdict"])],
        held: memory.int(j + places["fmb_judgement.held"]),
        claim: claim === NONE ? null : claim,
        reason: memory.textAt(j + places["fmb_judgement.reason"]),
      };
    });
  } finally {
    c.fmb_evidence_free(e);
  }
}
