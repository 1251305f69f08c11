NAME t
OBJNAME
 profit
ROWS
 N cost
 L r
COLUMNS
 x cost 1 r 1
ENDATA
