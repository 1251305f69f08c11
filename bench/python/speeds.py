#!/usr/bin/env python3
"""How far above C is Python? 10,000 tiny queries, a million pairs from arrays, 20,000 rows of a sparse
matrix of SciPy's. Seconds of the processor, Python and bench-python in turns, each after a pass that is
not counted, so that neither finds what it reads in farther caches than the other; medians.

usage: speeds.py PACKAGE_FOLDER BENCH_PYTHON"""

import subprocess
import sys
import tempfile
import time

QUERIES, FRAMES, PAIRS, ROWS, ROUNDS = 10000, 20000, 1000000, 20000, 9


def clocked(work):
    begin = time.process_time()
    work()
    return time.process_time() - begin


def median(numbers):
    return sorted(numbers)[len(numbers) // 2]


def in_turns(work, *program):
    """Medians of Python and of C."""
    python, c = [], []
    for _ in range(ROUNDS):
        c.append(float(subprocess.run(program, capture_output=True, text=True, check=True).stdout))
        work()
        python.append(clocked(work))
    return median(python), median(c)


def tiny(program):
    systems = [fmb.System.from_arrays([[1, 1], [-1, 2]], [3 + k % 7, -4 - k % 5], ["<=", "<"])
               for k in range(QUERIES)]

    def ask():
        for s in systems:
            fmb.solve(s)
    python, c = in_turns(ask, program, "tiny", str(QUERIES))
    print(f"tiny query: {python / QUERIES * 1e6:.2f} us, in C {c / QUERIES * 1e6:.2f}: "
          f"{(python - c) / QUERIES * 1e6:.2f} us above (bar 5)")


def pairs(program):
    draw = np.random.default_rng(1)
    origin, axes = draw.uniform(-10, 10, (FRAMES, 3)), draw.uniform(-10, 10, (FRAMES, 3, 3))
    pair = draw.integers(0, FRAMES, (PAIRS, 2), np.uint32)

    def ask():
        frames = fmb.Frames(origin, axes)
        frames.test(frames, pair)
    with tempfile.NamedTemporaryFile() as file:
        file.write(origin.tobytes() + axes.tobytes() + pair.tobytes())
        file.flush()
        python, c = in_turns(ask, program, "pairs", file.name, str(FRAMES), str(PAIRS))
    print(f"{PAIRS} pairs: {python * 1e3:.1f} ms, in C {c * 1e3:.1f}: {python / c:.3f} of it (bar 1.10)")


def load():
    import scipy.sparse
    A = scipy.sparse.random(ROWS, 500, density=0.01, format="csr", random_state=1)
    b = np.ones(ROWS)
    taken = median([clocked(lambda: fmb.System.from_arrays(A, b)) for _ in range(ROUNDS)])
    print(f"{ROWS} rows of SciPy, {A.nnz} numbers: {taken * 1e3:.1f} ms (bar 30)")


def main():
    tiny(sys.argv[2])
    pairs(sys.argv[2])
    load()


sys.path.insert(0, sys.argv[1])
import fmb  # pylint: disable=wrong-import-position
import numpy as np

if __name__ == "__main__":
    main()
