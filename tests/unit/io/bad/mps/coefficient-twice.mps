NAME          test
ROWS
 N  cost
 L  lim
 G  low
COLUMNS
    x         lim                1   lim                2
ENDATA
