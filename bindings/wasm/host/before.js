// before.js: standard streams are files as others are, so that the command can ask what they are.
Module.onRuntimeInitialized = () =>
  ["/dev/stdin", "/dev/stdout", "/dev/stderr"].forEach((path, k) => {
    FS.streams[k].path = path;
  });
