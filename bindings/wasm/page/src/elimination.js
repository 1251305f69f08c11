// The second tab: elimination round by round, which pairs of rows were combined, and which rule dropped what.
//
// The library reports the two parents of each row it makes, not its numbers: these are recomputed here, exactly.
import { byId, make, replace, tell } from "./dom.js";
import { ask } from "./engine.js";
import { add, negative, parse, show, showForm, sign, times, whole } from "./rational.js";

const MOST_SHOWN = 60; // rows of a round

const RULES = {
  constant: "says nothing about any variable",
  kohler: "is made of more rows than a needed one can be (Kohler)",
  chernikov: "is made of rows that make another one, and of more (Chernikov)",
  imbert: "is made of more rows than variables have gone (Imbert)",
  duplicate: "is there already",
  dominated: "follows from a parallel row",
  box: "holds anywhere in the box of the variables",
  lp: "follows from the others (linear program)",
};

/* ---- rows made again ------------------------------------------------------------------------- */

// The positive combination of two rows that cancels variable j; null unless their signs differ.
function combine(p, q, j) {
  const u = p.entries[j], v = q.entries[j];
  if (sign(u) * sign(v) >= 0) return null;
  const positive = (c) => (sign(c) < 0 ? negative(c) : c), by = [positive(v), positive(u)];
  const entries = p.entries.map((c, k) => add(times(by[0], c), times(by[1], q.entries[k])));
  return { entries: whole(entries), isStrict: p.isStrict || q.isStrict };
}

const rowText = (row, names) => (row ? `${showForm(row.entries.slice(0, -1), names)} ${row.isStrict ? "<" : "<="} ${show(row.entries.at(-1))}` : "");

const isEquation = (row) => row.relation === "=";

// The rows that elimination begins with, as it numbers them: those of the system, then its equations the other way
// round.
function firstRows(rows) {
  const upper = rows.map((r) => ({ entries: [...r.texts, r.right].map(parse), isStrict: r.relation === "<" }));
  const reverse = upper.filter((_, i) => isEquation(rows[i])).map((r) => ({ ...r, entries: r.entries.map(negative) }));
  return new Map([...upper, ...reverse].map((r, i) => [i + 1, r]));
}

// Rounds with their rows, numbered like the library's: the number of a dropped row is reused by the next one.
function roundsOf({ rows, variables, events }) {
  const known = firstRows(rows);
  const rounds = [];
  let made = [], rules = [];
  for (const e of events) {
    if (e.event === "row") {
      const [p, q] = e.parents.map((n) => known.get(n)), row = p && q ? combine(p, q, e.var - 1) : null;
      if (e.dropped_by === null) known.set(e.row, row);
      made.push({ ...e, text: rowText(row, variables), isUpper: [p, q].map((r) => (r ? sign(r.entries[e.var - 1]) > 0 : null)) });
    } else if (e.event === "rule") {
      rules.push(e);
    } else if (e.event === "rebase") {
      rules.push({ name: "rebase", dropped: 0 });
    } else if (e.event === "round") {
      rounds.push({ ...e, made, rules, variable: variables[e.var - 1] });
      made = [];
      rules = [];
    }
  }
  return rounds;
}

/* ---- shown ----------------------------------------------------------------------------------- */

function showMade({ row, parents, text, dropped_by: rule, history }) {
  const from = `row ${parents[0]} + row ${parents[1]}`, rows = history ? ` (rows ${history.join(", ")} of the system)` : "";
  return make("li", { class: rule ? "dropped" : null }, make("span", { class: "name" }, rule ? "dropped" : `row ${row}`), " ", make("code", {}, text), ` from ${from}${rows}`,
    rule ? make("span", { class: "why" }, ` — ${rule}: it ${RULES[rule] ?? "is not needed"}`) : null);
}

const count = (n, what) => `${n} ${what}${n === 1 ? "" : "s"}`;

function countsOf({ pairs, made, rules, rows_in: before, rows_out: after }) {
  const dropped = rules.filter((r) => r.dropped > 0).map((r) => `${r.name} dropped ${r.dropped}`);
  return `${count(before, "row")} before, ${count(pairs, "pair")} looked at, ${count(made.length, "row")} made${dropped.length > 0 ? `, ${dropped.join(", ")}` : ""}, ${count(after, "row")} after`;
}

const listed = (rows) => `row${rows.length === 1 ? "" : "s"} ${rows.join(", ")}`;

// The rows that were combined, by which side they bound the variable from.
function sidesOf(made) {
  const of = (side) => [...new Set(made.flatMap((r) => r.parents.filter((_, k) => r.isUpper[k] === side)))].sort((a, b) => a - b);
  const [upper, lower] = [of(true), of(false)];
  return upper.length > 0 && lower.length > 0 ? `From above: ${listed(upper)}. From below: ${listed(lower)}. Each with each:` : null;
}

function showRound(round, k, most) {
  const { made } = round, bar = make("span", { class: "bar", "aria-hidden": "true" });
  bar.style.setProperty("--share", String(round.rows_out / Math.max(most, 1)));
  return make("details", { open: k === 0 }, make("summary", {}, make("strong", {}, `${k + 1}. ${round.variable} goes`), ` — ${countsOf(round)} `, bar),
    made.length === 0 ? make("p", {}, round.pairs === 0 ? "No pairs: its bounds are of one side, or an equation gives it." : "No row was made.") : null,
    sidesOf(made) && make("p", {}, sidesOf(made)),
    make("ol", { class: "made" }, made.slice(0, MOST_SHOWN).map(showMade)),
    made.length > MOST_SHOWN ? make("p", {}, `and ${made.length - MOST_SHOWN} more`) : null);
}

function numbersOf(rows) {
  const n = rows.length, equations = rows.filter(isEquation).length;
  const reverse = equations > 0 ? ` An equation is two rows: the other ways round have the numbers from ${n + 1} to ${n + equations}.` : "";
  return `The system's ${count(n, "row")} have the numbers from 1 to ${n}.${reverse}`;
}

function showRounds(found) {
  const rounds = roundsOf(found), most = rounds.reduce((m, r) => Math.max(m, r.rows_out), 0);
  const words = found.verdict === "unknown" ? `Undecided: a limit was reached (${found.stop}).` : `After ${rounds.length} rounds: ${found.verdict}. At most ${most} rows were there at once.`;
  replace(byId("rounds"), make("p", { class: `verdict ${found.verdict}` }, words),
    make("p", {}, numbersOf(found.rows)),
    rounds.map((r, k) => showRound(r, k, most)));
  tell(words);
}

async function run(text) {
  try {
    const found = await ask("eliminate", { text, order: byId("order").value, rules: rulesChosen() });
    if (found) showRounds(found);
  } catch (error) {
    replace(byId("rounds"), make("p", { class: "error" }, error.message));
  }
}

function rulesChosen() {
  const chosen = [...document.querySelectorAll("#rules input:checked")].map((box) => box.value);
  return chosen.join(",") || "none";
}

// text(): the system at hand.
export function startElimination(text) {
  byId("order").addEventListener("change", () => run(text()));
  byId("rules").addEventListener("change", () => run(text()));
  return () => run(text());
}
