NAME test
ROWS
 N cost
 L lim
 G low
COLUMNS
 M1 'MARKER' 'INTORG'
 x lim 1
 M2 'MARKER'
 y lum 1
ENDATA
