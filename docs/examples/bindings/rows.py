"""rows.py: rows.c in Python; cffi reads the headers: rows.py INCLUDE LIBRARY [RIGHT]."""

import subprocess
import sys

import cffi
from ring import DIM, KEPT, ROWS, ring

include, library, last = (sys.argv + ["5"])[1:4]
ffi = cffi.FFI()
headers = ["gcc", "-E", "-P", "-DFMB_DECLARATIONS_ONLY", "-I", include, include + "/fmb/fmb.h"]
ffi.cdef(subprocess.check_output(headers, text=True))
fmb, NULL = ffi.dlopen(library), ffi.NULL
s = v = NULL


def need(status):
    if status != fmb.FMB_OK:
        sys.exit(f"failed: {text(fmb.fmb_system_trouble(s))}{text(fmb.fmb_solver_trouble(v))}")


def text(of):
    return ffi.string(of).decode()


def new(kind, make, *arguments):
    """What a function makes in its last argument, freed with its last use."""
    need(make(*arguments, out := ffi.new(f"fmb_{kind} **")))
    return ffi.gc(out[0], getattr(fmb, f"fmb_{kind}_free"))


s = new("system", fmb.fmb_system_new, DIM, NULL)
v = new("solver", fmb.fmb_solver_new, NULL, NULL)
need(fmb.fmb_system_add_rows(s, ROWS, *ring(float(last))))
image = new("system", lambda out: fmb.fmb_project(v, s, KEPT, len(KEPT), out, NULL))
m = new("matrix", fmb.fmb_system_matrix, image)
need(fmb.fmb_solve(v, s, r := ffi.new("fmb_result *", {"size": ffi.sizeof("fmb_result")})))
if r.verdict == fmb.FMB_FEASIBLE:
    need(fmb.fmb_solver_point(v, x := ffi.new("double[]", DIM)))
    print(f"feasible: {x[0]:g} {x[1]:g} ... {x[DIM - 1]:g}")
else:
    need(fmb.fmb_solver_conflict(v, n := ffi.new("size_t *")))
    print(f"infeasible: {n[0]} rows, up to row {fmb.fmb_solver_conflict_row(v, n[0] - 1)}")
for i in range(m.rows):
    for k in range(m.start[i], m.start[i + 1]):
        print(f"{m.coef[k]:+g} {text(fmb.fmb_system_name(image, m.var[k]))}", end=" ")
    print(f"{text(fmb.fmb_rel_text(m.rel[i]))} {m.b[i]:g}")
