"""Links between documents lead somewhere: in the sources, and where the documents are installed.
usage: links.py ROOT BUILD"""

import json
import os
import pathlib
import re
import subprocess
import sys

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def links(document):
    """Targets of the links of a document that are no addresses, fenced blocks left out."""
    text = re.sub(r"^```.*?^```", "", document.read_text(), flags=re.M | re.S)
    return {t for t in LINK.findall(text) if "://" not in t and not t.startswith("mailto:")}


def documents():
    return [root / "README.md", root / "bench/README.md", root / "bindings/wasm/README.md", *sorted((root / "docs").rglob("*.md"))]


def broken_in_sources():
    for document in documents():
        for target in sorted(links(document)):
            if not (document.parent / target).exists():
                yield f"{document}: {target} is not there"


def installed_places():
    """Where each file is installed, by its place in the sources; of a folder, all that is in it."""
    told = subprocess.run(["meson", "introspect", "--installed", build], capture_output=True, text=True, check=True)
    places = {}
    for source, place in json.loads(told.stdout).items():
        source = pathlib.Path(source)
        for file in [source, *source.rglob("*")] if source.is_dir() else [source]:
            places[file.resolve()] = os.path.normpath(os.path.join(place, os.path.relpath(file, source)))
    return places


def broken_where_installed():
    places = installed_places()
    there = set(places.values())
    for document in documents():
        place = places.get(document.resolve())
        if not place:
            yield f"{document} is not installed"
            continue
        for target in sorted(links(document)):
            if os.path.normpath(os.path.join(os.path.dirname(place), target)) not in there:
                yield f"{place}: {target} is not installed"


faults = [*broken_in_sources(), *broken_where_installed()]
print("\n".join(faults) or f"links: no faults in {len(documents())} documents")
sys.exit(bool(faults))
