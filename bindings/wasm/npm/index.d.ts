/** libfmb: systems of linear inequalities, answered exactly and with proofs; frames and meshes. */

/** An exact rational: `String(f)` is "p/q" or "p", `Number(f)` the nearest double. */
export class Fraction {
  readonly value: number;
  readonly numerator: bigint;
  readonly denominator: bigint;
  toString(): string;
  toJSON(): string;
  valueOf(): number;
}

/** What went wrong; of texts with its place, from 1. */
export class FmbError extends Error {
  readonly status: "argument" | "memory" | "parse" | "io" | "rule" | "state" | "range" | "";
  readonly line?: number;
  readonly column?: number;
}

export type Relation = "<=" | "<" | "=" | ">=" | ">";
/** A number means its binary value, text ("1/3", "0.1") and a bigint what they say. */
export type Exact = number | bigint | string | Fraction;
export type Format = "auto" | "fmb" | "ine" | "ieq" | "smt2" | "mps" | "lp";
/** By name, or by number from 0. */
export type Variable = string | number;

/** Rows matrix[i] x relations[i] right[i]; relations are "<=" where they are left out. */
export interface Arrays {
  matrix: ArrayLike<Exact>[];
  right: Exact[];
  relations?: Relation[];
  variables?: string[];
  labels?: (string | null)[];
}

export interface Row {
  terms: { variable: number; coefficient: Fraction }[];
  /** ">=" and ">" are kept as "<=" and "<" with all signs changed. */
  relation: Relation;
  right: Fraction;
  label: string | null;
}

/** A system in the engine's memory. It goes with this object, or at once by free(). */
export class System {
  readonly variables: string[];
  readonly size: number;
  readonly rows: Row[];
  row(i: number): Row;
  toText(format?: Exclude<Format, "auto" | "ieq">): string;
  toString(): string;
  free(): void;
}

/** Text in any format that `fmb` reads, arrays, or a system. */
export type SystemLike = string | Arrays | System;

/** Those of the command (`fmb solve --help`), in camel case. */
export interface Options {
  method?: "auto" | "fm" | "lp" | "hull" | "dd";
  order?: "pairs" | "given" | "min" | "fill";
  /** A comma list of pruning rules, or "none". */
  rules?: string;
  rebase?: "auto" | "always" | "never";
  presolve?: string;
  evidence?: "all" | "none" | "verdict" | "whole";
  maxSeconds?: number;
  maxRows?: number;
  maxBytes?: number;
  /** Hand out the proof. */
  proof?: boolean;
  /** Tell what happened; with "rows" of each row that was made. */
  trace?: boolean | "rows";
}

export interface Stats {
  rounds: number;
  pairs: number;
  rowsMade: number;
  rowsKept: number;
  rowsDropped: number;
  rowsPeak: number;
  pivots: number;
  lps: number;
  seconds: number;
}

export interface Claim {
  kind: "none" | "feasible" | "infeasible" | "bound" | "unbounded" | "implied" | "redundant" | "equality"
    | "irredundant" | "corner" | "whole" | "follows";
  words: string;
  row: number | null;
  variable: number | null;
  side: "lower" | "upper";
  relation: Relation;
  form: { variable: number; coefficient: Fraction }[];
  value: Fraction | null;
  multipliers: { row: number; multiplier: Fraction }[];
}

export interface Proof {
  /** What `check` and `fmb check` read. */
  text: string;
  claims: Claim[];
}

/** An event as `--trace` writes it; rows and variables count from 1. */
export interface Event {
  event: "begin" | "round" | "rule" | "lp" | "end" | "row" | "rebase" | "engine";
  seconds: number;
  name?: string;
  [key: string]: unknown;
}

export interface Answer {
  verdict: "feasible" | "infeasible" | "unknown";
  feasible: boolean | null;
  /** "done", or the limit that ended it. */
  stop: "done" | "time" | "rows" | "bytes" | "cancelled";
  stats: Stats;
  proof?: Proof;
  trace?: Event[];
}

export interface Solution extends Answer {
  point: Record<string, Fraction> | null;
  /** Rows without a common solution, none of which can be left out. */
  conflict: { row: number; label: string | null; multiplier: Fraction }[] | null;
}

export interface End {
  kind: "finite" | "infinite" | "outer" | "unknown";
  attained: boolean;
  value: Fraction | null;
}

export interface Bounds extends Answer {
  /** null if the system is infeasible. */
  box: Record<string, { lower: End; upper: End }> | null;
}

export interface Projection extends Answer {
  system: System | null;
}

export interface Reduction extends Answer {
  system: System | null;
  fates: ("unknown" | "kept" | "equality" | "redundant")[];
}

export interface Optimum extends Answer {
  optimum: (End & { point: Record<string, Fraction>; ray: Record<string, Fraction> | null }) | null;
}

export interface Vertices extends Answer {
  generators: { kind: "vertex" | "ray" | "line"; point: Fraction[] }[];
}

export interface Judgement {
  accepted: boolean;
  verdict: Answer["verdict"];
  held: number;
  claim: number | null;
  reason: string;
}

/** orig + sum c_i comp_i + t vel, 0 <= t <= 1; or by its corners. */
export type Frame =
  | { type: "cuboid" | "simplex" | "triangle" | "tetrahedron"; orig: number[]; comp: number[][]; vel?: number[] }
  | { type: "cuboid" | "simplex" | "triangle" | "tetrahedron"; points: number[][]; vel?: number[] };
/** The same with numbers that may be text, "3/5". */
export type ExactFrame =
  | { type: Frame["type"]; orig: Exact[]; comp: Exact[][]; vel?: Exact[] }
  | { type: Frame["type"]; points: Exact[][]; vel?: Exact[] };
export type Contact = "closed" | "open";
export type Norm = "euclidean" | "max";
type Interval = [lower: number, upper: number];

export interface Meeting {
  /** null: not decided. */
  meet: boolean | null;
  /** Of the common points, of their coordinates in the second frame, of the time; rounded outward. */
  world?: Interval[];
  inside?: Interval[] | null;
  time?: Interval | null;
  witness?: number[];
}

/** A mesh in the engine's memory. */
export class Mesh {
  readonly corners: 3 | 4;
  readonly size: number;
  readonly points: Float64Array;
  readonly cells: Uint32Array;
  face(cell: number): number;
  free(): void;
}

/** The text or bytes of an OFF, OBJ, PLY, STL or medit file, arrays, or a mesh. */
export type MeshLike = string | Uint8Array | Mesh
  | { points: number[][] | ArrayLike<number>; cells: number[][] | ArrayLike<number>; corners?: 3 | 4 };

export interface MeshHits {
  hits: { a: number; b: number; shared: number; how: "share" | "touch" | "cross" | "coplanar" }[];
  tested: number;
  stop: Answer["stop"];
}

export interface Library {
  readonly version: string;
  system(from: SystemLike, options?: { format?: Format }): System;
  solve(from: SystemLike, options?: Options): Solution;
  project(from: SystemLike, keep: Variable[], options?: Options): Projection;
  bounds(from: SystemLike, variables?: Variable[], options?: Options): Bounds;
  /** A form as text or as coefficients; without one, what the system says. */
  optimize(from: SystemLike, what?: { max: string | number[] } | { min: string | number[] }, options?: Options): Optimum;
  reduce(from: SystemLike, options?: Options): Reduction;
  vertices(from: SystemLike, options?: Options): Vertices;
  /** Does that proof hold of the system? */
  check(from: SystemLike, proof: string): Judgement;
  intersect(a: Frame, b: Frame, options?: { contact?: Contact }): Meeting;
  /** Bounds of x1, x2, ... and of the time t over the common points, as fractions. */
  exactBox(a: ExactFrame, b: ExactFrame, options?: Options & { contact?: Contact }): Bounds;
  systemOfFrames(a: ExactFrame, b: ExactFrame, options?: { contact?: Contact }): System;
  distance(a: Frame, b: Frame, options?: Options & { norm?: Norm }):
    Answer & { length?: number; measure?: Fraction; points?: Fraction[][]; time?: Fraction };
  depth(a: Frame, b: Frame, options?: Options & { norm?: Norm }):
    Answer & { length?: number; measure?: Fraction; shift?: Fraction[] };
  /** A row that the first frame satisfies, and the second with >= in the place of <=. */
  separate(a: Frame, b: Frame, options?: Options & { contact?: Contact }): Answer & { row?: Row };
  common(a: Frame, b: Frame, options?: Options): Answer & { vertices?: Fraction[][] };
  mesh(from: MeshLike, options?: { format?: "auto" | "off" | "obj" | "ply" | "stl" | "mesh" }): Mesh;
  /** Cells of a and b that meet; without b, cells of a that meet one another. */
  meshMeet(a: MeshLike, b?: MeshLike | null, options?: { neighbours?: boolean; motion?: number[]; maxSeconds?: number }): MeshHits;
}

/** The library, once for all callers. */
export function load(): Promise<Library>;
/** The same at once, in Node and in workers. */
export function loadNow(): Library;
