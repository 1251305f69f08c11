"""The walls of the house: which room includes which, what a public header needs, what the library
exports, and that every public function is mentioned in a test. usage: walls.py CHECK ROOT [LIBRARY]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# Rooms include only rooms to their left (and themselves).
ORDER = "base num system trace proof exact rule elim lp solve frame pair io study".split()
# The checker is the trusted base: it sees no more than it needs. Rules see what users' rules see: the
# public headers.
ONLY = {"proof": {"base", "num", "system", "proof"}, "rule": {"rule"}}
# Elimination is handed rules; it knows none.
NEVER = {"elim": {"rule"}}

INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)
FUNCTION = re.compile(r"FMB_API\b[^;{]*?\b(fmb_\w+)\s*\(", re.S)
COMMENT = re.compile(r"/\*.*?\*/", re.S)


def sources(folder):
    return sorted(p for p in folder.rglob("*.[ch]"))


def room_faults(path, room):
    for bracket, name in INCLUDE.findall(path.read_text()):
        if bracket == "<":
            if not name.startswith("fmb/") and (path.parent.parent / name).exists():
                yield f"<{name}> is a private header: write \"{name}\""
            continue
        target = name.split("/")[0]
        if "/" not in name or target not in ORDER:
            yield f'"{name}": write "room/file.h"'
        elif ORDER.index(target) > ORDER.index(room):
            yield f'"{name}": {room} stands below {target}'
        elif target not in ONLY.get(room, ORDER):
            yield f'"{name}": {room} may not know {target}'
        elif target in NEVER.get(room, ()):
            yield f'"{name}": {room} may not know {target}'


def rooms(root):
    lib = root / "lib"
    for folder in sorted(p for p in lib.iterdir() if p.is_dir()):
        if folder.name not in ORDER:
            yield f"{folder}: no room of that name is in the picture"
            continue
        for path in sources(folder):
            for fault in room_faults(path, folder.name):
                yield f"{path}: {fault}"
    for path in sources(root / "apps"):
        own = {"common", "fmb"}
        for laboratory in ("qualify", "validate"):
            if laboratory in (*path.relative_to(root).parts, path.stem.removeprefix("fmb-")):
                own |= {laboratory, "study"}
        for bracket, name in INCLUDE.findall(path.read_text()):
            if bracket == '"' and name.split("/")[0] not in own:
                yield f'{path}: "{name}": a command sees public headers only'
            if path.name == "cmd_check.c" and re.match(r"fmb/(solve|options|trace|fmb)\.h", name):
                yield f"{path}: <{name}>: the checker knows nothing that solves"


def headers(root):
    include = root / "include"
    compilers = (["gcc", "-std=c11", "-x", "c"], ["g++", "-std=c++17", "-x", "c++"])
    for header in sorted(include.glob("fmb/*.h")):
        for compiler in compilers:
            strict = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I", include]
            run = subprocess.run([*compiler, *strict, "-include", header, "/dev/null"],
                                 capture_output=True, text=True)
            if run.returncode:
                yield f"{header} alone with {compiler[0]}: {run.stderr.strip()}"


def public_functions(root):
    names = set()
    for header in sorted((root / "include").glob("fmb/*.h")):
        names |= set(FUNCTION.findall(COMMENT.sub("", header.read_text())))
    return names


def exports(root, library):
    out = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True,
                         check=True).stdout
    exported = {line.split()[-1].split("@")[0] for line in out.splitlines()}
    declared = public_functions(root)
    for name in sorted(exported - declared):
        if not name.startswith("__"):  # what sanitizers add
            yield f"{name} is exported, but no public header declares it"
    for name in sorted(declared - exported):
        yield f"{name} is declared in a public header, but not exported"


def mentioned(root):
    text = "\n".join(p.read_text() for p in sources(root / "tests"))
    words = set(re.findall(r"\w+", text))
    for name in sorted(public_functions(root) - words):
        yield f"{name}: no test mentions it"


def selftest(_root):
    """Each check finds the fault it is there for."""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        bad = {
            "lib/proof/a.c": '#include "elim/elim.h"\n',
            "lib/elim/b.c": '#include "rule/rule.h"\n',
            "lib/rule/h.c": '#include "num/vec.h"\n',
            "lib/base/c.c": '#include "num/vec.h"\n',
            "lib/attic/d.c": "",
            "apps/fmb/e.c": '#include "num/vec.h"\n',
            "apps/fmb/cmd_check.c": "#include <fmb/solve.h>\n",
            "include/fmb/f.h": "size_t f(void);\nFMB_API int fmb_forgotten(int a,\n    int b);\n",
            "tests/g.c": "",
        }
        for path, content in bad.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(content)
        for check, expected in ((rooms, 7), (headers, 2), (mentioned, 1)):
            found = list(check(root))
            if len(found) != expected:
                yield f"{check.__name__} found {len(found)} of {expected} faults: {found}"


def main():
    check, root, *rest = sys.argv[1:]
    faults = list(globals()[check](pathlib.Path(root), *rest))
    print("\n".join(faults) or f"{check}: no faults")
    return 1 if faults else 0


sys.exit(main())
