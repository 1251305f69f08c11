NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 x lim 1e999999999
ENDATA
