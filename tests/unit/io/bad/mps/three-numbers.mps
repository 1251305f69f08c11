NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 x lim 1 low 2 cost 3
ENDATA
