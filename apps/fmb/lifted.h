/* lifted.h: the common code of commands about several polyhedra whose answers are projections of a
 * lift (<fmb/lift.h>), from command line to exit code.
 */
#ifndef APP_LIFTED_H
#define APP_LIFTED_H

#include <fmb/lift.h>

#include "fmb/query.h"

enum { APP_MOST_FILES = 4096 };

/* The contents of the FILEs, in order. */
typedef struct app_polyhedra {
    fmb_system **system;        /* [n] each, or a lift of its generators */
    fmb_generators **generator; /* [n], NULL where there are rows */
    size_t n;
    fmb_system *graph; /* of the map, or NULL */
} app_polyhedra;

/* The query of the solver: *lift may stay NULL. */
typedef fmb_status app_lifted_query(fmb_solver *v, const app_polyhedra *p, fmb_system **lift,
                                    fmb_system **out, fmb_result *res);

typedef struct app_lifted {
    const char *args, *doc;
    bool map; /* the last FILE is a map over the first */
    app_lifted_query *query;
    /* Or NULL: the query if all files have generators and the lift, which has a variable for each
     * generator, is not requested: all of system[] are then NULL. */
    app_lifted_query *query_of_generators;
} app_lifted;

/* Run the command; its exit code. */
int app_lifted_run(const app_lifted *command, int argc, char **argv);

#endif
