"""Copy a source file with one line left out or replaced.

usage: mutate.py SOURCE OUTPUT LINE [REPLACEMENT]

LINE is compared without leading and trailing blanks, and must be there exactly once.
"""

import pathlib
import sys

source, output, wanted, *replacement = sys.argv[1:]
lines = pathlib.Path(source).read_text().splitlines()
places = [i for i, line in enumerate(lines) if line.strip() == wanted]
if len(places) != 1:
    sys.exit(f"{source}: {len(places)} lines are '{wanted}', there should be one")
lines[places[0]] = replacement[0] if replacement else "{ }"
pathlib.Path(output).write_text("\n".join(lines) + "\n")
