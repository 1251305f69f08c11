"""The picture of the README and of the first page of the site is what docs/overlap.py draws, which compares the box that fmb finds with
that of the common part it clips itself. usage: picture.py FMB ROOT"""

import pathlib
import subprocess
import sys

fmb, docs = sys.argv[1], pathlib.Path(sys.argv[2]) / "docs"
drawn = subprocess.run([sys.executable, "-B", docs / "overlap.py", fmb,
                        docs / "examples/frames.jsonl", "1"], capture_output=True, text=True)
if drawn.returncode:
    sys.exit(drawn.stderr)
if drawn.stdout != (docs / "overlap.svg").read_text():
    sys.exit("docs/overlap.svg: not what docs/overlap.py draws")
print("docs/overlap.svg is up to date")
