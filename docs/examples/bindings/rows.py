"""rows.py: rows.c in Python; cffi reads the headers: rows.py INCLUDE LIBRARY [RIGHT]."""

import subprocess
import sys

import cffi

ROWS, DIM = 20000, 100
include, library, last = (sys.argv + ["5"])[1:4]
ffi = cffi.FFI()
headers = ["gcc", "-E", "-P", "-DFMB_DECLARATIONS_ONLY", "-I", include, include + "/fmb/fmb.h"]
ffi.cdef(subprocess.check_output(headers, text=True))
fmb, NULL = ffi.dlopen(library), ffi.NULL
s = v = NULL


def text(of):
    return ffi.string(of).decode()


def need(status):
    if status != fmb.FMB_OK:
        sys.exit(f"failed: {text(fmb.fmb_system_trouble(s))}{text(fmb.fmb_solver_trouble(v))}")


def new(kind, make, *arguments):
    """What a function makes in its last argument, freed with its last use."""
    out = ffi.new(f"fmb_{kind} **")
    need(make(*arguments, out))
    return ffi.gc(out[0], getattr(fmb, f"fmb_{kind}_free"))


# Row i: a variable is at most b beyond the next in the ring.
start, var = list(range(0, 2 * ROWS + 1, 2)), [(i + k) % DIM for i in range(ROWS) for k in (0, 1)]
b = [0 if i < DIM - 1 else i for i in range(ROWS - 1)] + [float(last)]
s = new("system", fmb.fmb_system_new, DIM, NULL)
v = new("solver", fmb.fmb_solver_new, NULL, NULL)
need(fmb.fmb_system_add_rows(s, ROWS, start, var, [1, -1] * ROWS, NULL, b))
image = new("system", lambda out: fmb.fmb_project(v, s, [0, DIM // 2, DIM - 1], 3, out, NULL))
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
