// libfmb: systems of linear inequalities, answered exactly and with proofs; frames and meshes.
import { startEngine, startEngineNow } from "./engine.js";
import { Memory, FmbError } from "./memory.js";
import { Fraction } from "./fraction.js";
import { System, systemOf } from "./system.js";
import { Mesh, meshMeet, meshOf } from "./mesh.js";
import { check } from "./proof.js";
import * as questions from "./questions.js";
import * as frames from "./frames.js";

export { FmbError, Fraction, Mesh, System };

// The library, loaded. Systems are given as text, as arrays, or as System.
class Library {
  #memory;

  constructor(c) {
    this.#memory = new Memory(c);
    this.version = this.#memory.textAt(c.fmb_version());
  }

  // Runs ask(system) on the given system, which is freed if it was made here.
  #with(from, ask) {
    const system = systemOf(this.#memory, from);
    try {
      return ask(system);
    } finally {
      if (system !== from) system.free();
    }
  }

  system(from, options) {
    return systemOf(this.#memory, from, options);
  }

  solve(from, options) {
    return this.#with(from, (s) => questions.solve(this.#memory, s, options));
  }

  project(from, keep, options) {
    return this.#with(from, (s) => questions.project(this.#memory, s, keep, options));
  }

  bounds(from, variables, options) {
    return this.#with(from, (s) => questions.bounds(this.#memory, s, variables, options));
  }

  optimize(from, what, options) {
    return this.#with(from, (s) => questions.optimize(this.#memory, s, what, options));
  }

  reduce(from, options) {
    return this.#with(from, (s) => questions.reduce(this.#memory, s, options));
  }

  vertices(from, options) {
    return this.#with(from, (s) => questions.vertices(this.#memory, s, options));
  }

  check(from, proof) {
    return this.#with(from, (s) => check(this.#memory, s, proof));
  }

  intersect(a, b, options) {
    return frames.intersect(this.#memory, a, b, options);
  }

  exactBox(a, b, options) {
    return frames.exactBox(this.#memory, a, b, options);
  }

  systemOfFrames(a, b, options) {
    return frames.systemOfFrames(this.#memory, a, b, options);
  }

  distance(a, b, options) {
    return frames.distance(this.#memory, a, b, options);
  }

  depth(a, b, options) {
    return frames.depth(this.#memory, a, b, options);
  }

  separate(a, b, options) {
    return frames.separate(this.#memory, a, b, options);
  }

  common(a, b, options) {
    return frames.common(this.#memory, a, b, options);
  }

  mesh(from, options) {
    return meshOf(this.#memory, from, options);
  }

  meshMeet(a, b, options) {
    const made = [a, b].map((m) => (m ? meshOf(this.#memory, m) : null));
    try {
      return meshMeet(this.#memory, made[0], made[1], options);
    } finally {
      made.forEach((m, k) => m && m !== [a, b][k] && m.free());
    }
  }
}

let loading;

// Loaded once for all callers.
export function load() {
  return (loading ??= startEngine().then((exports) => new Library(exports)));
}

// Synchronously, where that is allowed: in workers and in Node.
export function loadNow() {
  return new Library(startEngineNow());
}
