/* shortest.h: doubles as decimals that identify them. */
#ifndef APP_SHORTEST_H
#define APP_SHORTEST_H

/* [give, free()] The first of %.15g, %.16g and %.17g that reads back as d. */
char *app_shortest(double d);

#endif
