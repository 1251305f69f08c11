/* article.h: the article's Table 1 anew: both methods of its program and ours, cell by cell. */
#ifndef QUALIFY_ARTICLE_H
#define QUALIFY_ARTICLE_H

#include "fmb-qualify/verdicts/duel.h"

/* FMB and SAT as in the article's program; ours from frames to verdicts; ours on frames stored in
 * sets, where nearly all time is that of the kernels. */
typedef enum article_way {
    ARTICLE_LISTED,
    ARTICLE_ASKED,
    ARTICLE_PACKED,
    ARTICLE_WAYS
} article_way;

/* Distinct pairs, one after the other; times of a query over the passes [ns]. */
typedef struct article_duel {
    study_spread fmb, sat;
    study_ratio fmb_sat;
    size_t wrong; /* verdicts of FMB or SAT that differ from the class */
} article_duel;

/* As the article measures its program: each pair again and again. Means over the pairs. */
typedef struct article_repeated {
    size_t pairs;
    double fmb, sat, best;    /* [ns]; best: the faster one for each pair */
    double mean, least, most; /* of FMB over SAT */
    double first[2]; /* the mean where A is a cuboid, a simplex: CT in both orders; or NaN */
} article_repeated;

typedef struct article_cell {
    verdict_class class;
    size_t queries;
    uint64_t drawn; /* pairs tested to find them */
    bool complete;
    article_duel duel[ARTICLE_WAYS];
    article_repeated repeated;
} article_cell;

/* Errors: ARG (instructions that the processor lacks), MEMORY. */
fmb_status article_cell_run(const verdict_class *c, const qualify_setup *o, article_cell *out);

/* The value of a cell in the article's Table 1. */
double article_published(const verdict_class *c);

/* Adds the numbers to the page, then tables and texts about them. */
void article_report(const article_cell *cell, size_t n, qualify_page *page);

#endif
