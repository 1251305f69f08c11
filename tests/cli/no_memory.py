"""Where the system gives no more memory, a command says so and ends with 70, whoever asked for it: the
library, the command or GMP, which by itself would abort. The numbers are so long that most of
what is asked for are numbers.
usage: no_memory.py FMB"""

import collections
import json
import os
import resource
import subprocess
import sys
import tempfile

FMB = os.path.abspath(sys.argv[1])
DIGITS, STEP, MORE = 100_000, 500_000, 8_000_000
PAGE, PAGES = 4096, 160


def call(room, *words):
    """How the command ends where its addresses take so many bytes, and what it says."""
    run = subprocess.run([FMB, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (room, room)))
    return run.returncode, run.stderr.decode()


def is_one_error(said):
    """Is it one line of JSON about such an end?"""
    lines = said.splitlines()
    try:
        return len(lines) == 1 and json.loads(lines[0])["error"]["exit"] == 70
    except ValueError:
        return False


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("long.fmb", "w") as out:
        out.write(f"{'7' * DIGITS} x + y <= {'3' * DIGITS}\ny >= 1/{'9' * DIGITS}\nx >= 0\n")
    subprocess.run([FMB, "bounds", "long.fmb", "--proof", "long.proof"], check=True,
                   stdout=subprocess.DEVNULL)
    least = STEP  # a process that starts, so that the loader has what it needs
    while call(least, "--version")[0] != 0:
        least += STEP
    first = least - STEP
    faults, ends = [], collections.Counter()
    for words in (("solve", "long.fmb"), ("bounds", "long.fmb"), ("check", "long.fmb", "long.proof"),
                  ("solve", "long.fmb", "--json")):
        for room in range(least, least + MORE, STEP):
            code, said = call(room, *words)
            ends[words[0], code] += 1
            if code not in (0, 70) or (code == 70) != ("out of memory" in said):
                faults.append(f"{' '.join(words)} in {room} bytes: {code}, {said}")
            if code == 70 and "--json" in words and not is_one_error(said):
                faults.append(f"{' '.join(words)} in {room} bytes: not one error, {said}")
    for room in range(first, first + PAGES * PAGE, PAGE):  # there the parser of options gets nothing
        code, said = call(room, "check", "long.fmb")
        if code not in (64, 70, 127):
            faults.append(f"check without a proof in {room} bytes: {code}, {said}")
    for verb in ("solve", "bounds", "check"):
        if ends[verb, 0] == 0 or ends[verb, 70] == 0:
            faults.append(f"{verb}: {ends[verb, 0]} with enough memory, {ends[verb, 70]} without")

print(*faults, dict(ends), sep="\n")
sys.exit(bool(faults))
