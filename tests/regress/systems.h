/* systems.h: systems that once broke an elimination somewhere, with their answers. */
#ifndef FMB_TEST_SYSTEMS_H
#define FMB_TEST_SYSTEMS_H

#include <fmb/system.h>

#define REGRESS_DIM  4
#define REGRESS_ROWS 7

/* Rows a.x <= b as {a1, ..., a_dim, b}. */
typedef struct regress {
    const char *name;
    int dim, rows;
    int row[REGRESS_ROWS][REGRESS_DIM + 1];
    fmb_verdict verdict;
    /* If keep >= 0: the projection on this variable is the one row `shadow`, {a, b} with relation
     * shadow_rel, where the kept variable comes first. */
    int keep;
    int shadow[2];
    fmb_rel shadow_rel;
} regress;

extern const regress regress_systems[];
extern const int regress_count;

/* [give] The system, with variable j of the table as variable place[j]. */
fmb_system *regress_build(const regress *r, const int *place);

#endif
