"""Every command, option and word that an option takes stands in the man page and in the completion,
and they name no other option.
usage: documented.py FMB ROOT"""

import pathlib
import re
import shlex
import subprocess
import sys

fmb, root = sys.argv[1], pathlib.Path(sys.argv[2])
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")


def options(*words):
    help_text = subprocess.run([fmb, *words, "--help"], capture_output=True, text=True,
                               check=True).stdout
    found = re.findall(r"^ +(?:-\w, |-\?, )?(--[a-z-]+)(?:=(\S+))?", help_text, re.M)
    values.update(word for _, listed in found for word in listed.split("|") if word.islower())
    return {option for option, _ in found}


values = set()
top = subprocess.run([fmb, "--help"], capture_output=True, text=True, check=True).stdout
commands = re.findall(r"^  ([a-z]+) ", top.partition("Commands:\n")[2].partition("\n\n")[0], re.M)
wanted = options().union(*(options(c) for c in commands))
faults = [] if len(commands) == 13 and len(wanted) > 10 and "gmp" in values else ["--help was not understood"]
for name in ("docs/man/fmb.1", "apps/completion/fmb.bash"):
    text = (root / name).read_text().replace("\\-", "-")
    found = set(OPTION.findall(text))
    faults += [f"{name}: {word} is missing" for word in sorted(wanted - found)]
    faults += [f"{name}: {word} is not an option" for word in sorted(found - wanted)]
    faults += [f"{name}: {word} is missing" for word in [*commands, *sorted(values)]
               if not re.search(rf"\b{word}\b", text)]


def complete(*words):
    """What bash offers for the last of the words."""
    script = (f"source {shlex.quote(str(root / 'apps/completion/fmb.bash'))}; "
              f"COMP_WORDS=({shlex.join(words)}) COMP_CWORD={len(words) - 1}; _fmb; "
              'echo "${COMPREPLY[@]}"')
    return subprocess.run(["bash", "-c", script], capture_output=True, text=True).stdout.split()


for words, offered in ((("fmb", ""), commands), (("fmb", "solve", "f", "--me"), ["--method"]),
                       (("fmb", "solve", "--method", ""), ["auto", "fm", "lp"]),
                       (("fmb", "solve", "--method", "="), ["auto", "fm", "lp"]),
                       (("fmb", "intersect", "f", "--boxes", "=", "o"), ["outward"]),
                       (("fmb", "convert", "--t"), ["--to"]), (("fmb", "check", "--proo"), [])):
    if not set(offered) <= set(complete(*words)) or (not offered and complete(*words)):
        faults.append(f"completion of {words}: {complete(*words)}")
print("\n".join(faults) or "all documented")
sys.exit(bool(faults))
