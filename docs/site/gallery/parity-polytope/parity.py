"""An extended formulation of the parity polytope, the hull of the 0/1 vectors with an even number
of ones: parity.py N > parity.fmb

The vector x is a mixture of vectors with k ones, k = 0, 2, 4, ..., with weights l_k; z_k_i is the
share of its coordinate i (Yannakakis 1991). Rows and variables grow as N^2; the facets as 2^N."""

import sys

n = int(sys.argv[1])
counts = range(0, n + 1, 2)
print("vars:", *(f"x{i}" for i in range(1, n + 1)), *(f"l_{k}" for k in counts),
      *(f"z_{k}_{i}" for k in counts for i in range(1, n + 1)))
print(" + ".join(f"l_{k}" for k in counts), "= 1")
for k in counts:
    print(f"l_{k} >= 0")
    print(" + ".join(f"z_{k}_{i}" for i in range(1, n + 1)), f"= {k} l_{k}")
    for i in range(1, n + 1):
        print(f"0 <= z_{k}_{i} <= l_{k}")
for i in range(1, n + 1):
    print(f"x{i} =", " + ".join(f"z_{k}_{i}" for k in counts))
print("project:", *(f"x{i}" for i in range(1, n + 1)))
