NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 x lim 1,5
ENDATA
