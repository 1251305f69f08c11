NAME          t
ROWS
 N  cost
 L  lim
COLUMNS
    CO        lim                1
BOUNDS
 FX BND       CO                 1
 FX BND       C O                2
ENDATA
