#!/usr/bin/env python3
"""What other languages read of the public headers: with FMB_DECLARATIONS_ONLY, and without any header
of the C library, they are declarations of all public functions, which cffi reads as they are, where
it is installed; and what takes a stream has a partner that takes memory. Ends with 77 without gcc. usage: declarations.py ROOT"""

import pathlib
import re
import shutil
import subprocess
import sys

FUNCTION = re.compile(r"FMB_API\b[^;{]*?\b(fmb_\w+)\s*\(", re.S)
STREAM = re.compile(r"FMB_API\b[^;{(]*?\b(fmb_\w+)\s*\([^;]*?\bFILE\b", re.S)
# Partners that are called otherwise than *_print of *_write and *_parse of *_read.
PARTNERS = {
    "fmb_evidence_tell": "fmb_evidence_print_claim",
    "fmb_frame_reader_new": "fmb_frame_reader_from_text",
    "fmb_sink_jsonl": "fmb_event_print",
    "fmb_evidence_tell_with": "fmb_evidence_print_claim",  # whose style writes to a stream itself
}
COMMENT = re.compile(r"/\*.*?\*/", re.S)


def declarations(include, header):
    return subprocess.run(["gcc", "-E", "-P", "-nostdinc", "-DFMB_DECLARATIONS_ONLY", "-I", include,
                           include / "fmb" / header],
                          check=True, capture_output=True, text=True).stdout


def partner(name):
    return PARTNERS.get(name) or name.replace("_write", "_print").replace("_read", "_parse")


def lonely(include):
    """Functions with a stream, and no partner without one."""
    text = "".join(COMMENT.sub("", p.read_text()) for p in sorted((include / "fmb").glob("*.h")))
    public, streams = set(FUNCTION.findall(text)), set(STREAM.findall(text))
    if len(streams) < 10:
        yield f"streams are not found: {sorted(streams)}"
    for name in sorted(streams):
        if partner(name) not in public - streams:
            yield f"{name} wants a stream, and there is no {partner(name)}"


def faults(root):
    include = root / "include"
    texts = [declarations(include, header) for header in ("fmb.h", "geometry.h")]
    read = set(re.findall(r"\b(fmb_\w+)\s*\(", "".join(texts)))
    for header in sorted((include / "fmb").glob("*.h")):
        public = set(FUNCTION.findall(COMMENT.sub("", header.read_text())))
        missing = public - read if header.name != "gmp.h" else public & read
        if missing:
            yield f"{header.name}: {sorted(missing)}"
    yield from lonely(include)
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
