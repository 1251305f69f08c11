NAME          TINY
ROWS
 N  COST
 L  LIM1
 G  MYEQN
COLUMNS
    X         COST         1.0   LIM1         1.0
    X         MYEQN        1.0
    Y         COST         2.0   LIM1         1.0
RHS
    RHS       LIM1         4.0   MYEQN        1.5
BOUNDS
 UP BND       X            4.0
ENDATA
