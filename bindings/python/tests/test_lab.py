"""Experiments in Python: the columns of `fmb-qualify run`, problems of a folder, wrong answers made small."""

import csv
import pathlib
import re
import tempfile
import unittest

import fmb
from fmb import lab

ROOT = pathlib.Path(__file__).resolve().parents[3]
THIN = "x + y + z <= 3; x - y <= 0; -x - z <= -1; y - z <= 1; -y <= 0; z <= 9"


@lab.rule
def liar(view):
    "All rows of a round go."
    return view.rows


@lab.order
def last_one(_, columns):
    "The last column."
    return columns[-1]


@lab.order
def lost(_, columns):
    "No column that is there."
    return max(columns) + 1


class Experiments(unittest.TestCase):
    def test_columns(self):
        """Those of the command, in its order."""
        source = (ROOT / "apps/fmb-qualify/experiment/block.c").read_text()
        told = re.search(r"qualify_experiment_header\[\] =\s*(.*?);", source, re.S)[1]
        header = "".join(re.findall(r'"(.*?)"', told)).replace("\\n", "").split(",")
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name, "runs.csv")
            lab.experiment(["none"], [lab.Problem("thin", 0, 1, fmb.System(THIN), 1)], out=path)
            with open(path, encoding="utf-8", newline="") as file:
                self.assertEqual(next(csv.reader(file)), header)
                (line,) = csv.reader(file)
        self.assertEqual(len(line), len(header))

    def test_problems(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "manifest.csv").write_text("name,family,size,instance,kept\nthin-1-1,thin,1,1,2\nthin-2-1,thin,2,1,0\n")
            for size in (1, 2):
                fmb.System(THIN).write(folder / f"thin-{size}-1.ine")
            found = list(lab.problems(folder, sizes=[1]))
            self.assertEqual([(p.family, p.size, p.seed, p.kept) for p in found], [("thin", 1, 1, 2)])
            self.assertEqual(len(list(lab.problems(folder, families=["thin"], seeds=[1]))), 2)
            self.assertEqual(list(lab.problems(folder, families=["thick"])), [])
            runs = lab.experiment(["kohler", {"rules": [], "order": last_one}], lab.problems(folder))
        self.assertEqual([(r["block"], r["rules"], r["order"], r["question"]) for r in runs], [
            (1, "kohler", "pairs", "project"), (1, "none", "last-one", "project"),
            (2, "kohler", "pairs", "solve"), (2, "none", "last-one", "solve")])
        self.assertEqual({r["outcome"] for r in runs}, {"decided"})

    def test_infeasible(self):
        """Where nothing satisfies a system the verdict is asked for, by the rules of the library, too, as in `fmb-qualify run`."""
        apart = lab.Problem("apart", 0, 1, fmb.System(THIN + "; x + y + z <= -1"), 1)
        runs = lab.experiment(["none", "default"], [apart], presolve="none")
        self.assertEqual([(run["outcome"], run["verdict"], run["question"]) for run in runs], [("decided", "infeasible", "project")] * 2)
        self.assertTrue(all(run["made"] > 0 for run in runs))

    def test_wrong(self):
        """The liar's answer is wrong, and shown by a system without a row too many."""
        (run,) = lab.experiment([liar], [lab.Problem("thin", 0, 1, fmb.System(THIN), 1)], presolve="none")
        self.assertEqual(run["outcome"], "wrong")
        small = fmb.System(run["system"])
        self.assertLess(len(small), len(fmb.System(THIN)))

    def test_stopped(self):
        rows = "; ".join(f"{a} x {b} y {c} z <= 1" for a in "+-" for b in "+-" for c in "+-").replace("; +", "; ").lstrip("+ ")
        (run,) = lab.experiment(["none"], [lab.Problem("diamond", 0, 1, fmb.System(rows), 1)], max_rows=9, presolve="none")
        self.assertEqual((run["outcome"], run["stop"]), ("stopped", "rows"))

    def test_lost(self):
        with self.assertRaisesRegex(fmb.ArgumentError, "the order chose"):
            lab.experiment([{"order": lost}], [lab.Problem("thin", 0, 1, fmb.System(THIN), 1)], presolve="none")


if __name__ == "__main__":
    unittest.main()
