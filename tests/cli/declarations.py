#!/usr/bin/env python3
"""What other languages read of the public headers: with FMB_DECLARATIONS_ONLY, and without any header
of the C library, they are declarations of all public functions, which cffi reads as they are, where
it is installed. Ends with 77 without gcc. usage: declarations.py ROOT"""

import pathlib
import re
import shutil
import subprocess
import sys

FUNCTION = re.compile(r"FMB_API\b[^;{]*?\b(fmb_\w+)\s*\(", re.S)
COMMENT = re.compile(r"/\*.*?\*/", re.S)


def declarations(include, header):
    return subprocess.run(["gcc", "-E", "-P", "-nostdinc", "-DFMB_DECLARATIONS_ONLY", "-I", include,
                           include / "fmb" / header],
                          check=True, capture_output=True, text=True).stdout


def faults(root):
    include = root / "include"
    texts = [declarations(include, header) for header in ("fmb.h", "geometry.h")]
    read = set(re.findall(r"\b(fmb_\w+)\s*\(", "".join(texts)))
    for header in sorted((include / "fmb").glob("*.h")):
        public = set(FUNCTION.findall(COMMENT.sub("", header.read_text())))
        missing = public - read if header.name != "gmp.h" else public & read
        if missing:
            yield f"{header.name}: {sorted(missing)}"
    for text in texts:
        if "__attribute__" in text or "#" in text:
            yield "more than declarations"
    try:
        import cffi
    except ImportError:
        return
    for text in texts:
        ffi = cffi.FFI()
        ffi.cdef(text)
        if ffi.sizeof("fmb_where") < 160:
            yield "fmb_where is not read"


def main():
    if not shutil.which("gcc"):
        return 77
    found = list(faults(pathlib.Path(sys.argv[1])))
    return "\n".join(found) if found else 0


if __name__ == "__main__":
    sys.exit(main())
