NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 x lim 1e-999999999
ENDATA
