NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 x lim nan
ENDATA
