#!/usr/bin/env python3
"""Linear programs by `fmb optimize --proof` beside GLPK's own command, file by file.

  netlib.py --fmb PROGRAM [--fmb OTHER]... FILE.mps...

Each command is a process of its own, reading and writing included: its user time [s], the median
of --rounds rounds (one where a round takes more than a second), all commands in turn within a
round; GLPK's is the mean of its first and its last run of a round. Then fmb check judges the proof.
A command that takes longer than --seconds counts as that long, and is named. Integers are reals in
both. Files that GLPK cannot read, or does not end, are left out of the mean.

The bar: geometric mean of the ratios at most 1.6, none above 8, all proofs accepted.
Exit: 0, 1 if the bar is broken by the last fmb that is named.
"""

import argparse
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile

MEAN, WORST = 1.6, 8.0


def options():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("files", metavar="FILE.mps", nargs="+")
    p.add_argument("--fmb", action="append", required=True, help="the program under test")
    p.add_argument("--glpsol", default="glpsol")
    p.add_argument("--rounds", type=int, default=3)
    p.add_argument("--seconds", type=int, default=60, help="limit of a command")
    return p.parse_args()


def run(args, seconds):
    """User time [s] and exit code; None where it was killed."""
    def confine():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))

    p = subprocess.Popen(args, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                         stderr=subprocess.DEVNULL, preexec_fn=confine)
    _, status, used = os.wait4(p.pid, 0)
    p.returncode = os.waitstatus_to_exitcode(status)
    return used.ru_utime, None if p.returncode < 0 else p.returncode


def measure(opts, path, folder):
    """Medians of GLPK and of each fmb, and what is wrong with any."""
    glpk = [opts.glpsol, "--nomip", "--mps", path]
    ours = [[f, "optimize", "--relax", "--proof", os.path.join(folder, str(k)), path]
            for k, f in enumerate(opts.fmb)]
    times, faults = [[] for _ in range(1 + len(ours))], {}
    for _ in range(opts.rounds):
        first, code = run(glpk, opts.seconds)
        faults["GLPK"] = "" if code == 0 else "no end"
        for k, args in enumerate(ours):
            seconds, code = run(args, opts.seconds)
            times[k + 1].append(seconds)
            faults[args[0]] = "" if code == 0 else "UNDECIDED"
        last = run(glpk, opts.seconds)[0] if first < 1 else first
        times[0].append((first + last) / 2)
        if max(t[0] for t in times) > 1 or faults["GLPK"]:
            break
    for k, f in enumerate(opts.fmb):
        check = [f, "check", path, os.path.join(folder, str(k)), "--relax", "--expect", "optimum"]
        if not faults[f] and run(check, 600)[1] != 0:
            faults[f] = "REJECTED"
    return [statistics.median(t) for t in times], faults


def summarize(name, ratios):
    """Geometric mean, worst and where."""
    mean = math.exp(sum(math.log(r) for r, _ in ratios) / len(ratios))
    worst = max(ratios)
    print(f"{name}: {mean:.3f} of GLPK's time in the geometric mean of {len(ratios)}, "
          f"worst {worst[0]:.2f} ({worst[1]}), above 4: "
          + ", ".join(f"{n} {r:.1f}" for r, n in sorted(ratios, reverse=True) if r > 4))
    return mean <= MEAN and worst[0] <= WORST


def main():
    opts = options()
    opts.fmb = [os.path.abspath(f) for f in opts.fmb]
    ratios, sound = [[] for _ in opts.fmb], True
    print(f"{'model':14}{'GLPK s':>9}" + "".join(f"{'fmb s':>10}{'ratio':>7}" for _ in opts.fmb))
    with tempfile.TemporaryDirectory(prefix="fmb-netlib-") as folder:
        for path in sorted(opts.files, key=os.path.getsize):
            name = os.path.basename(path).removesuffix(".mps")
            times, faults = measure(opts, path, folder)
            floor = [max(t, 1e-3) for t in times]
            print(f"{name:14}{times[0]:9.4f}" + "".join(
                f"{t:10.4f}{f / floor[0]:7.2f}" for t, f in zip(times[1:], floor[1:])),
                *(x for x in faults.values() if x), flush=True)
            sound = sound and not faults[opts.fmb[-1]]
            if not faults["GLPK"]:
                for k, f in enumerate(floor[1:]):
                    ratios[k].append((f / floor[0], name))
    good = [summarize(f, r) for f, r in zip(opts.fmb, ratios)][-1]
    return 0 if good and sound else 1


if __name__ == "__main__":
    sys.exit(main())
