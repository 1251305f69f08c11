NAME          test
ROWS
 N  cost
 L  lim
 G  low
COLUMNS
    x         cost               1   lim                1
    y         lim                2   low                1
BOUNDS
 UP BND       z                  1
ENDATA
