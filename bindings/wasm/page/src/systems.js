// The first tab: a system as text, its verdict, the proof line by line, its rows, its box, and its projection.
import { byId, later, make, replace, tell } from "./dom.js";
import { ask } from "./engine.js";
import { Picture } from "./picture.js";
import { add, negative, parse, rational, show, showForm, showLabel, showRow, sign, times } from "./rational.js";
import { niceStep } from "./plane.js";
import { shifted, spanOf } from "./rewrite.js";

const listeners = [];
let found, picture;

export const systemText = () => byId("text").value;
// Called with every new answer.
export const onAnswer = (listener) => listeners.push(listener);

export function setSystem(text, { keepFit = false } = {}) {
  byId("text").value = text;
  if (!keepFit) picture.forget();
  refresh();
}

/* ---- what the proof says --------------------------------------------------------------------- */

function select(row) {
  const span = spanOf(systemText(), row), box = byId("text");
  if (!span) return;
  box.focus();
  box.setSelectionRange(...span);
}

const rowButton = (row, i) => make("button", { type: "button", class: "link", title: "Show it in the text", onclick: () => select(i) }, showLabel(row, i));

// Rows with their multipliers, and the partial sums.
function combination({ rows, variables }, multipliers) {
  let sum = variables.map(() => rational(0n)), right = rational(0n), isStrict = false;
  const lines = multipliers.map(({ row, multiplier }) => {
    const r = rows[row], m = parse(multiplier);
    sum = sum.map((c, j) => add(c, times(m, parse(r.texts[j]))));
    right = add(right, times(m, parse(r.right)));
    isStrict ||= r.relation === "<";
    return make("tr", {}, make("td", { class: "number" }, `${multiplier} ×`), make("td", {}, rowButton(r, row)), make("td", {}, showRow(r, variables)),
      make("td", {}, `${showForm(sum, variables)} ${isStrict ? "<" : "<="} ${show(right)}`));
  });
  return make("div", { class: "scroll" }, make("table", {},
    make("thead", {}, make("tr", {}, ["times", "row", "which says", "sum so far"].map((h) => make("th", { scope: "col" }, h)))), make("tbody", {}, lines)));
}

// Each row, evaluated at the point.
function evaluation({ rows, variables }, point) {
  const x = variables.map((name) => parse(point[name]));
  const lines = rows.map((row, i) => {
    const left = row.texts.reduce((sum, c, j) => add(sum, times(parse(c), x[j])), rational(0n));
    const slack = add(parse(row.right), negative(left));
    return make("tr", {}, make("td", {}, rowButton(row, i)), make("td", {}, showRow(row, variables)),
      make("td", {}, `${show(left)} ${row.relation} ${row.right}`), make("td", {}, sign(slack) === 0 ? "tight" : `${show(slack)} to spare`));
  });
  return make("div", { class: "scroll" }, make("table", {},
    make("thead", {}, make("tr", {}, ["row", "which says", "at this point", ""].map((h) => make("th", { scope: "col" }, h)))), make("tbody", {}, lines)));
}

function proofFile({ text }) {
  return make("details", {}, make("summary", {}, "The proof as a file, for fmb check"), make("pre", { tabindex: "0" }, text));
}

function showProof(a) {
  const accepted = make("p", {}, a.proof.accepted ? "✓ The checker, which shares no code with the solver, accepts this." : "The checker does not accept this: please report it.");
  if (a.verdict === "feasible")
    return [make("p", {}, "A solution proves it: every row holds there."),
      make("p", { class: "point" }, a.variables.map((name) => `${name} = ${a.point[name]}`).join(", ")), evaluation(a, a.point), accepted, proofFile(a.proof)];
  if (a.verdict === "infeasible")
    return [make("p", {}, "These rows contradict each other: added up, nothing is left but a false statement. Without any one of them there would be a solution."),
      combination(a, a.proof.multipliers), accepted, proofFile(a.proof)];
  return [make("p", {}, `A limit was reached (${a.stop}).`)];
}

function showOptimum(a) {
  const o = a.optimum;
  if (!o) return [];
  if (o.kind !== "finite") return [make("h3", {}, "Best value"), make("p", {}, "The form can be made as large (or small) as you like.")];
  return [make("h3", {}, "Best value"),
    make("p", { class: "point" }, `${o.value}${o.attained ? "" : " (approached, not reached)"} at ${a.variables.map((name) => `${name} = ${o.point[name]}`).join(", ")}`),
    make("p", {}, "No solution does better: these rows add up to that bound."), combination(a, o.proof.multipliers)];
}

/* ---- rows and box ---------------------------------------------------------------------------- */

function endText(end, side) {
  if (end.kind === "infinite") return side === "lower" ? "(−∞" : "∞)";
  const [open, close] = end.attained ? ["[", "]"] : ["(", ")"];
  return side === "lower" ? `${open}${end.value ?? "?"}` : `${end.value ?? "?"}${close}`;
}

function showBox({ box }) {
  if (!box) return [];
  return [make("h2", {}, "Box"), make("div", { class: "scroll" }, make("table", {}, make("thead", {}, make("tr", {}, ["variable", "tightest interval"].map((h) => make("th", { scope: "col" }, h)))),
    make("tbody", {}, Object.entries(box).map(([name, { lower, upper }]) =>
      make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, `${endText(lower, "lower")}, ${endText(upper, "upper")}`))))))];
}

const stepOf = (x) => niceStep(Math.max(Math.abs(x) / 50, 0.01));

function moveRow(i, delta, step) {
  byId("text").value = shifted(systemText(), i, delta, step);
  refresh();
}

// A row and buttons that move its right side.
function showRows({ rows, variables, proof, verdict }) {
  const guilty = new Set(verdict === "infeasible" ? proof.multipliers.map((m) => m.row) : []);
  return make("ol", { class: "rows" }, rows.map((row, i) => {
    const step = stepOf(row.rightDouble), words = showLabel(row, i);
    const mover = (sign, symbol, word) => make("button", { type: "button", class: "small", "aria-label": `${word} the right side of ${words}`, "data-move": `${i}${symbol}`, onclick: () => moveRow(i, sign * step, step / 10) }, symbol);
    return make("li", { class: guilty.has(i) ? "guilty" : null }, mover(-1, "−", "lower"), mover(1, "+", "raise"), " ", rowButton(row, i), " ", showRow(row, variables));
  }));
}

/* ---- all together ---------------------------------------------------------------------------- */

function showAnswer(a) {
  const focused = document.activeElement?.dataset?.move;
  found = a;
  replace(byId("verdict"), a.verdict === "unknown" ? `Undecided (${a.stop})` : a.verdict === "feasible" ? "Feasible" : "Infeasible",
    make("small", {}, ` ${a.rows.length} rows, ${a.variables.length} variables, ${(1000 * a.seconds).toFixed(1)} ms`));
  byId("verdict").className = `verdict ${a.verdict}`;
  byId("error").textContent = "";
  byId("text").removeAttribute("aria-invalid");
  replace(byId("proof"), showProof(a), showOptimum(a));
  replace(byId("rows"), showRows(a));
  replace(byId("box"), showBox(a));
  if (focused) document.querySelector(`[data-move="${focused}"]`)?.focus();
  const conflict = a.verdict === "infeasible" ? `: ${a.proof.multipliers.map((m) => showLabel(a.rows[m.row], m.row)).join(", ")} contradict each other` : "";
  tell(`${a.verdict}${conflict}`);
  picture.show(systemText(), a);
  for (const listener of listeners) listener(a);
}

function showError(error) {
  const { line, column } = error;
  byId("error").textContent = line ? `Line ${line}, column ${column}: ${error.message.replace(/^\d+:\d+: /, "")}` : error.message;
  byId("text").setAttribute("aria-invalid", "true");
  byId("verdict").className = "verdict old";
}

export async function refresh() {
  try {
    const a = await ask("answer", { text: systemText() });
    if (a) showAnswer(a);
  } catch (error) {
    showError(error);
  }
}

export function startSystems(onEdit) {
  picture = new Picture((row, delta, step) => {
    byId("text").value = shifted(systemText(), row, delta, step);
    refresh();
  });
  const soon = later(200, refresh);
  byId("text").addEventListener("input", () => {
    soon();
    onEdit();
  });
}

export const lastAnswer = () => found;
