NAME          fixed
ROWS
 N  cost
 L  lim
 G  low
 E  eq
COLUMNS
    i         'MARKER'                 'INTORG'
    x         cost               1   lim              0.1
    j         'MARKER'                 'INTEND'
    y         lim                2   low               1.
    y         eq               -.5
RHS
    RHS       lim              1e2   low                1
RANGES
    RNG       lim              0.7   eq              -2.5
BOUNDS
 UP BND       x                  4
 MI BND       y
ENDATA
