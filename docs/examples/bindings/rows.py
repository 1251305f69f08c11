"""rows.py: rows.c in Python; cffi reads the headers: rows.py INCLUDE LIBRARY [RIGHT]."""

import subprocess
import sys

import cffi

ROWS, DIM = 20000, 100
include, library, last = (sys.argv + ["5"])[1:4]
ffi = cffi.FFI()
headers = ["gcc", "-E", "-P", "-DFMB_DECLARATIONS_ONLY", "-I", include, include + "/fmb/fmb.h"]
ffi.cdef(subprocess.check_output(headers, text=True))
fmb = ffi.dlopen(library)


def text(of):
    return ffi.string(of).decode()


def need(status, trouble=ffi.new("char *")):
    if status != fmb.FMB_OK:
        sys.exit(f"{text(fmb.fmb_status_text(status))}: {text(trouble)}")


def owned(out, free):
    return ffi.gc(out[0], free)


# Row i: a variable is at most b beyond the next in the ring.
var = [(i + k) % DIM for i in range(ROWS) for k in (0, 1)]
b = [0 if i < DIM - 1 else i for i in range(ROWS - 1)] + [float(last)]
need(fmb.fmb_system_new(DIM, ffi.NULL, out := ffi.new("fmb_system **")))
s = owned(out, fmb.fmb_system_free)
need(fmb.fmb_system_add_rows(s, ROWS, list(range(0, 2 * ROWS + 1, 2)), var, [1, -1] * ROWS,
                             ffi.NULL, b), fmb.fmb_system_trouble(s))
need(fmb.fmb_solver_new(ffi.NULL, ffi.NULL, out := ffi.new("fmb_solver **")))
v = owned(out, fmb.fmb_solver_free)
r = ffi.new("fmb_result *", {"size": ffi.sizeof("fmb_result")})
need(fmb.fmb_solve(v, s, r), fmb.fmb_solver_trouble(v))
if r.verdict == fmb.FMB_FEASIBLE:
    need(fmb.fmb_solver_point(v, x := ffi.new("double[]", DIM)), fmb.fmb_solver_trouble(v))
    print(f"feasible: {x[0]:g} {x[1]:g} ... {x[DIM - 1]:g}")
else:
    need(fmb.fmb_solver_conflict(v, n := ffi.new("size_t *")), fmb.fmb_solver_trouble(v))
    print(f"infeasible: {n[0]} rows, up to row {fmb.fmb_solver_conflict_row(v, n[0] - 1)}")
keep = [0, DIM // 2, DIM - 1]
need(fmb.fmb_project(v, s, keep, 3, out := ffi.new("fmb_system **"), ffi.NULL),
     fmb.fmb_solver_trouble(v))
image = owned(out, fmb.fmb_system_free)
need(fmb.fmb_system_matrix(image, out := ffi.new("fmb_matrix **")))
m = owned(out, fmb.fmb_matrix_free)
for i in range(m.rows):
    for k in range(m.start[i], m.start[i + 1]):
        print(f"{m.coef[k]:+g} {text(fmb.fmb_system_name(image, m.var[k]))}", end=" ")
    print(f"{text(fmb.fmb_rel_text(m.rel[i]))} {m.b[i]:g}")
