/* article.h: the article's Table 1 again: its program's two ways and ours, cell by cell. */
#ifndef QUALIFY_ARTICLE_H
#define QUALIFY_ARTICLE_H

#include "fmb-qualify/verdicts/duel.h"

/* FMB and SAT as the article's program has them; ours from frames to verdicts; ours on frames that
 * are stored in sets, where little but the kernels is left. */
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
    size_t wrong; /* verdicts that are not the class's, of either */
} article_duel;

/* As the article measures its program: each pair again and again. Means over the pairs. */
typedef struct article_repeated {
    size_t pairs;
    double fmb, sat, best;    /* [ns]; best: of whichever is faster for the pair */
    double mean, least, most; /* of FMB over SAT */
    double first[2]; /* the mean where A is a cuboid, a simplex: CT in both orders; or NaN */
} article_repeated;

typedef struct article_cell {
    verdict_class class;
    size_t queries;
    uint64_t drawn; /* pairs looked at to find them */
    bool complete;
    article_duel duel[ARTICLE_WAYS];
    article_repeated repeated;
} article_cell;

/* Errors: ARG (instructions that the processor lacks), MEMORY. */
fmb_status article_cell_run(const verdict_class *c, const qualify_setup *o, article_cell *out);

/* What the article's Table 1 has for a cell. */
double article_published(const verdict_class *c);

/* The numbers first, then the tables and texts of them. */
void article_report(const article_cell *cell, size_t n, qualify_page *page);

#endif
