NAME t
ROWS
 L r
COLUMNS
 x r 1
 y r 1
 x r 2
ENDATA
