// before.js: adapts Node's files to the command's needs.

// Standard streams can be asked what they are; terminals, in most cases they are not. Programs without files, with
// which Meson tries the compiler, have no FS.
Module.onRuntimeInitialized = () =>
  typeof FS === "undefined" ||
  ["/dev/stdin", "/dev/stdout", "/dev/stderr"].forEach((path, k) => {
    Object.assign(FS.streams[k], { path, tty: require("tty").isatty(k) });
  });

// A write to a closed pipe ends the command silently; a write to a full pipe waits.
if (typeof process === "object") {
  const fs = require("fs"), write = fs.writeSync;
  fs.writeSync = (...args) => {
    for (;;)
      try {
        return write(...args);
      } catch (error) {
        if (error.code === "EPIPE") process.exit(141);
        if (error.code !== "EAGAIN") throw error;
      }
  };
}
