NAME          t
ROWS
 N  cost
 L  row a
COLUMNS
    col one   row a              1.5
    col one   row b              1.5
ENDATA
