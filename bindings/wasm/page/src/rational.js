// Exact arithmetic for the page's own sums: [numerator, denominator], both BigInt, in lowest terms.

const gcd = (a, b) => (b === 0n ? (a < 0n ? -a : a) : gcd(b, a % b));

export function rational(top, bottom = 1n) {
  const g = gcd(top, bottom) || 1n, sign = bottom < 0n ? -1n : 1n;
  return [(sign * top) / g, (sign * bottom) / g];
}

export function parse(text) {
  const [top, bottom = "1"] = text.split("/");
  return rational(BigInt(top), BigInt(bottom));
}

export const add = ([a, b], [c, d]) => rational(a * d + c * b, b * d);
export const times = ([a, b], [c, d]) => rational(a * c, b * d);
export const negative = ([a, b]) => [-a, b];
export const sign = ([a]) => (a > 0n ? 1 : a < 0n ? -1 : 0);
export const show = ([a, b]) => (b === 1n ? `${a}` : `${a}/${b}`);

// "2 x - 1/2 y", of coefficients as rationals.
export function showForm(coefficients, names) {
  let text = "";
  coefficients.forEach((c, j) => {
    const s = sign(c);
    if (s === 0) return;
    const size = show(s < 0 ? negative(c) : c);
    text += (text === "" ? (s < 0 ? "-" : "") : s < 0 ? " - " : " + ") + (size === "1" ? "" : `${size} `) + names[j];
  });
  return text || "0";
}

// A row as the worker describes it.
export const showRow = (row, names) => `${showForm(row.texts.map(parse), names)} ${row.relation} ${row.right}`;
export const showLabel = (row, i) => (row.label ? `row ${i + 1} (${row.label})` : `row ${i + 1}`);

// The whole numbers in the ratio of these, without a common factor: [coefficients..., right side].
export function whole(entries) {
  const bottom = entries.reduce((l, [, b]) => (l * b) / gcd(l, b), 1n);
  const numbers = entries.map(([a, b]) => (a * bottom) / b), g = numbers.reduce(gcd, 0n) || 1n;
  return numbers.map((a) => [a / g, 1n]);
}

// A fraction as text, or an approximation if that would be long.
export function brief(text, most = 24) {
  if (text.length <= most) return text;
  const [top, bottom = "1"] = text.split("/");
  return `≈ ${(Number(top) / Number(bottom)).toPrecision(7)}`;
}
