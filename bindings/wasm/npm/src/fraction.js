// An exact rational number, as text "p/q" or "p", and the double nearest to it.

export class Fraction {
  #text;

  constructor(text, value = quotient(text)) {
    this.#text = text;
    this.value = value;
    Object.freeze(this);
  }

  get numerator() {
    return BigInt(this.#text.split("/")[0]);
  }

  get denominator() {
    return BigInt(this.#text.split("/")[1] ?? 1);
  }

  toString() {
    return this.#text;
  }

  valueOf() {
    return this.value;
  }

  toJSON() {
    return this.#text;
  }

  [Symbol.for("nodejs.util.inspect.custom")]() {
    return this.#text;
  }
}

const SIGNIFICANT = 64; // bits of a quotient: more than a double has

const bits = (n) => n.toString(2).length;

// The double nearest to p/q, if it is no subnormal one: where p and q are doubles, their quotient is
// rounded once; else the quotient is cut behind enough bits, the last of which says whether there
// are more, and rounded then.
function quotient(text) {
  const [top, bottom = "1"] = text.split("/");
  const a = Number(top), b = Number(bottom);
  if (Number.isSafeInteger(a) && Number.isSafeInteger(b)) return a / b;
  const p = BigInt(top), q = BigInt(bottom), size = p < 0n ? -p : p;
  const shift = SIGNIFICANT + bits(q) - bits(size);
  const x = shift > 0 ? size << BigInt(shift) : size, y = shift > 0 ? q : q << BigInt(-shift);
  const whole = Number((x / y) | (x % y === 0n ? 0n : 1n)), half = Math.trunc(shift / 2);
  return ((p < 0n ? -whole : whole) * 2 ** -half) * 2 ** (half - shift);
}

// The exact value of a double as text: "1/4", "-3".
export function exactText(x) {
  if (!Number.isFinite(x)) throw new RangeError(`${x} is no number of a row`);
  let bottom = 1n;
  while (!Number.isInteger(x)) {
    x *= 2;
    bottom *= 2n;
  }
  return bottom === 1n ? String(BigInt(x)) : `${BigInt(x)}/${bottom}`;
}
