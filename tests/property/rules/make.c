/* make.c: see make.h. Everything is an int64: where numbers are near 2^62, a row has one of them
 * and is neither multiplied nor summed up. */
#include <string.h>

#include "make.h"
#include "rows.h"
#include "support.h"

enum { VARIABLES = 6, ROWS = 14 };

typedef enum size_class { TERNARY, SMALL, MEDIUM, NEAR_2_31, NEAR_2_62 } size_class;
typedef enum plan { POINT, CONFLICT, CONE, FREE } plan;

/* A row a.x REL b; b last. */
typedef struct line {
    int64_t cell[VARIABLES + 1];
    fmb_rel rel;
} line;

typedef struct draft {
    support_rng g;
    int n, m;
    size_class size;
    plan plan;
    int zeros;                         /* of 100 coefficients */
    int strict, equal, single, copied; /* of 100 rows */
    int point[VARIABLES];
    line row[ROWS];
} draft;

/* One of n choices with these weights out of 100. */
static int pick(support_rng *g, const int *weight)
{
    int left = support_between(g, 1, 100), i = 0;
    while (left > weight[i])
        left -= weight[i++];
    return i;
}

static int64_t number(draft *d)
{
    static const int range[] = {1, 3, 9, 3, 3};
    int r = range[d->size];
    return support_between(&d->g, -r, r);
}

static void add_large(draft *d, line *l)
{
    int j = support_between(&d->g, 0, d->n - 1);
    int64_t large =
        ((int64_t)1 << (d->size == NEAR_2_31 ? 31 : 62)) + support_between(&d->g, -2, 2);
    l->cell[j] = support_chance(&d->g, 50) ? large : -large;
}

static int64_t right_side(draft *d, const line *l)
{
    int64_t b = 0;
    if (d->plan == CONE)
        return 0;
    if (d->plan != POINT)
        return number(d);
    for (int j = 0; j < d->n; j++)
        b += l->cell[j] * d->point[j];
    return l->rel == FMB_EQ || support_chance(&d->g, 50) ? b : b + support_between(&d->g, 0, 2);
}

static void fresh(draft *d, line *l)
{
    *l = (line){.rel = support_chance(&d->g, d->equal)    ? FMB_EQ
                       : support_chance(&d->g, d->strict) ? FMB_LT
                                                          : FMB_LE};
    if (support_chance(&d->g, d->single)) {
        l->cell[support_between(&d->g, 0, d->n - 1)] = support_chance(&d->g, 50) ? 1 : -1;
    } else {
        for (int j = 0; j < d->n; j++)
            l->cell[j] = support_chance(&d->g, d->zeros) ? 0 : number(d);
        if (d->size >= NEAR_2_31 && support_chance(&d->g, 30))
            add_large(d, l);
    }
    l->cell[d->n] = right_side(d, l);
}

/* A copy, a multiple, or a parallel to the row `of`. */
static void copy(draft *d, line *l, const line *of)
{
    int factor = d->size < NEAR_2_31 ? support_between(&d->g, 1, 3) : 1;
    for (int j = 0; j <= d->n; j++)
        l->cell[j] = of->cell[j] * factor;
    l->rel = of->rel;
    if (support_chance(&d->g, 40))
        l->cell[d->n] += support_between(&d->g, -1, 1);
    if (l->rel != FMB_EQ && support_chance(&d->g, d->strict))
        l->rel = FMB_LT;
}

/* The last row of the first `size` is what the others lack to 0 <= -1 or to 0 < 0. */
static void close_conflict(draft *d, int size)
{
    line *last = &d->row[size - 1];
    memset(last->cell, 0, sizeof last->cell);
    last->rel = support_chance(&d->g, d->strict) ? FMB_LT : FMB_LE;
    for (int i = 0; i < size - 1; i++) {
        int factor = support_between(&d->g, 1, 3);
        for (int j = 0; j <= d->n; j++)
            last->cell[j] -= factor * d->row[i].cell[j];
    }
    last->cell[d->n] -= last->rel == FMB_LT && support_chance(&d->g, 50) ? 0 : 1;
}

static void shuffle(draft *d)
{
    for (int i = d->m - 1; i > 0; i--) {
        int k = support_between(&d->g, 0, i);
        line keep = d->row[i];
        d->row[i] = d->row[k];
        d->row[k] = keep;
    }
}

static void choose(draft *d)
{
    static const int size[] = {20, 35, 25, 10, 10}, plans[] = {30, 45, 10, 15};
    support_rng *g = &d->g;
    d->n = support_between(g, support_chance(g, 80) ? 3 : 2, VARIABLES);
    d->m = support_between(g, d->n + 2, ROWS);
    d->size = (size_class)pick(g, size);
    d->plan = (plan)pick(g, plans);
    if (d->size == NEAR_2_62 && d->plan == CONFLICT)
        d->plan = FREE;
    d->zeros = d->n < 4 ? 10 : d->n == 4 ? 25 : support_between(g, 30, 60);
    d->strict = support_chance(g, 65) ? 25 : 0;
    d->equal = support_chance(g, 25) ? 12 : 0;
    d->single = support_chance(g, 40) ? support_between(g, 10, 60) : 0;
    d->copied = support_chance(g, 70) ? support_between(g, 10, 40) : 0;
    for (int j = 0; j < d->n; j++)
        d->point[j] = support_between(g, -1, 1);
}

fmb_system *make_system(uint64_t seed)
{
    draft d = {.g = {seed}};
    choose(&d);
    int size = d.plan == CONFLICT ? support_between(&d.g, 2, d.n + 1 < d.m ? d.n + 1 : d.m) : 0;
    for (int i = 0; i < d.m; i++)
        if (i > size && support_chance(&d.g, d.copied))
            copy(&d, &d.row[i], &d.row[support_between(&d.g, 0, i - 1)]);
        else
            fresh(&d, &d.row[i]);
    if (size > 0)
        close_conflict(&d, size);
    shuffle(&d);
    fmb_system *s = rows_none(d.n);
    for (int i = 0; i < d.m; i++)
        must(fmb_system_add_int(s, d.row[i].cell, d.row[i].rel, d.row[i].cell[d.n]));
    return s;
}
