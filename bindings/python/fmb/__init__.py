"""Systems of linear inequalities, solved exactly: libfmb for Python.

>>> import fmb
>>> x, y = fmb.vars("x y")
>>> fmb.solve([x + y <= 3, 2 * y < x - 4]).point
x = 0, y = -3
>>> fmb.project("0 <= x <= z; z <= y; y <= 4", "x y")
x >= 0; y <= 4; x - y <= 0

Numbers are exact: Fraction comes out, and int, Fraction, Decimal, strings and floats (by their
binary value) go in. Every answer carries a proof, which `answer.proof.check()` judges.
"""

from typing import List

from fmb._answers import Answer, Conflict, Judgement, Point, Proof
from fmb._lib import (ArgumentError, Error, ParseError, RuleError, StateError, Unfinished, lib,
                      text)
from fmb._linear import Form, Row, Variable, total, vars
from fmb._polyhedron import Polyhedron
from fmb._results import Box, End, Generators, Interval, Optimum, Reduction, SystemAnswer
from fmb._script import Script
from fmb._session import Session
from fmb._solver import (Event, Solver, bounds, check, eliminate, hull, hull_of, image,
                         optimize, project, reduce, solve, sum, vertices)
from fmb._system import ParseWarning, System, SystemRow

__all__ = ["Answer", "ArgumentError", "Box", "Conflict", "End", "Error", "Event", "Form", "Generators",
           "Interval", "Judgement", "Optimum", "ParseError", "ParseWarning", "Point", "Polyhedron",
           "Proof", "Reduction", "Row", "RuleError", "Script", "Session", "Solver", "StateError", "System",
           "SystemAnswer", "SystemRow", "Unfinished", "Variable", "bounds", "check", "eliminate",
           "hull", "hull_of", "image", "optimize", "project", "reduce", "solve", "sum", "total",
           "vars", "vertices"]

__version__ = text(lib.fmb_version())

# These need NumPy, which is imported at their first use.
_LATER = {"_frames": ("Frame", "Frames", "Pairs", "Proximity", "common", "cuboid", "depth",
                      "distance", "meeting", "separate", "simplex"), "_mesh": ("Hits", "Mesh")}


def __getattr__(name: str) -> object:
    import importlib
    for module, names in _LATER.items():
        if name in names:
            return getattr(importlib.import_module(f"fmb.{module}"), name)
    if name in ("bridges", "lab"):
        return importlib.import_module(f"fmb.{name}")
    raise AttributeError(f"module 'fmb' has no attribute {name!r}")


def __dir__() -> List[str]:
    return sorted({*globals(), "bridges", "lab",
                   *(name for names in _LATER.values() for name in names)})
