* comment
NAME
OBJSENSE MAX
ROWS
 N o
 L long_name_of_a_row

 E e
COLUMNS
 x(1) long_name_of_a_row 1.5 e 1 $ comment
 y e -2e-3
RHS
 R e 0.3
BOUNDS
 FX B x(1) 1
 BV B y
ENDATA
