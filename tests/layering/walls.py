"""The walls of the house: which room includes which, that no files form a ring, how large a folder is, what static
functions are called, what a public header needs, what the library exports, that every public function is
mentioned in a test, that no tag, header or function has a name for two things, and that public names
go together. usage: walls.py CHECK ROOT [LIBRARY... [NODE]]
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# Rooms include only rooms to their left (and themselves).
ORDER = "base num system trace proof rule elim dd lp symmetry hull lift solve frame proximity pair mesh io".split()
# The checker is the trusted base: it sees no more than it needs. Rules see what users' rules see: the
# public headers.
ONLY = {"proof": {"base", "num", "system", "proof"}, "rule": {"rule"}}
# Elimination is handed rules; it knows none.
NEVER = {"elim": {"rule"}}
# Folders inside a room that include only those to their left; the rest of the room may see them all.
FOLDERS = {"elim": "store history rules round".split(),
           "lp": "model linalg simplex oracle redundancy".split(),
           "hull": "facets image support section".split(),
           "solve": "session query limit portfolio project".split()}

# What programs compile of the library: they see no other private header.
SHARED = {"base/clock.h", "base/line.h", "io/core/utf8.h", "num/int128.h"}
# What the language or GMP lacks on some targets; these know no room, and rules include them, too.
LACKED = {"num/int128.h", "num/word.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)
DECLARATION = re.compile(r"FMB_API\b([^;{]*?)\b(fmb_\w+)\s*\(([^;{]*)\)\s*;", re.S)
FUNCTION = re.compile(r"FMB_API\b[^;{]*?\b(fmb_\w+)\s*\(", re.S)
COMMENT = re.compile(r"/\*.*?\*/", re.S)


def sources(folder):
    return sorted(p for p in folder.rglob("*.[ch]"))


def room_faults(root, path, room):
    for bracket, name in INCLUDE.findall(path.read_text()):
        if f"{room}/{path.name}" in LACKED and bracket == '"' and name not in LACKED:
            yield f'"{name}": {path.name} knows no room'
        if bracket == "<":
            if not name.startswith("fmb/") and (root / "lib" / name).exists():
                yield f"<{name}> is a private header: write \"{name}\""
            continue
        target = name.split("/")[0]
        if name in LACKED:
            continue
        if "/" not in name or target not in ORDER:
            yield f'"{name}": write "room/file.h"'
        elif ORDER.index(target) > ORDER.index(room):
            yield f'"{name}": {room} stands below {target}'
        elif target not in ONLY.get(room, ORDER):
            yield f'"{name}": {room} may not know {target}'
        elif target in NEVER.get(room, ()):
            yield f'"{name}": {room} may not know {target}'
        elif target == room:
            folders = FOLDERS.get(room, [])
            place = path.parts[len(path.parts) - 1 - path.parts[::-1].index(room) + 1]
            ranks = [folders.index(f) for f in (place, name.split("/")[1]) if f in folders]
            if ranks != sorted(ranks, reverse=True):
                yield f'"{name}": {room}/{path.parent.name} stands below it'


def rooms(root):
    lib = root / "lib"
    for folder in sorted(p for p in lib.iterdir() if p.is_dir()):
        if folder.name not in ORDER:
            yield f"{folder}: no room of that name is in the picture"
            continue
        for path in sources(folder):
            for fault in room_faults(root, path, folder.name):
                yield f"{path}: {fault}"
    for path in sources(root / "apps"):
        own = {"common", "fmb"}
        for laboratory in ("fmb-qualify", "fmb-validate"):
            if laboratory in path.relative_to(root).parts:
                own |= {laboratory, "study"}
        for bracket, name in INCLUDE.findall(path.read_text()):
            if bracket == '"' and name.split("/")[0] not in own and name not in SHARED:
                yield f'{path}: "{name}": a command sees public headers only'
            if path.name == "cmd_check.c" and re.match(r"fmb/(solve|options|trace|fmb)\.h", name):
                yield f"{path}: <{name}>: the checker knows nothing that solves"


def circles(uses):
    """Strongly connected components of more than one node (Tarjan 1972), sorted."""
    number, low, stack, found = {}, {}, [], []

    def visit(node):
        number[node] = low[node] = len(number)
        stack.append(node)
        for other in sorted(uses.get(node, ())):
            if other not in number:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], number[other])
        if low[node] == number[node]:
            circle = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(circle) > 1:
                found.append(sorted(circle))

    for node in sorted(uses):
        if node not in number:
            visit(node)
    return sorted(found)


def includes(root):
    """No file, and no folder of the library, includes itself through others."""
    for top in ("lib", "apps", "bench"):
        uses, folders = {}, {}
        for path in sources(root / top):
            names = {n for b, n in INCLUDE.findall(path.read_text()) if b == '"'}
            place = path.relative_to(root / top)
            uses[str(place)] = names
            folder = folders.setdefault(str(place.parent), set())
            folder |= {n.rpartition("/")[0] for n in names} - {str(place.parent)}
        for circle in circles(uses) + (circles(folders) if top == "lib" else []):
            yield f"{top}: include each other: {', '.join(circle)}"


MOST_FILES = 20


def sizes(root):
    """A folder has so many sources and headers at most; a file's name is there once in the library."""
    folders, places = {}, {}
    for path in sources(root / "lib"):
        folders.setdefault(path.parent, []).append(path)
        places.setdefault(path.name, []).append(path)
    for folder, paths in sorted(folders.items()):
        if len(paths) > MOST_FILES:
            yield f"{folder} has {len(paths)} files"
    for name, paths in sorted(places.items()):
        if len(paths) > 1:
            yield f"file {name} stands in {', '.join(str(p) for p in paths)}"


def unit_uses(root):
    """What each unit of the library, a .c with its .h, includes; and units by the names of their objects."""
    uses, objects = {}, {}
    for path in sources(root / "lib"):
        place = path.relative_to(root / "lib")
        unit = str(place)[:-2]
        if path.suffix == ".c":
            objects[str(place).replace("/", "_") + ".o"] = unit
        names = {n[:-2] for b, n in INCLUDE.findall(path.read_text()) if b == '"'}
        uses.setdefault(unit, set()).update(names - {unit})
    return uses, objects


def rings(root, *libraries):
    """No object files of a library or program call each other in a circle, and no units of the library use each
    other in one, by includes and calls together."""
    units, objects = unit_uses(root)
    for library in libraries:
        owner, wanted = {}, {}
        paths = [library]
        if pathlib.Path(library).is_dir():  # objects of a program
            paths = sorted(pathlib.Path(library).rglob("*.o"))
        lines = subprocess.run(["nm", "-A", "-P", *paths], capture_output=True, text=True,
                               check=True).stdout.splitlines()
        for line in lines:
            place, symbol = line.split(": ", 1)
            name, kind = symbol.split()[:2]
            place = place.split("[")[-1].rstrip("]")
            if kind == "U":
                wanted.setdefault(place, set()).add(name)
            elif kind.isupper():
                owner[name] = place
        uses = {place: {owner[n] for n in names if owner.get(n, place) != place}
                for place, names in wanted.items()}
        for circle in circles(uses):
            yield f"{library}: call each other: {', '.join(circle)}"
        for place in uses.keys() & objects.keys():
            units[objects[place]] |= {objects[o] for o in uses[place] if o in objects}
    for circle in circles(units):
        yield f"use each other: {', '.join(circle)}"


STATIC = re.compile(r"^(?:[A-Z\d]+ )?(?:static|FMB_INLINE) (?:inline )?[\w ]*?[ *]?(\w+)\(", re.M)


def static_names(root):
    """(room, name, path) of every static function of the library."""
    for path in sources(root / "lib"):
        for name in STATIC.findall(COMMENT.sub("", path.read_text())):
            yield path.relative_to(root / "lib").parts[0], name, path


def names(root):
    """A static function's name stands once in its room; half of them have 13 letters and more."""
    places, lengths = {}, []
    for room, name, path in static_names(root):
        places.setdefault((room, name), set()).add(path)
    for (room, name), paths in sorted(places.items()):
        lengths.append(len(name))
        if len(paths) > 1:
            yield f"{name} stands in {', '.join(str(p) for p in sorted(paths))}"
    lengths.sort()
    if lengths and lengths[len(lengths) // 2] < 13:
        yield f"the median name of a static function has {lengths[len(lengths) // 2]} letters"


TAG = re.compile(r"^(?:typedef )?(?:struct|union|enum) (\w+) \{", re.M)
DECLARED = re.compile(r"^(?!static|typedef|#)(?:[A-Za-z_][\w ]*[ *]+)(fmb_\w+)\([^;{]*\)\s*;", re.M | re.S)


def once(root):
    """A tag has one layout, a header's name stands for one file, a function is declared in one place."""
    tags, headers_by_name, functions = {}, {}, {}
    for path in sources(root / "include") + sources(root / "lib"):
        text = COMMENT.sub("", path.read_text())
        for tag in TAG.findall(text):
            tags.setdefault(tag, []).append(path)
        if path.suffix == ".h":
            headers_by_name.setdefault(path.name, []).append(path)
            for name in DECLARED.findall(text):
                functions.setdefault(name, []).append(path)
    for what, places in (("tag", tags), ("header", headers_by_name), ("function", functions)):
        for name, paths in sorted(places.items()):
            if len(paths) > 1:
                yield f"{what} {name} stands in {', '.join(str(p) for p in paths)}"


WAY = re.compile(r'WAY\((\w+),((?:\s|\\|"[^"]*"|,)*)\)')


def ways(root):
    """Each way (base/ways.h) has files that are there and is asked somewhere; docs/ways.md has a row for it."""
    lib = root / "lib"
    table = (root / "docs/ways.md").read_text()
    code = "".join(path.read_text() for path in sources(lib) if path.name != "ways.h")
    for identifier, rest in WAY.findall((lib / "base/ways.h").read_text()):
        texts = [re.sub(r'"\s*\\?\s*"', "", field).strip(' "\\\n') for field in rest.split(",")[:2]]
        name, files = texts
        for file in files.split():
            if not any(lib.glob(f"{file}.[ch]")):
                yield f"way {name}: there is no lib/{file}"
        if not re.search(rf"(?<!fmb_way_answered\()FMB_WAY_{identifier}\b", code): # a call, or a table that one reads
            yield f"way {name}: nothing asks it"
        if f"| {name} " not in table:
            yield f"way {name}: docs/ways.md has no row for it"


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


def exports(root, library, node):
    """What public headers declare, no more and no less, in the node of this version of the library."""
    out = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True,
                         check=True).stdout
    exported = set()
    for line in out.splitlines():
        name, _, version = line.split()[-1].partition("@@")
        if name == node:  # which is a symbol itself
            continue
        exported.add(name)
        if version != node and not name.startswith("__"):
            yield f"{name} is of version {version or 'none'}, not {node}"
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


# Words of the library's past that nobody can guess, and the field's: no file, function or tag bears one.
FORMER = {
    "awake": "active set", "crew": "workers", "dear": "expensive", "door": "backend",
    "findings": "result log", "gauge": "membership program", "gentle": "bound on growth", "glimpse": "guess",
    "grid": "rounding to a lattice", "judge": "selection",
    "ladder": "portfolio", "lazy": "active set", "lifts": "preimages", "margin": "interior program",
    "peak": "optimum of a component", "reals": "scaled program", "refuter": "Farkas by refinement",
    "scouts": "workers", "sieve": "ray shooting",
    "sift": "ray shooting", "spread": "indexed vector", "stand": "simplex state", "steep": "bound on growth",
    "thin": "irredundant", "tired": "iteration limit", "twins": "parallel rows", "wall": "artificial",
    "wider": "objective column"}
# Those that mean something else elsewhere, by the room where they are of the past.
FORMER_IN = {
    "lp": {"around": "in order of angles", "blocks": "spatial blocks", "corner": "basis inverse",
           "corners": "basis inverses", "escape": "recession directions",
           "exchange": "pivot", "extreme": "optimum",
           "lists": "compressed rows", "named": "nonzero columns", "own": "revised simplex", "polar": "polar points",
           "refute": "Farkas by refinement", "triangles": "LU with updates", "whole": "integers"},
    "num": {"whole": "integers"}, "proof": {"whole": "complete"}, "proximity": {"around": "in order of angles"},
    "solve": {"around": "in order of angles", "escape": "recession directions", "grid": "lattice"},
    "system": {"whole": "integers"}}
# ... and what the field's own words have of them.
FIELD = {"polar_points", "spatial_blocks", "bound_blocks", "blocks_sooner"}
SPOKEN = re.compile(r"^(?!typedef|#|return|else)(?:[A-Za-z_][\w ]*[ *]+)(\w+)\([^;{]*\)\s*[;{]", re.M | re.S)


def former(root):
    """(name, path) of what bears one of those words."""
    for path in sources(root / "lib"):
        text = COMMENT.sub("", path.read_text())
        for name in sorted({path.stem, *SPOKEN.findall(text), *STATIC.findall(text), *TAG.findall(text)}):
            former = FORMER | FORMER_IN.get(path.relative_to(root / "lib").parts[0], {})
            if any(word in name for word in FIELD):
                continue
            for word in former.keys() & set(name.split("_")):
                yield f"{path}: {name} says {word}; in the field's words: {former[word]}"


GIVEN = re.compile(r"(?<!const )\bfmb_(\w+) \*\*")
RELEASE = re.compile(r"_(close|delete|destroy|discard|dispose|finish|release)$")


def words(root):
    """Public names that go together: what a function gives out has a *_free, nothing is released by another
    word (*_clear: what a structure of the caller's holds), and what has functions that refuse arguments has a
    *_trouble that says why, unless they tell an fmb_where. No name in the library says one of the words in FORMER."""
    free, refusing, declared = set(), set(), public_functions(root)
    for header in sorted((root / "include").glob("fmb/*.h")):
        for kind, name, text in DECLARATION.findall(COMMENT.sub("", header.read_text())):
            parameters = [" ".join(p.split()) for p in text.split(",")]
            free |= {what for p in parameters for what in GIVEN.findall(p)}
            owner = re.match(r"fmb_(\w+) \*\w+$", parameters[0])
            if owner and "fmb_status" in kind and len(parameters) > 1 and "fmb_where" not in text:
                refusing.add(owner.group(1))
    for name in sorted(declared):
        if RELEASE.search(name):
            yield f"{name}: released by free (objects) or clear (what a structure holds), nothing else"
    for what in sorted(free):
        if f"fmb_{what}_free" not in declared:
            yield f"fmb_{what} is handed out, but there is no fmb_{what}_free"
    for what in sorted(refusing & {n[4:-5] for n in declared if n.endswith("_free")}):
        if f"fmb_{what}_trouble" not in declared:
            yield f"fmb_{what} refuses arguments, but there is no fmb_{what}_trouble"
    yield from former(root)


def selftest(_root):
    """Each check finds the fault it is there for."""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        bad = {
            "lib/proof/a.c": '#include "elim/store/store.h"\n',
            "lib/elim/b.c": '#include "rule/rule_private.h"\n',
            "lib/elim/store/b.c": '#include "elim/round/elim.h"\n',
            "lib/rule/h.c": '#include "num/vec.h"\n',
            "lib/base/c.c": '#include "num/vec.h"\n',
            "lib/num/one/i.c": '#include "num/two/j.h"\n',
            "lib/num/word.h": '#include "num/vec.h"\n',
            "lib/num/two/k.c": '#include "num/one/l.h"\n',
            "lib/attic/d.c": "",
            "apps/fmb/e.c": '#include "num/vec.h"\n',
            "apps/fmb/cmd_check.c": "#include <fmb/solve.h>\n",
            "include/fmb/f.h": "size_t f(void);\nFMB_API int fmb_forgotten(int a,\n    int b);\n",
            "lib/base/twice.h": "struct fmb_twice {\n};\nint fmb_twofold(void);\n",
            "lib/num/twice.h": "typedef struct fmb_twice {\n} fmb_twice;\nint fmb_twofold(\n    int a);\n",
            "tests/g.c": "",
            **{f"lib/num/many/a{k}.c": "" for k in range(21)},
            "include/fmb/given.h": "FMB_API fmb_status fmb_thing_new(fmb_thing **out);\n"
                                   "FMB_API void fmb_thing_close(fmb_thing *t);\n"
                                   "FMB_API fmb_status fmb_other_add(fmb_other *o, int a);\n"
                                   "FMB_API void fmb_other_free(fmb_other *o);\n",
            "lib/num/glimpse.c": "static int sift_down(int a);\nstruct fmb_judge {\n};\n",
            "lib/base/ways.h": '#define FMB_WAYS(WAY) \\\n    WAY(A, "one way", "base/c base/gone", \\\n        "about")\n',
            "docs/ways.md": "",
        }
        for path, content in bad.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(content)
        for check, expected in ((rooms, 9), (headers, 4), (mentioned, 5), (once, 3), (words, 6), (ways, 3),
                                (sizes, 3)):
            found = list(check(root))
            if len(found) != expected:
                yield f"{check.__name__} found {len(found)} of {expected} faults: {found}"


def main():
    check, root, *rest = sys.argv[1:]
    faults = list(globals()[check](pathlib.Path(root), *rest))
    print("\n".join(faults) or f"{check}: no faults")
    return 1 if faults else 0


sys.exit(main())
