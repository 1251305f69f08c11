"""What bash offers for fmb-validate and fmb-qualify is what their --help tells.
usage: completion.py FMB_VALIDATE FMB_QUALIFY COMPLETION"""

import re
import shlex
import subprocess
import sys

validate, qualify, script = sys.argv[1:]
ABOUT = ("--help", "--usage", "--version")
# What the help of a command has, if it was understood.
HAS = {"rules": {"--pairs", "--rules"}, "benchmark": {"--families"}, "run": {"--shard"}, "merge": set(),
       "plots": {"--out"}, "leaderboard": {"--out"}, "bias": {"--repetitions"}}
faults = []


def help_of(*words):
    return subprocess.run([*words, "--help"], capture_output=True, text=True, check=True).stdout


def options(*words):
    found = set(re.findall(r"^ +(?:-\w, |-\?, )?(--[a-z-]+)", help_of(*words), re.M))
    if not {*ABOUT, *HAS.get(words[-1], {"--pairs", "--simd"})} <= found:
        faults.append(f"{words}: --help was not understood")
    return found


def values(option, *words):
    """The words that an option takes: those before the bracket of its help."""
    text = re.search(rf"{option}=\S+\s+([^\[]*)", help_of(*words))[1]
    return set(re.findall(r"[\w-]+", text.partition(":")[0])) - {"or"}


def offered(function, *words):
    """Words as bash has them: those of COMP_WORDBREAKS by themselves."""
    line = (f"source {shlex.quote(script)}; COMP_WORDS=({shlex.join(words)}) "
            f'COMP_CWORD={len(words) - 1}; {function}; echo "${{COMPREPLY[@]}}"')
    return subprocess.run(["bash", "-c", line], capture_output=True, text=True).stdout.split()


def expect(wanted, function, *words):
    found = offered(function, *words)
    if set(found) != set(wanted) or len(found) != len(set(found)):
        faults.append(f"{words}: offered {found}, wanted {sorted(wanted)}")


def try_validate():
    def said(wanted, *words):
        expect(wanted, "_fmb_validate", "fmb-validate", *words)
    families = values("--families", validate)
    said(options(validate), "--")
    said({f"{d}d-{motion}" for d in range(1, 17) for motion in ("static", "dynamic")}, "")
    said({"7d-static", "7d-dynamic"}, "--boxes", "7")
    said(families, "--families", "")
    said(families, "-f", "")
    said(families, "--families", "=")
    said({"near,flat", "near,far"}, "--families", "=", "near,f")
    said(values("--simd", validate), "--simd", "")
    said({}, "--pairs", "")


def try_qualify():
    def said(wanted, *words):
        expect(wanted, "_fmb_qualify", "fmb-qualify", *words)
    studies = re.findall(r"^  ([a-z]\w*) ", help_of(qualify).partition("Studies:\n")[2], re.M)
    said(studies, "")
    said(options(qualify, "all"), "--")
    for study in studies:
        said(options(qualify, study), study, "--")
    for option in ("--motion", "--orders"):
        said(values(option, qualify, "rules"), "rules", option, "")
    said({"kohler,box"}, "rules", "--rules", "=", "kohler,b")
    said(values("--simd", qualify, "near"), "near", "--simd", "")
    said({}, "near", "")


try_validate()
try_qualify()
print("\n".join(faults) or "completion: no faults")
sys.exit(bool(faults))
