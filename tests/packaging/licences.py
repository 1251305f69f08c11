"""Each file has a licence, what is under the LGPL needs nothing that is not, and all places that tell a licence tell the
same: licences.py ROOT. packaging/debian/copyright is judge, for REUSE by the name .reuse/dep5."""

import fnmatch
import json
import os
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
LESSER, FULL = "LGPL-3.0-or-later", "GPL-3.0-or-later"
# What a build needs of the LGPL; the rest of the tree is not asked.
LIBRARY = ("include", "lib", "bindings")
INCLUDE = re.compile(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]', re.M)
# Headers of other libraries under the GPL, and folders of ours.
OTHERS = re.compile(r"gsl/|glpk\.h|(apps|bench|tests)/")


def text(path):
    return (root / path).read_text(encoding="utf-8")


def paragraphs():
    """(patterns, licence) of the files that a paragraph names, and the licences whose terms stand there."""
    named, terms = [], set()
    for paragraph in re.split(r"\n\n+", text("packaging/debian/copyright")):
        fields = dict(re.findall(r"^([\w-]+):((?:.*)(?:\n .*)*)", paragraph, re.M))
        if "Files" in fields:
            named.append((fields["Files"].split(), fields["License"].strip()))
        elif "License" in fields:
            terms.add(fields["License"].split()[0])
    return named, terms


def licence(path, named):
    """Of two paragraphs that name a file, the later one counts."""
    found = None
    for patterns, name in named:
        if any(fnmatch.fnmatchcase(path, pattern) for pattern in patterns):
            found = name
    return found


def files():
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in (".git", ".cache", "__pycache__") and not f.startswith("build"))
        for name in sorted(names):
            yield (pathlib.Path(folder) / name).relative_to(root)


def file_faults(named):
    for path in files():
        of_file = licence(str(path), named)
        if of_file not in (LESSER, FULL):
            yield f"{path}: licence {of_file}"
        if (of_file == LESSER) != (path.parts[0] in (*LIBRARY, "packaging") or path.parts[:2] == ("docs", "examples")):
            yield f"{path}: {of_file} is not what LICENSE tells of its folder"
        if path.parts[0] in LIBRARY and path.suffix in (".c", ".h", ".cpp"):
            for name in INCLUDE.findall((root / path).read_text(encoding="utf-8")):
                if OTHERS.match(name):
                    yield f"{path}: {name} is not free under the LGPL"


def faults():
    named, terms = paragraphs()
    yield from file_faults(named)
    if terms != {LESSER, FULL}:
        yield f"packaging/debian/copyright has terms of {sorted(terms)}"
    if text(".reuse/dep5") != text("packaging/debian/copyright"):
        yield ".reuse/dep5 is not packaging/debian/copyright"
    for name in (LESSER, FULL):
        if "GNU" not in text(f"packaging/licenses/{name}.txt")[:100] or f"SPDX: {name}" not in text("LICENSE"):
            yield f"{name}: no text in packaging/licenses, or not in LICENSE"
    both = f"{LESSER} AND {FULL}"
    told = {
        "meson.build": rf"license: \['{LESSER}', '{FULL}'\]",
        "CITATION.cff": rf"(?m)^license: {LESSER}\b",
        "bindings/python/pyproject.toml": rf'license = {{text = "{LESSER}"}}',
        "bindings/wasm/npm/package.json.in": f'"license": "{both}"',
        "packaging/conda/meta.yaml": f"license: {both}\n",
        "packaging/homebrew/fmb.rb": rf'license all_of: \["{LESSER}", "{FULL}"\]',
        "packaging/nix/package.nix": r"\[ lgpl3Plus gpl3Plus \]",
        "README.md": rf"{LESSER}, as GMP",
    }
    for path, pattern in told.items():
        if not re.search(pattern, text(path)):
            yield f"{path}: no {pattern}"
    if json.loads(text("packaging/vcpkg/fmb/vcpkg.json"))["license"] != LESSER: # builds no commands
        yield "packaging/vcpkg/fmb/vcpkg.json: not the library's licence"


wrong = list(faults())
print("\n".join(wrong) or "licences: no faults")
sys.exit(1 if wrong else 0)
