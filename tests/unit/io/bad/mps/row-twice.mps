NAME          test
ROWS
 N  cost
 L  lim
 L  lim
COLUMNS
ENDATA
