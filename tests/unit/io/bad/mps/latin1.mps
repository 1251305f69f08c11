NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 é lim 1
ENDATA
