// The places of the rows of a system in its text, and how a right side is changed there.
//
// A line holds a row for each of its relations. Row r of a line relates its parts r and r + 1; one of them should be a
// number, or end in one, which is what changes.

const RELATION = /<=|=<|>=|=>|==|≤|≥|<|>|=/g;
const OTHER = /^\s*("?(vars|project|eliminate|integer)"?)\s*:/i;
const LABEL = /^([^:#<>="]*|\s*"(?:[^"\\]|\\.)*"\s*):/;
const NUMBER = /^\s*[+-]?\s*(\d+\.?\d*|\.\d+)(\s*\/\s*\d+)?\s*$/;
const ENDS_IN_NUMBER = /([+-])\s*((\d+\.?\d*|\.\d+)(\s*\/\s*\d+)?)\s*$/;

// {line, relation, parts, signs} of each row: the line's number, which of its relations, and its parts with the
// relations between them.
export function rowsOf(text) {
  const rows = [];
  text.split("\n").forEach((whole, line) => {
    const comment = whole.indexOf("#"), code = comment < 0 ? whole : whole.slice(0, comment);
    if (OTHER.test(code)) return;
    const label = LABEL.exec(code)?.[0] ?? "", body = code.slice(label.length);
    const signs = body.match(RELATION) ?? [], parts = body.split(RELATION);
    signs.forEach((_, relation) => rows.push({ line, relation, parts, signs, label, comment: comment < 0 ? "" : whole.slice(comment) }));
  });
  return rows;
}

function valueOf(number) {
  const [top, bottom = "1"] = number.replace(/\s/g, "").split("/");
  return Number(top) / Number(bottom);
}

// A decimal of as many digits as the step has.
export function round(x, step) {
  const digits = Math.max(0, -Math.floor(Math.log10(step)));
  return String(Number((Math.round(x / step) * step).toFixed(Math.min(digits, 12))));
}

// The part with its number increased.
function plus(part, delta, step) {
  const before = /^\s*/.exec(part)[0], behind = /\s*$/.exec(part)[0];
  if (NUMBER.test(part)) return before + round(valueOf(part) + delta, step) + behind;
  const end = ENDS_IN_NUMBER.exec(part), constant = end ? valueOf(end[1] + end[2]) + delta : delta;
  const form = end ? part.slice(0, end.index).trimEnd() : part.trimEnd(), size = round(Math.abs(constant), step);
  return form + (size === "0" ? "" : ` ${constant < 0 ? "-" : "+"} ${size}`) + behind;
}

// The text, with the right side of that row, as the library keeps it (a.x <= b), larger by delta.
export function shifted(text, number, delta, step) {
  const row = rowsOf(text)[number];
  if (!row) return text;
  const { line, relation, parts, signs, label, comment } = row, lines = text.split("\n");
  const isUpper = !/[>≥]/.test(signs[relation]);
  const onRight = NUMBER.test(parts[relation + 1]) || !NUMBER.test(parts[relation]);
  const at = relation + (onRight ? 1 : 0);
  const changed = parts.slice();
  changed[at] = plus(parts[at], isUpper === onRight ? delta : -delta, step);
  const body = changed.reduce((sum, part, i) => sum + (i > 0 ? signs[i - 1] : "") + part, "");
  lines[line] = label + body + comment;
  return lines.join("\n");
}

// Where the line of a row begins and ends in the text.
export function spanOf(text, number) {
  const row = rowsOf(text)[number];
  if (!row) return null;
  const lines = text.split("\n"), from = lines.slice(0, row.line).reduce((sum, l) => sum + l.length + 1, 0);
  return [from, from + lines[row.line].length];
}
