/* shortest.h: doubles as decimals that tell them from all others. */
#ifndef APP_SHORTEST_H
#define APP_SHORTEST_H

/* [give, free()] The first of %.15g, %.16g and %.17g that is read as d again. */
char *app_shortest(double d);

#endif
