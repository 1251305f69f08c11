"""One version and one day of release, wherever they are told: versions.py ROOT"""

import pathlib
import re
import sys
from email.utils import parsedate_to_datetime

root = pathlib.Path(sys.argv[1])
NUMBER = r"(\d+\.\d+\.\d+)"
# A file, and what stands before the version there; the first place counts.
PLACES = {
    "include/fmb/base.h": r'#define FMB_VERSION +"',
    "docs/CHANGELOG.md": r"^## ",
    "README.md": r"^  version = \{",
    "docs/man/fmb.1": r'^\.TH .* "fmb ',
    "docs/man/fmb-qualify.1": r'^\.TH .* "fmb ',
    "docs/man/fmb-validate.1": r'^\.TH .* "fmb ',
    "CITATION.cff": r"^version: ",
    "README.md": r"^  version = \{",
    "bindings/python/pyproject.toml": r'^version = "',
    "packaging/debian/changelog": r"\Afmb \(",
    "packaging/conda/meta.yaml": r'set version = "',
    "packaging/homebrew/fmb.rb": r'^  version "',
    "packaging/nix/package.nix": r'^  version = "',
    "packaging/vcpkg/fmb/vcpkg.json": r'"version": "',
}


def text(path):
    return (root / path).read_text(encoding="utf-8")


def told(path, pattern):
    found = re.search(pattern, text(path), re.M)
    return found.group(1) if found else None


def faults():
    version = told("meson.build", rf"^  version: '{NUMBER}'")
    for path, before in PLACES.items():
        if (other := told(path, before + NUMBER)) != version:
            yield f"{path}: {other} is not {version} of meson.build"

    # Debian's name of the library is its SONAME, which before 1.0 has the minor version; so has the node of symbols.
    minor = version.rpartition(".")[0]
    symbols = text(f"packaging/debian/libfmb{minor}.symbols")
    if f"libfmb.so.{minor} libfmb{minor} #MINVER#\n" not in symbols or f"(symver)FMB_{minor} {minor}.0\n" not in symbols:
        yield f"packaging/debian/libfmb{minor}.symbols is not about libfmb.so.{minor} and FMB_{minor}"
    if f"\nPackage: libfmb{minor}\n" not in text("packaging/debian/control"):
        yield f"packaging/debian/control: no package libfmb{minor}"
    if told("README.md", r"find_package\(fmb (\d+\.\d+)") != minor:
        yield f"README.md: find_package is not asked for {minor}"

    released = told("CITATION.cff", r"^date-released: (\d{4}-\d\d-\d\d)$")
    stamp = told("packaging/debian/changelog", r"^ -- .*>  (.*)$")
    if not released or parsedate_to_datetime(stamp).date().isoformat() != released:
        yield f"CITATION.cff is of {released}, packaging/debian/changelog of {stamp}"


wrong = list(faults())
print("\n".join(wrong) or "one version everywhere")
sys.exit(1 if wrong else 0)
