NAME          test
ROWS
 N  cost
 L  lim
 G  low
COLUMNS
    x         top                1
ENDATA
