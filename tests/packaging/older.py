"""Programs compiled with the headers on record run with today's library: what a user built on the release before goes on.
older.py record ROOT RECORD                        records headers and programs of the sources at ROOT
older.py run RECORD LIBRARY JUDGE FMB COMPILER...  JUDGE is bindings.py of tests/cli, FMB the command, or - for none
The same day as the binary interface (abi.py): ninja abi-record does both."""

import pathlib
import subprocess
import sys
import tarfile
import tempfile

# A program that solves, projects and reads rows back, and a rule that the command loads.
FILES = ("include/fmb/*.h", "docs/examples/bindings/rows.c", "docs/examples/bindings/ring.h",
         "docs/examples/rules/same_rows.[ch]", "docs/examples/rules/look_ahead.[ch]",
         "docs/examples/rules/rule_library.c", "docs/examples/breakfast.fmb")


def record(root, archive):
    """The same files make the same bytes."""
    def nameless(entry):
        entry.mtime = entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mode = 0o644
        return entry

    with tarfile.open(archive, "w:xz", preset=9) as out:
        for path in sorted(p for pattern in FILES for p in root.glob(pattern)):
            out.add(path, path.relative_to(root), filter=nameless)
    print(f"{archive}: {archive.stat().st_size} bytes")


def call(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def run(folder, library, judge, fmb, *compiler):
    flags = ["-std=c11", "-Wall", "-Werror", "-I", folder / "include"]
    program = folder / "docs/examples/bindings/rows.c"
    call(*compiler, *flags, program, "-o", folder / "rows", library, "-lgmp")
    environment = {"LD_LIBRARY_PATH": str(pathlib.Path(library).parent), "PATH": "/usr/bin:/bin"}
    call(sys.executable, "-B", judge, program, folder / "rows", env=environment)
    print("a program of the headers on record: as it was")
    if fmb != "-":
        rule = folder / "same_rows.so"
        sources = sorted((folder / "docs/examples/rules").glob("*.c"))
        call(*compiler, *flags, "-shared", "-fPIC", *sources, "-o", rule)
        said = call(fmb, "solve", "--method", "fm", "--rule-library", rule, "--rules", "same-rows",
                    folder / "docs/examples/breakfast.fmb")
        if not said.startswith("feasible\n"):
            sys.exit(f"with a rule of the headers on record: {said}")
        print("a rule of the headers on record: as it was")


def main():
    what, *rest = sys.argv[1:]
    if what == "record":
        record(*map(pathlib.Path, rest))
        return
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with tarfile.open(rest[0]) as archive:
            archive.extractall(folder)
        run(folder, *rest[1:])


main()
