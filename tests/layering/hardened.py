"""What hardens libraries and programs is in them. usage: hardened.py READELF CRTI NAME,... FILE...
The names are those that packaging/hardening enabled; a file is a library, a program, or a folder of objects. CRTI
is the object of the C library that every linked file begins with."""

import pathlib
import re
import subprocess
import sys

readelf, crti, names, *files = sys.argv[1:]


def ask(path, *how):
    return subprocess.run([readelf, *how, "-W", path], env={"LC_ALL": "C"}, check=True, capture_output=True,
                          text=True).stdout


def is_marked(notes):
    return "IBT" in notes and "SHSTK" in notes


def objects_without_cet(path):
    """Of an archive or a folder: the linker marks what it makes if all parts are marked."""
    if path.is_dir():
        notes = {o.name: ask(o, "-n") for o in path.rglob("*.o")}
    else:
        parts = re.split(r"^File: .*\((.*)\)$", ask(path, "-n"), flags=re.M)[1:]
        notes = dict(zip(parts[::2], parts[1::2]))
    assert notes, f"{path}: no objects"
    return [name for name, note in notes.items() if not is_marked(note)]


def linked_faults(path):
    """Names of what a library or a program lacks."""
    segments, dynamic, symbols = ask(path, "-l"), ask(path, "-d"), ask(path, "--dyn-syms")
    called = set(re.findall(r" UND (\w+_chk\w*)", symbols))
    flags = " ".join(re.findall(r"\(FLAGS(?:_1)?\) +(.*)", dynamic))
    found = {
        "pie": "INTERP" not in segments or re.search(r"\bPIE\b", flags),
        "relro": "GNU_RELRO" in segments,
        "now": re.search(r"\bNOW\b", flags),
        "stack": re.search(r"GNU_STACK .* RW +0x", segments),
        "canaries": "__stack_chk_fail" in called,
        "fortified": called - {"__stack_chk_fail"},
        "cet": not is_marked(ask(crti, "-n")) or is_marked(ask(path, "-n")),
    }
    return [name for name in names.split(",") if not found[name]]


def main():
    faults = []
    for path in map(pathlib.Path, files):
        if not path.is_dir() and path.suffix != ".a":
            faults += [f"{path}: not hardened: {name}" for name in linked_faults(path)]
        elif "cet" in names.split(","):
            lacking = objects_without_cet(path)
            faults += [f"{path}: no IBT and SHSTK in {', '.join(lacking)}"] if lacking else []
    print("\n".join(faults) or f"{len(files)} files: {names}")
    return 1 if faults else 0


sys.exit(main())
