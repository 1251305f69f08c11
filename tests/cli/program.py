"""Compile the C program of the README and run it: against the build tree, and against an
installation, as its users do it. usage: program.py ROOT BUILD"""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
program, expected = re.search(r"```c\n(.*?)```.*?```text\n(.*?)```", (root / "README.md").read_text(),
                              re.S).groups()
assert len(program.splitlines()) <= 12, "the README promises 12 lines"


def call(command, **env):
    run = subprocess.run(command, env={**os.environ, **env}, capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{command}:\n{run.stdout}{run.stderr}")
    return run.stdout


def try_program(folder, name, flags, libraries):
    """Compile the program with the flags of pkg-config and run it."""
    source, binary = folder / f"{name}.c", folder / name
    source.write_text(program)
    strict = ["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    call(["gcc", *strict, *flags, str(source), "-o", str(binary), *flags])
    found = call([str(binary)], LD_LIBRARY_PATH=str(libraries))
    assert found == expected, f"{name}: {found!r} instead of {expected!r}"


def can_link(folder, flags):
    """Are these libraries there?"""
    empty = folder / "empty.c"
    empty.write_text("int main(void) { return 0; }\n")
    return subprocess.run(["gcc", str(empty), "-o", str(folder / "empty"), *flags],
                          capture_output=True).returncode == 0


def sanitizers():
    """A sanitized library wants a sanitized program."""
    config = call(["meson", "introspect", "--buildoptions", str(build)])
    value = re.search(r'"name": "b_sanitize", "value": "([a-z,]*)"', config)
    return [f"-fsanitize={value[1]}"] if value and value[1] != "none" else []


with tempfile.TemporaryDirectory() as name:
    scratch = pathlib.Path(name)
    extra = sanitizers()
    include, lib = root / "include", build / "lib"
    try_program(scratch, "built", [f"-I{include}", f"-L{lib}", "-lfmb", *extra], lib)

    home = scratch / "home"
    call(["meson", "install", "-C", str(build), "--no-rebuild", "--destdir", str(home)])
    pc = next(home.rglob("fmb.pc"))
    flags = shlex.split(call(["pkg-config", "--cflags", "--libs", "fmb"],
                             PKG_CONFIG_PATH=str(pc.parent), PKG_CONFIG_SYSROOT_DIR=str(home)))
    try_program(scratch, "installed", [*flags, *extra], next(home.rglob("libfmb.so")).parent)

    # Statically, but under sanitizers, which cannot.
    flags = shlex.split(call(["pkg-config", "--static", "--cflags", "--libs", "fmb"],
                             PKG_CONFIG_PATH=str(pc.parent), PKG_CONFIG_SYSROOT_DIR=str(home)))
    needed = [f for f in flags if f.startswith("-l") and f != "-lfmb"]
    static = not extra and can_link(scratch, ["-static", *needed])
    if static:
        try_program(scratch, "static", ["-static", *flags], scratch)

    installed = {p.name for p in home.rglob("*") if p.is_file() or p.is_symlink()}
    wanted = {"fmb", "fmb.h", "gmp.h", "libfmb.a", "libfmb.so", "fmb.1", "fmb_solve.3", "fmb.pc", "LICENSE",
              "theory.md", "breakfast.fmb", "same_rows.c", "_fmb", "fmb.fish"}
    assert wanted <= installed, f"not installed: {wanted - installed}"
print("built, installed" + ", static" * static + ": the program says", expected.strip())
