"""rows.py: rows.c in Python. cffi reads the headers themselves, after the C preprocessor:
python3 rows.py INCLUDE LIBRARY [RIGHT]. Ends with 77 where cffi or gcc is missing."""

import re
import shutil
import subprocess
import sys

try:
    import cffi
except ImportError:
    sys.exit(77)

ROWS, DIM = 20000, 100


def read_headers(include):
    """What <fmb/fmb.h> declares, without what it includes of the C library: cffi knows that."""
    text = subprocess.run(["gcc", "-E", "-D__attribute__(x)=", "-I", include, "-include",
                           "fmb/fmb.h", "-x", "c", "/dev/null"],
                          check=True, capture_output=True, text=True).stdout
    ours, kept = False, []
    for line in text.splitlines():
        mark = re.match(r'# \d+ "(.*?)"', line)
        if mark:
            ours = mark.group(1).startswith(include)
        elif ours:
            kept.append(line)
    return "\n".join(kept)


class Library:
    def __init__(self, include, path):
        self.ffi = cffi.FFI()
        self.ffi.cdef(read_headers(include))
        self.c = self.ffi.dlopen(path)

    def need(self, status, trouble=b""):
        if status != self.c.FMB_OK:
            said = self.ffi.string(self.c.fmb_status_text(status))
            why = self.ffi.string(trouble) if trouble else b""
            raise ValueError((said + b": " + why).decode())

    def load(self, dim, rows, right):
        """A system of rows [(variable, coefficient), ...] <= right, all at once."""
        start = [0]
        for row in rows:
            start.append(start[-1] + len(row))
        out = self.ffi.new("fmb_system **")
        self.need(self.c.fmb_system_new(dim, self.ffi.NULL, out))
        s = self.ffi.gc(out[0], self.c.fmb_system_free)
        var = [j for row in rows for j, _ in row]
        coef = [a for row in rows for _, a in row]
        self.need(self.c.fmb_system_add_rows(s, len(rows), self.ffi.new("size_t[]", start),
                                             self.ffi.new("int[]", var),
                                             self.ffi.new("double[]", coef), self.ffi.NULL,
                                             self.ffi.new("double[]", right)),
                  self.c.fmb_system_trouble(s))
        return s

    def rows(self, s):
        """The rows of a system, [([(variable, coefficient), ...], right side), ...]."""
        n, terms = self.c.fmb_system_rows(s), self.c.fmb_system_nonzeros(s)
        start, var = self.ffi.new("size_t[]", n + 1), self.ffi.new("int[]", terms)
        coef, right = self.ffi.new("double[]", terms), self.ffi.new("double[]", n)
        self.need(self.c.fmb_system_get_rows(s, 0, n, start, var, coef, self.ffi.NULL, right))
        return [([(var[k], coef[k]) for k in range(start[i], start[i + 1])], right[i])
                for i in range(n)]


def print_answer(lib, v, verdict):
    if verdict == lib.c.FMB_FEASIBLE:
        x = lib.ffi.new("double[]", DIM)
        lib.need(lib.c.fmb_solver_point(v, x), lib.c.fmb_solver_trouble(v))
        print(f"feasible: {x[0]:g} {x[1]:g} ... {x[DIM - 1]:g}")
        return
    n = lib.ffi.new("size_t *")
    lib.need(lib.c.fmb_solver_conflict(v, n), lib.c.fmb_solver_trouble(v))
    print(f"infeasible: {n[0]} rows in conflict")
    for k in (0, n[0] - 1):
        print(f"{lib.c.fmb_solver_conflict_multiplier(v, k):g} * row "
              f"{lib.c.fmb_solver_conflict_row(v, k)}")


def main():
    if not shutil.which("gcc"):
        return 77
    lib = Library(sys.argv[1], sys.argv[2])
    last = float(sys.argv[3]) if len(sys.argv) > 3 else 0
    rows = [[(i % DIM, 1), ((i % DIM + 1 + i // DIM % (DIM - 1)) % DIM, -1)]
            for i in range(ROWS - 1)]
    right = [0 if i < DIM - 1 else DIM + i % 7 for i in range(ROWS - 1)]
    s = lib.load(DIM, rows + [[(DIM - 1, 1), (0, -1)]], right + [last])
    out, r = lib.ffi.new("fmb_solver **"), lib.ffi.new("fmb_result *")
    lib.need(lib.c.fmb_solver_new(lib.ffi.NULL, lib.ffi.NULL, out))
    v = lib.ffi.gc(out[0], lib.c.fmb_solver_free)
    lib.need(lib.c.fmb_solve(v, s, r), lib.c.fmb_solver_trouble(v))
    print_answer(lib, v, r.verdict)

    # x1 + x2 <= 2, x2 <= x3 <= 3 x2, without x2.
    some = lib.load(3, [[(0, 1), (1, 1)], [(1, 1), (2, -1)], [(1, -3), (2, 1)]], [2, 0, 0])
    shadow = lib.ffi.new("fmb_system **")
    lib.need(lib.c.fmb_project(v, some, lib.ffi.new("int[]", [0, 2]), 2, shadow, lib.ffi.NULL),
             lib.c.fmb_solver_trouble(v))
    image = lib.ffi.gc(shadow[0], lib.c.fmb_system_free)
    for terms, b in lib.rows(image):
        for j, a in terms:
            name = lib.ffi.string(lib.c.fmb_system_name(image, j)).decode()
            print(f"{a:+g} {name}", end=" ")
        print(f"<= {b:g}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
