// Meshes of triangles or tetrahedra: which cells meet, and how.
import { FmbError, must } from "./memory.js";
import { STOPS } from "./solver.js";

const FORMATS = ["auto", "off", "obj", "ply", "stl", "mesh"];
const ENCODER = new TextEncoder();
const FREED = new FinalizationRegistry(({ c, at }) => c.fmb_mesh_free(at));

// A mesh in the engine. It is freed with this object, or at once by free().
export class Mesh {
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
    this.memory.c.fmb_mesh_free(this.at);
    this.at = 0;
  }

  // The number of corners of a cell: 3 or 4.
  get corners() {
    return this.memory.c.fmb_mesh_corners(this.at);
  }

  get size() {
    return this.memory.c.fmb_mesh_cells(this.at);
  }

  // x, y, z of each vertex.
  get points() {
    const { c } = this.memory;
    return this.memory.doubles(c.fmb_mesh_points(this.at), 3 * c.fmb_mesh_vertices(this.at));
  }

  // Numbers of the vertices of each cell.
  get cells() {
    const { c } = this.memory;
    return new Uint32Array(c.memory.buffer, c.fmb_mesh_indices(this.at), this.corners * this.size).slice();
  }

  // The number in its file of the face that a cell comes from.
  face(cell) {
    return this.memory.c.fmb_mesh_face(this.at, cell);
  }
}
Mesh.prototype[Symbol.dispose ?? Symbol.for("dispose")] = Mesh.prototype.free;

function fromFile(memory, bytes, format) {
  const f = FORMATS.indexOf(format), { c } = memory;
  if (f < 0) throw new FmbError(`${JSON.stringify(format)} is no format of meshes: ${FORMATS.join(", ")}`, "argument");
  return memory.scope((s) => {
    const out = s.out(), where = s.structure("fmb_where");
    must(memory, c.fmb_mesh_parse(s.block(bytes), bytes.length, f, 0, out, where),
      () => memory.written((to, size) => c.fmb_where_text(where, 0, to, size)));
    return new Mesh(memory, memory.int(out));
  });
}

function fromArrays(memory, { points, cells, corners = 3 }) {
  const flat = points.flat ? points.flat() : points, list = cells.flat ? cells.flat() : cells;
  return memory.scope((s) => {
    const out = s.out();
    must(memory, memory.c.fmb_mesh_new(corners, flat.length / 3, s.doubles(flat), list.length / corners, s.ints(list), 0, out));
    return new Mesh(memory, memory.int(out));
  });
}

// A mesh from the text or bytes of a file, from arrays, or a Mesh itself.
export function meshOf(memory, from, { format = "auto" } = {}) {
  if (from instanceof Mesh) return from;
  if (typeof from === "string") return fromFile(memory, ENCODER.encode(from), format);
  if (from instanceof Uint8Array) return fromFile(memory, from, format);
  return fromArrays(memory, from);
}

function readHits(memory, answer) {
  const { c, places } = memory, first = memory.int(answer + places["fmb_mesh_answer.hit"]);
  const field = (at, name) => memory.int(at + places[`fmb_mesh_hit.${name}`]);
  return Array.from({ length: memory.int(answer + places["fmb_mesh_answer.hits"]) }, (_, i) => {
    const at = first + i * places.fmb_mesh_hit;
    return {
      a: field(at, "a") >>> 0,
      b: field(at, "b") >>> 0,
      shared: field(at, "shared"),
      how: memory.textAt(c.fmb_mesh_how_text(field(at, "how"))),
    };
  });
}

// Which cells of a and b meet; without b: which cells of a meet one another.
export function meshMeet(memory, a, b, { neighbours = false, motion, maxSeconds = 0 } = {}) {
  const { c, places } = memory;
  return memory.scope((s) => {
    const how = s.structure("fmb_mesh_options", { neighbours: neighbours ? 1 : 0, motion: motion ? s.doubles(motion) : 0 });
    memory.view.setFloat64(how + places["fmb_mesh_options.max_seconds"], maxSeconds, true);
    const answer = s.structure("fmb_mesh_answer");
    must(memory, c.fmb_mesh_meet(a.at, b ? b.at : 0, how, answer),
      () => memory.written((to, size) => c.fmb_mesh_options_trouble(how, to, size)));
    try {
      return {
        hits: readHits(memory, answer),
        tested: memory.long(answer + places["fmb_mesh_answer.tested"]),
        stop: STOPS[memory.int(answer + places["fmb_mesh_answer.stop"])],
      };
    } finally {
      c.fmb_mesh_answer_clear(answer);
    }
  });
}
