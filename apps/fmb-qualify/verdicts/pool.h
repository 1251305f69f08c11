/* pool.h: a given number of pairs of one class, side by side in memory. */
#ifndef QUALIFY_POOL_H
#define QUALIFY_POOL_H

#include "study/draw/pairs.h"

/* CT has both orders, in turn; ANY: shapes as the article's generator draws them. */
typedef enum verdict_kind { VERDICT_CC, VERDICT_CT, VERDICT_TT, VERDICT_ANY } verdict_kind;

typedef struct verdict_class {
    int dim;
    bool moves, meets;
    verdict_kind kind;
} verdict_class;

/* "2d-static", "CC" */
const char *verdict_case_text(int dim, bool moves);
const char *verdict_kind_text(verdict_kind kind);

/* The numbers of a frame that is still being made. */
typedef struct verdict_draft {
    double *origin, *axes, *speed; /* [dim], [dim][dim], [dim] or NULL */
} verdict_draft;

/* The source of pairs, and their changes. */
typedef struct verdict_source {
    study_pair_family family[2]; /* for disjoint pairs, for meeting pairs */
    bool near;                   /* only pairs whose axis-aligned boxes meet */
    /* Changes both frames in place, depending on the drawn numbers; or NULL. */
    void (*reshape)(const void *self, int dim, const verdict_draft f[2]);
    const void *self;
} verdict_source;

typedef struct verdict_pool {
    size_t n;
    fmb_frame *p, *q; /* [n], in the order in which they are drawn */
    uint64_t drawn;   /* pairs tested */
    study_pairs part[2];
} verdict_pool;

/* [give, verdict_pool_free] n pairs of the class; judge decides whether they meet. After a Ctrl-C
 * some pairs may not be of the class. Errors: MEMORY. */
fmb_status verdict_pool_make(const verdict_source *from, const verdict_class *c, uint64_t seed,
                             size_t n, fmb_pair *judge, verdict_pool *out);
void verdict_pool_free(verdict_pool *pool);

#endif
