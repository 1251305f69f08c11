#!/usr/bin/env python3
"""Every public function is called by some test: coverage.py HEADERS TESTS names the others."""

import pathlib
import re
import sys


def main():
    headers, tests = (pathlib.Path(p) for p in sys.argv[1:3])
    declared = set()
    for header in headers.glob("*.h"):
        text = header.read_text(encoding="utf-8")
        declared.update(re.findall(r"^FMB_API[^;]*?\b(fmb_\w+)\(", text, re.MULTILINE))
    called = set()
    for source in tests.rglob("*.c"):
        called.update(re.findall(r"\b(fmb_\w+)\(", source.read_text(encoding="utf-8")))
    missing = sorted(declared - called)
    print(f"{len(declared)} public functions, {len(missing)} that no test calls")
    for name in missing:
        print("  " + name)
    return 1 if missing or not declared else 0


if __name__ == "__main__":
    sys.exit(main())
