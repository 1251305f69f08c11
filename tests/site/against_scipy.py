"""Answers of the gallery, held against SciPy's linear programs (HiGHS) and against what is known.

A projection is right if every direction has the same largest value over the rows of the model and over the rows of the
projection; both are found by HiGHS, in doubles. usage: against_scipy.py SITE"""

import pathlib
import random
import subprocess
import sys

import numpy
import scipy.optimize

import fmb

GALLERY = pathlib.Path(sys.argv[1]).resolve() / "gallery"

PROJECTIONS = [
    ("cat reachable-set/cart.fmb", "p4 v4", 8),
    ("cat explicit-mpc/mpc.fmb", "p0 v0 cost", 20),
    ("cat ranking-function/loop.fmb", "a b c", 3),
    ("cat standing-robot/robot.fmb", "cx cy", 4),
    ("cat correlated-equilibrium/chicken.fmb", "u1 u2", 4),
    ("cat power-transfer/grid.fmb", "g1 g2", 6),
    ("cat cost-sharing/dams.fmb", "n f", 6),
    ("python3 parity-polytope/parity.py 6", "x1 x2 x3 x4 x5 x6", 2**5 + 12),
    ("python3 entropies/entropies.py A B C X Y Z; cat entropies/network.txt",
     "hA hB hC hAB hAC hBC hABC", 16),
]
INFEASIBLE = [
    "cat binary-search/body.fmb; echo 'mid >= n'", "cat binary-search/body.fmb; echo 'mid <= -1'",
    "cat marriage/jobs.fmb", "cat ranking-function/other.fmb", "cat cost-sharing/voters.fmb", "cat crossing-drones/apart.fmb",
    "python3 revealed-preference/purchases.py < revealed-preference/purchases.txt",
    "python3 multi-commodity/flows.py < multi-commodity/network.txt",
    "python3 separable-points/points.py < separable-points/mixed.txt",
    "python3 entropies/entropies.py A B C X Y Z; cat entropies/network.txt "
    "entropies/coin.txt",
]
OPTIMA = [
    ("cat correlated-equilibrium/chicken.fmb", "u1 + u2", "21/2"),
    ("cat power-transfer/grid.fmb", "g1 + g2", 270),
    ("cat option-prices/market.fmb", "call100", "15/2"),
    ("cat option-prices/market.fmb", "-call100", -6),
    ("cat relu-network/network.fmb", "-y", "-1/8"),
    ("sed '/demand/s/1$/share/' multi-commodity/network.txt | python3 multi-commodity/flows.py",
     "share", "3/4"),
    ("cat metabolic-cone/yeast.fmb; echo 'glycolysis + glycerol = 1'",
     "2glycolysis + cycle + 5/2 respiration - 2glycerol", 34),
    ("cat crossing-drones/apart.fmb | sed 's/z = 1/z = 2/'", "-t", "-23/64"),
]


def model(command):
    """The system that a command prints in the gallery."""
    text = subprocess.run(["bash", "-c", command], cwd=GALLERY, capture_output=True, text=True, check=True).stdout
    return fmb.System.parse(text, "fmb")


def best(system, form):
    """HiGHS's status and the largest value of a form; strict rows are taken with equality."""
    A, relations, b = system.to_arrays()
    c = numpy.array([-float(form.get(name, 0)) for name in system.names])
    equal = numpy.array([relation == "=" for relation in relations])
    found = scipy.optimize.linprog(
        c, A[~equal] if (~equal).any() else None, b[~equal] if (~equal).any() else None,
        A[equal] if equal.any() else None, b[equal] if equal.any() else None, (None, None), "highs")
    return found.status, -found.fun if found.status == 0 else None


def wrong_projections(directions=24):
    """Projections that differ from the model in some direction, or in their number of rows."""
    draw = random.Random(1)
    for command, keep, rows in PROJECTIONS:
        lift = model(command)
        shadow = fmb.project(lift, keep).system
        if len(shadow) != rows:
            yield f"{command}: {len(shadow)} rows, not {rows}"
        for _ in range(directions):
            form = {name: draw.randint(-3, 3) for name in keep.split()}
            (status, value), (other, again) = best(lift, form), best(shadow, form)
            if (status in (2, 3, 4)) != (other in (2, 3, 4)) or (
                    value is not None and again is not None and abs(value - again) > 1e-6):
                yield f"{command}: {form}: {value}, and {again} over the projection"


def wrong_answers():
    """Conflicts that HiGHS does not see, and optima that it finds elsewhere."""
    for command in INFEASIBLE:
        system = model(command)
        if fmb.solve(system) or best(system, {})[0] != 2:
            yield f"{command}: not infeasible"
    for command, form, expected in OPTIMA:
        system = model(command)
        ours = fmb.optimize(system, max=form)
        parsed = fmb.System([f"{form} <= 0"])[0].coefficients
        status, value = best(system, parsed)
        if ours.value != fmb.vars("x")[0]({"x": expected}):
            yield f"{command}: {ours.value}, not {expected}"
        if status != 0 or abs(value - float(ours.value)) > 1e-6:
            yield f"{command}: {ours.value}, but HiGHS says {value}"


if __name__ == "__main__":
    faults = [*wrong_projections(), *wrong_answers()]
    print("\n".join(faults) or f"{len(PROJECTIONS) + len(INFEASIBLE) + len(OPTIMA)} answers are those of HiGHS")
    sys.exit(bool(faults))
