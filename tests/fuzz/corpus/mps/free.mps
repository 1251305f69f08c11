* comment
NAME
OBJSENSE MAX
OBJNAME o
ROWS
 N o
 L long_name_of_a_row

 E e
COLUMNS
 x(1) long_name_of_a_row 1.5 e 1 $ comment
 y e -2e-3 o 1
RHS
 R e 0.3
 R o -7
BOUNDS
 FX B x(1) 1
 BV B y
ENDATA
