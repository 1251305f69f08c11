"""What fish or zsh offers for lines of fmb; bash is asked by documented.py.
usage: completion.py SHELL FMB ROOT"""

import os
import pathlib
import subprocess
import sys
import tempfile

shell = sys.argv[1]
fmb, root = (pathlib.Path(word).resolve() for word in sys.argv[2:4])
FOLDER = root / "apps/completion"
FILES = ["bad.fmb", "big.ine"]


def offers(lines, folder):
    """By line."""
    env = {"PATH": f"{fmb.parent}:{os.environ['PATH']}", "HOME": folder, "TERM": "dumb",
           "LC_ALL": "C", "LD_LIBRARY_PATH": os.environ.get("LD_LIBRARY_PATH", "")}
    ask = "; ".join(f"echo 'line {line}'; complete -C '{line}'" for line in lines)
    command = {"fish": ["fish", "--no-config", "-c", f"source {FOLDER / 'fmb.fish'}; {ask}"],
               "zsh": ["zsh", "-f", root / "tests/cli/complete.zsh", FOLDER, *lines]}[shell]
    run = subprocess.run(command, env=env, cwd=folder, capture_output=True, text=True, timeout=200)
    offered, line, stem = {}, None, ""
    for text in run.stdout.splitlines():
        if text.startswith("line "):
            line = text.removeprefix("line ")
            last = line.rpartition(" ")[2]
            stem = last[:max(last.rfind("="), last.rfind(",")) + 1]
            offered[line] = set()
        else:
            offered[line].add(text.split("\t")[0].removeprefix(stem))
    return offered


faults = []
with tempfile.TemporaryDirectory() as folder:
    for name in FILES:
        pathlib.Path(folder, name).write_text('beans + bread + "b\\"ig $(touch done)" <= 1\n')
    wanted = dict((
            ("fmb b", {"bounds"}), ("fmb solve b", set(FILES)), ("fmb solve --js", {"--json"}),
            ("fmb solve --method ", {"auto", "fm", "lp", "hull", "dd"}),
            ("fmb solve --method=h", {"hull"}),
            ("fmb project --to ", {"fmb", "ine", "smt2", "mps", "lp"}),
            ("fmb solve --max-seconds ", set()), ("fmb solve --decimal b", set(FILES)),
            ("fmb solve --decimal=", set()), ("fmb solve --proof b", set(FILES)),
            ("fmb project --symmetry ", {"auto", "none", *FILES}),
            ("fmb project bad.fmb --keep ", {"beans", "bread"}),
            ("fmb project bad.fmb --keep beans,", {"bread"}),
            ("fmb project bad.fmb --keep=br", {"bread"}),
            ("fmb bounds bad.fmb --vars b", {"beans", "bread"}),
            ("fmb optimize bad.fmb --max be", {"beans"}),
            ("fmb check --expect in", {"infeasible"})))
    found = offers([*wanted, "fmb "], folder)
    faults += [f"'{line}': {found.get(line)}, expected {words}" for line, words in wanted.items()
               if found.get(line) != words]
    first = found.get("fmb ", set())
    if not {"solve", "mesh"} <= first or set(FILES) & first:
        faults.append(f"no command yet: {first}")
    if pathlib.Path(folder, "done").exists():
        faults.append("what a name says was carried out")
print("\n".join(faults) or f"{shell}: as expected")
sys.exit(bool(faults))
