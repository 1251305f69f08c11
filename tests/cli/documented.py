"""Every command, option and word that an option takes stands in the man page, which names no other
option, and is offered by the completion of bash.
usage: documented.py FMB ROOT"""

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

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
text = (root / "docs/man/fmb.1").read_text().replace("\\-", "-")
found = set(OPTION.findall(text))
faults += [f"man page: {word} is missing" for word in sorted(wanted - found)]
faults += [f"man page: {word} is not an option" for word in sorted(found - wanted)]
faults += [f"man page: {word} is missing" for word in [*commands, *sorted(values)]
           if not re.search(rf"\b{word}\b", text)]


def complete(*words):
    """What bash offers for the last of the words."""
    script = (f"source {shlex.quote(str(root / 'apps/completion/fmb.bash'))}; "
              f"COMP_WORDS=({shlex.join((fmb, *words))}) COMP_CWORD={len(words)}; _fmb; "
              'printf "%s\\n" "${COMPREPLY[@]}"')
    run = subprocess.run(["bash", "-c", script], capture_output=True, text=True)
    if run.stderr:
        faults.append(f"completion of {words}: {run.stderr}")
    return run.stdout.split()


def expect(words, offered):
    found = complete(*words)
    if sorted(found) != sorted(offered):
        faults.append(f"completion of {words}: {found}, expected {offered}")


def listed(*words):
    """The table of a program: option, what it takes."""
    table = subprocess.run([fmb, *words, "--list-options"], capture_output=True, text=True).stdout
    return {line.split("\t")[0]: line.split("\t")[2] for line in table.splitlines()}


asked = set()
expect(("",), commands)
expect(("help", "sol"), ["solve"])
for c in commands:
    table = listed(c)
    if set(table) != options(c):
        faults.append(f"{c} --list-options: {set(table) ^ options(c)}")
    expect((c, "--"), table)
    for option, takes in table.items():
        if "|" in takes and not takes.startswith("LIST") and (option, takes) not in asked:
            asked.add((option, takes))
            words = [word for word in takes.split("|") if word != "FILE"]
            expect((c, option, ""), words)
            expect((c, option, "=", words[0]), [w for w in words if w.startswith(words[0])])
with tempfile.TemporaryDirectory() as folder:
    file, hostile = f"{folder}/some system.fmb", f"{folder}/hostile.fmb"
    pathlib.Path(file).write_text('x1 + x2 + bread + "a b" + "c,d" <= 1\n')
    pathlib.Path(hostile).write_text(f'good + "$(touch {folder}/done)" + "\\"$(touch {folder}/done)"'
                                     f' + "`touch {folder}/done`" <= 1\n')
    names = ["x1", "x2", "bread"]
    for words, offered in (
            (("project", file, "--keep", ""), names),
            (("project", file.replace(" ", "\\ "), "--keep", ""), names),
            (("project", file, "--eliminate", "=", "x"), ["x1", "x2"]),
            (("project", file, "--keep", "x2,"), ["x2,x1", "x2,bread"]),
            (("bounds", file, "--vars", "b"), ["bread"]),
            (("optimize", file, "--max", ""), names),
            (("bounds", file, "--format", "fmb", "--vars", "=", ""), names),
            (("bounds", file, "--format", "=", "ine", "--vars", ""), []),
            (("bounds", f"{folder}/none.fmb", "--vars", ""), []),
            (("project", hostile, "--keep", ""), ["good"]),
            (("solve", file, "--rules", "kohler,bo"), ["kohler,box"]),
            (("check", file, "--expect", "in"), ["infeasible"]),
            (("solve", file, "--max-seconds", ""), []), (("solve", file, "--decimal", "=", ""), []),
            (("solve", "f", "--me"), ["--method"]), (("check", "--proo"), [])):
        expect(words, offered)
    if pathlib.Path(folder, "done").exists():
        faults.append("the completion carries out what a name says")
print("\n".join(faults) or "all documented")
sys.exit(bool(faults))
