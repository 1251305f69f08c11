"""The site can be built without a warning or a broken link. Ends with 77 where what makes it is not
installed. usage: builds_site.py ROOT BUILD"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

root, build = map(pathlib.Path, sys.argv[1:])
needed = ["import sphinx, myst_parser"]
if not shutil.which("mandoc") or subprocess.run(["/usr/bin/python3", "-c", *needed], capture_output=True).returncode:
    print("the packages of the list `site` in .ci/packages are not installed")
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    run = subprocess.run([root / "docs/site/build", folder, build], capture_output=True, text=True)
    print(run.stdout, run.stderr)
sys.exit(run.returncode)
