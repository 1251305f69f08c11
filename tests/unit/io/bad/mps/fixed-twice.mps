NAME          test
ROWS
 N  cost
 L  lim
 G  low
COLUMNS
    x         cost               1   lim                1
    y         lim                2   low                1
BOUNDS
 FX BND       x                  1
 FX BND       x                  2
ENDATA
