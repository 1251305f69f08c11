/* scene.h: the rows of a system in the form that the engines take. */
#ifndef FMB_TEST_SCENE_H
#define FMB_TEST_SCENE_H

#include "lp/model/row.h"
#include "solve/query/part.h"
#include "support/support.h"

typedef struct scene {
    fmb_options options;
    atomic_int cancel;
    fmb_mem mem;
    fmb_run run;
    fmb_arena arena;
    fmb_parts parts;
    size_t n, m;
    fmb_lp_row *row; /* [m] primitive, over all variables that some row names */
    fmb_rel *rel;    /* [m] */
} scene;

/* All rows of s but constant ones, as one part; false if there are none. */
bool scene_open(scene *c, const fmb_system *s);
/* Nothing is left in the memory of the scene. */
void scene_close(scene *c);
/* sum_k factor_k row_k, at column j (n: the right side), of w's rows. */
void scene_combine(const scene *c, const uint32_t *index, mpq_t *factor, size_t size, size_t j,
                   mpq_t out);
/* a.x - b of row i. */
void scene_excess(const scene *c, size_t i, mpq_t *x, mpq_t out);
/* Does x[n] satisfy row i? */
bool scene_holds(const scene *c, size_t i, mpq_t *x);

#endif
