"""The binary interface of libfmb.so, of functions and types in public headers, against the one on record: nothing
that a compiled program relies on may have changed since. Additions are fine. usage:
abi.py compare|record ABIDW ABIDIFF LIBRARY HEADERS RECORD
The library needs debug information; docs/versions.md says when to record."""

import lzma
import pathlib
import subprocess
import sys
import tempfile

what, abidw, abidiff, library, headers = sys.argv[1:6]
record = pathlib.Path(sys.argv[6])


def describe(path):
    """Without what private types look like, where things stand, and other folders."""
    run = subprocess.run([abidw, "--headers-dir", headers, "--drop-private-types", "--drop-undefined-syms",
                          "--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--type-id-style", "hash",
                          "--out-file", path, library], capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{abidw}: {run.stderr}")
    return path.read_bytes()


def compare(new, folder):
    old = folder / "old.abi"
    old.write_bytes(lzma.decompress(record.read_bytes()))
    run = subprocess.run([abidiff, "--no-added-syms", old, new], capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{run.stdout}{run.stderr}\nPrograms compiled with the interface on record are wrong with this one. If "
                 "docs/versions.md allows that now: ninja abi-record, and tell it there.")
    print("as recorded")


with tempfile.TemporaryDirectory() as name:
    new = pathlib.Path(name) / "new.abi"
    text = describe(new)
    if b"fmb_solve" not in text or b"type-decl" not in text:
        sys.exit(f"{library}: no debug information")
    if what == "record":
        record.write_bytes(lzma.compress(text, preset=9 | lzma.PRESET_EXTREME))
        print(f"{record}: {record.stat().st_size} bytes of {len(text)}")
    else:
        compare(new, pathlib.Path(name))
