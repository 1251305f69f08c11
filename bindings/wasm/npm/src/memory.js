// The memory of the engine, as JavaScript sees it: texts, numbers, structures, arrays.
//
// The arguments of a call are allocated in a scope, and freed when the scope ends:
//
//   memory.scope((s) => c.fmb_system_parse(s.text(text), ...))

const ENCODER = new TextEncoder(), DECODER = new TextDecoder();
const SCRATCH = 4096; // bytes that most texts fit into

export class FmbError extends Error {
  constructor(message, status = "") {
    super(message);
    this.name = "FmbError";
    this.status = status;
  }
}

export class Memory {
  #view;
  #scratch;

  constructor(c) {
    this.c = c;
    this.#view = new DataView(c.memory.buffer);
    this.#scratch = this.reserve(SCRATCH);
    this.places = {};
    for (let i = 0, name; (name = c.engine_place_name(i)) !== 0; i++)
      this.places[this.textAt(name)] = c.engine_place_value(i);
  }

  // A view becomes invalid when the memory grows.
  get view() {
    if (this.#view.buffer !== this.c.memory.buffer) this.#view = new DataView(this.c.memory.buffer);
    return this.#view;
  }

  get bytes() {
    return new Uint8Array(this.c.memory.buffer);
  }

  reserve(bytes) {
    const at = this.c.malloc(Math.max(bytes, 1));
    if (at === 0) throw new FmbError("out of memory", "memory");
    return at;
  }

  int(at) {
    return this.view.getInt32(at, true);
  }

  // Counts and sizes are always below 2^53.
  long(at) {
    return Number(this.view.getBigUint64(at, true));
  }

  double(at) {
    return this.view.getFloat64(at, true);
  }

  doubles(at, n) {
    return new Float64Array(this.c.memory.buffer, at, n).slice();
  }

  textAt(at) {
    const bytes = this.bytes, end = bytes.indexOf(0, at);
    return DECODER.decode(bytes.subarray(at, end));
  }

  // The text that writes(at, size) writes; it returns the text's length.
  written(writes) {
    const length = writes(this.#scratch, SCRATCH);
    if (length < SCRATCH) return this.textAt(this.#scratch);
    const at = this.reserve(length + 1);
    try {
      writes(at, length + 1);
      return this.textAt(at);
    } finally {
      this.c.free(at);
    }
  }

  // Likewise for functions *_print, which return a status, and the length in *at.
  printed(prints) {
    return this.scope((s) => {
      const length = s.zeros(4);
      must(this, prints(0, 0, length));
      const size = this.int(length) + 1, text = s.zeros(size);
      must(this, prints(text, size, length));
      return this.textAt(text);
    });
  }

  scope(work) {
    const scope = new Scope(this);
    try {
      return work(scope);
    } finally {
      scope.end();
    }
  }
}

// Arguments of one call.
class Scope {
  #blocks = [];

  constructor(memory) {
    this.memory = memory;
  }

  zeros(bytes) {
    const at = this.memory.reserve(bytes);
    this.#blocks.push(at);
    this.memory.bytes.fill(0, at, at + bytes);
    return at;
  }

  // NUL-terminated; length counts bytes without it.
  text(text) {
    const bytes = ENCODER.encode(text), at = this.zeros(bytes.length + 1);
    this.memory.bytes.set(bytes, at);
    this.length = bytes.length;
    return at;
  }

  block(bytes) {
    const at = this.zeros(bytes.length);
    this.memory.bytes.set(bytes, at);
    return at;
  }

  doubles(numbers) {
    const at = this.zeros(8 * numbers.length);
    new Float64Array(this.memory.c.memory.buffer, at, numbers.length).set(numbers);
    return at;
  }

  ints(numbers) {
    const at = this.zeros(4 * numbers.length);
    new Int32Array(this.memory.c.memory.buffer, at, numbers.length).set(numbers);
    return at;
  }

  // A structure with these fields, all others 0; sets its size field if it has one.
  structure(type, fields = {}) {
    const { places, view } = this.memory, at = this.zeros(places[type]);
    if (`${type}.size` in places) this.memory.view.setInt32(at + places[`${type}.size`], places[type], true);
    for (const [field, value] of Object.entries(fields)) this.memory.view.setInt32(at + places[`${type}.${field}`], value, true);
    return at;
  }

  // A place for the pointer to an object that a call returns.
  out() {
    return this.zeros(4);
  }

  end() {
    for (const at of this.#blocks) this.memory.c.free(at);
  }
}

const STATUS = ["ok", "argument", "memory", "parse", "io", "rule", "state", "range"];

// Throws unless the status is OK; trouble gives the reason, if known.
export function must(memory, status, trouble = () => "") {
  if (status === 0) return;
  const why = trouble() || memory.textAt(memory.c.fmb_status_text(status));
  throw new FmbError(why, STATUS[status] ?? "");
}
