"""The figures of the site are what the scripts beside them draw. With another version of matplotlib than
the one that drew a figure the lines may differ: then it is enough that the script runs.
usage: figures.py [--write] FOLDER"""

import os
import pathlib
import re
import runpy
import sys
import tempfile

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot  # noqa: E402,F401  before the children are made, which all need it

CREATOR = re.compile(r"matplotlib [\d.]+")


def draw(script, out):
    """Run a script in a child, as it is run by hand; true if it ended well."""
    child = os.fork()
    if child == 0:
        sys.argv = [str(script), str(out)]
        try:
            runpy.run_path(str(script), run_name="__main__")
        except BaseException as e:  # pylint: disable=broad-except
            print(f"{script}: {e!r}", file=sys.stderr)
            os._exit(1)
        sys.stdout.flush()
        os._exit(0)
    return os.waitpid(child, 0)[1] == 0


def faults(folder, rewrite):
    """Figures that are not drawn, or not so."""
    with tempfile.TemporaryDirectory() as scratch:
        for script in sorted(folder.rglob("*figure.py")):
            figure = script.with_suffix(".svg")
            out = figure if rewrite else pathlib.Path(scratch, "figure.svg")
            if not draw(script, out):
                yield f"{script} failed"
                continue
            now, kept = out.read_text(), figure.read_text()
            if CREATOR.search(now)[0] == CREATOR.search(kept)[0] and now != kept:
                yield f"{figure} is not what {script.name} draws"


def main():
    folder = pathlib.Path(sys.argv[-1]).resolve()
    found = list(faults(folder, "--write" in sys.argv))
    drawn = len(list(folder.rglob("*figure.py")))
    print("\n".join(found) or f"{drawn} figures are up to date")
    sys.exit(bool(found) or not drawn)


if __name__ == "__main__":
    main()
