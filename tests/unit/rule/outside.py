"""docs/adding-a-rule.md: its code is that of docs/examples/rules to the letter, compiles as a user
compiles it, against an installation, and prints what the document says. usage: outside.py ROOT BUILD"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

root, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
text = (root / "docs/adding-a-rule.md").read_text()
folder = root / "docs/examples/rules"


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.M | re.S)


def call(command, **more):
    run = subprocess.run(command, capture_output=True, text=True, **more)
    if run.returncode:
        sys.exit(f"{command}:\n{run.stdout}{run.stderr}")
    return run.stdout


def sanitizers():
    """A sanitized library wants a sanitized program."""
    config = call(["meson", "introspect", "--buildoptions", str(build)])
    value = re.search(r'"name": "b_sanitize", "value": "([a-z,]*)"', config)
    return [f"-fsanitize={value[1]}"] if value and value[1] != "none" else []


files = {p: p.read_text() for p in sorted(folder.iterdir())}
assert sorted(blocks("c")) == sorted(files.values()), "the document and the files differ"
command, start = blocks("sh")[0].splitlines()
expected = blocks("text")[0]  # the second one is that of the program in Python
if not shutil.which("pkg-config"):
    print("pkg-config is missing: nothing is compiled")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    scratch = pathlib.Path(name)
    for path, content in files.items():
        (scratch / path.name).write_text(content)
    home = scratch / "home"
    call(["meson", "install", "-C", str(build), "--no-rebuild", "--destdir", str(home)])
    library = next(home.rglob("libfmb.so")).parent
    env = {**os.environ, "PKG_CONFIG_PATH": str(next(home.rglob("fmb.pc")).parent),
           "PKG_CONFIG_SYSROOT_DIR": str(home), "LD_LIBRARY_PATH": str(library)}
    strict = ["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", *sanitizers()]
    call(["sh", "-ec", f"{command} {shlex.join(strict)}"], cwd=scratch, env=env)
    found = call([str(scratch / start)], env=env)
assert found == expected, f"{found!r} instead of {expected!r}"
print(found, end="")
