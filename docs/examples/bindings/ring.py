"""The data of rows.py, a matrix of compressed rows as a program of yours has it; see ring.h."""

ROWS, DIM = 20000, 100
KEPT = [0, DIM // 2, DIM - 1]


def ring(last):
    """Starts of rows, variables, coefficients, relations (0 is FMB_LE), right sides."""
    var = [(i + k) % DIM for i in range(ROWS) for k in (0, 1)]
    b = [0 if i < DIM - 1 else i for i in range(ROWS - 1)] + [last]
    return list(range(0, 2 * ROWS + 1, 2)), var, [1, -1] * ROWS, [0] * ROWS, b
