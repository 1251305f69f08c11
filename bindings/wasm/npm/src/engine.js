// The library as WebAssembly, for any host: it needs only a clock.
import bytes from "./engine.wasm";

// System calls that C libraries may import, and their answers without a system.
const NO_SUCH_FILE = 8;
const SYSTEM = {
  fd_close: () => NO_SUCH_FILE,
  fd_read: () => NO_SUCH_FILE,
  fd_seek: () => NO_SUCH_FILE,
  fd_write: () => NO_SUCH_FILE,
  emscripten_notify_memory_growth: () => {},
};

function importsOf(module, state) {
  const known = {
    ...SYSTEM,
    clock_time_get: (_clock, _precision, at) => {
      const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
      new DataView(state.exports.memory.buffer).setBigUint64(at, nanoseconds, true);
      return 0;
    },
    proc_exit: (code) => {
      throw new Error(`libfmb ended with code ${code}`);
    },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    const missing = () => {
      throw new Error(`libfmb asks for ${name}, which is not here`);
    };
    (imports[from] ??= {})[name] = known[name] ?? missing;
  }
  return imports;
}

function begin(module, instance, state) {
  state.exports = instance.exports;
  instance.exports._initialize?.();
  return instance.exports;
}

export async function startEngine() {
  const module = await WebAssembly.compile(bytes), state = {};
  return begin(module, await WebAssembly.instantiate(module, importsOf(module, state)), state);
}

// Synchronously, in workers and in Node; pages may compile only asynchronously.
export function startEngineNow() {
  const module = new WebAssembly.Module(bytes), state = {};
  return begin(module, new WebAssembly.Instance(module, importsOf(module, state)), state);
}
