/* properties.c: what must not change an answer: the order of rows, positive factors, the names and
 * order of variables, redundant rows, and projecting in two steps. Projections stay the same to the
 * letter. */
#include <stdlib.h>

#include "agree_inside.h"
#include "question.h"

/* order[0..n) becomes a permutation. */
static void shuffle(support_rng *rng, int *order, int n)
{
    for (int i = 0; i < n; i++)
        order[i] = i;
    for (int i = n - 1; i > 0; i--) {
        int k = support_between(rng, 0, i), keep = order[i];
        order[i] = order[k];
        order[k] = keep;
    }
}

/* A row as numbers, dense. */
typedef struct line {
    mpq_t cell[65]; /* dim coefficients, right side */
    int var[64], dim;
} line;

static void line_init(line *l, int dim)
{
    l->dim = dim;
    for (int j = 0; j <= dim; j++)
        mpq_init(l->cell[j]);
    for (int j = 0; j < dim; j++)
        l->var[j] = j;
}

static void line_clear(line *l)
{
    for (int j = 0; j <= l->dim; j++)
        mpq_clear(l->cell[j]);
}

/* Add factor times row i. */
static void line_add(line *l, const fmb_system *s, size_t i, const mpq_t factor)
{
    mpq_t q;
    mpq_init(q);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, q);
        mpq_mul(q, q, factor);
        mpq_add(l->cell[j], l->cell[j], q);
    }
    fmb_system_rhs_q(s, i, q);
    mpq_mul(q, q, factor);
    mpq_add(l->cell[l->dim], l->cell[l->dim], q);
    mpq_clear(q);
}

static void line_put(line *l, fmb_system *s, fmb_rel rel)
{
    must(fmb_system_add_q(s, (size_t)l->dim, l->var, l->cell, rel, l->cell[l->dim]));
}

static void random_factor(support_rng *rng, mpq_t q)
{
    int high = support_chance(rng, 20) ? 2000000000 : 9;
    mpq_set_ui(q, (unsigned long)support_between(rng, 1, high),
               (unsigned long)support_between(rng, 1, high));
    mpq_canonicalize(q);
}

/* s with rows in random order, scaled if asked, and its variables renumbered by map. */
static fmb_system *disguised(const fmb_system *s, support_rng *rng, bool scale, const int *map)
{
    int rows = (int)fmb_system_rows(s), dim = fmb_system_dim(s);
    int *order = malloc((size_t)(rows + 1) * sizeof *order);
    fmb_system *t = rows_none(dim), *scaled = rows_none(dim);
    mpq_t factor;
    mpq_init(factor);
    mpq_set_ui(factor, 1, 1);
    shuffle(rng, order, rows);
    for (int i = 0; i < rows; i++) {
        line l;
        line_init(&l, dim);
        if (scale)
            random_factor(rng, factor);
        line_add(&l, s, (size_t)order[i], factor);
        line_put(&l, scaled, fmb_system_rel(s, (size_t)order[i]));
        line_clear(&l);
    }
    rows_append_but(t, scaled, SIZE_MAX, map);
    fmb_system_free(scaled);
    mpq_clear(factor);
    free(order);
    return t;
}

/* s with rows that follow from it: sums of inequalities with slack, rows said again. */
static fmb_system *padded(const fmb_system *s, support_rng *rng)
{
    int rows = (int)fmb_system_rows(s), dim = fmb_system_dim(s);
    fmb_system *t = NULL;
    mpq_t factor;
    mpq_init(factor);
    must(fmb_system_copy(s, &t));
    for (int more = 0; rows > 0 && more < 3; more++) {
        line l;
        line_init(&l, dim);
        for (int k = 0; k < 2; k++) {
            random_factor(rng, factor);
            line_add(&l, s, (size_t)support_between(rng, 0, rows - 1), factor);
        }
        mpq_set_ui(factor, (unsigned long)support_between(rng, 0, 2), 1);
        mpq_add(l.cell[dim], l.cell[dim], factor);
        line_put(&l, t, FMB_LE);
        line_clear(&l);
        rows_append(t, s, (size_t)support_between(rng, 0, rows - 1), ROW_SAME, NULL);
    }
    mpq_clear(factor);
    return t;
}

/* The truth about s, told of other, whose variable map[j] is variable j of s. */
static void translate(truth *to, const truth *t, const fmb_system *other, const int *map)
{
    int dim = fmb_system_dim(other);
    *to = (truth){.s = other, .verdict = t->verdict};
    if (!t->end)
        return;
    to->end = calloc((size_t)dim + 1, sizeof *to->end);
    for (int j = 0; j < dim; j++)
        for (int side = 0; side < 2; side++) {
            study_textbook_end *e = &to->end[map[j]][side];
            mpq_init(e->value);
            mpq_set(e->value, t->end[j][side].value);
            e->kind = t->end[j][side].kind;
            e->attained = t->end[j][side].attained;
        }
}

/* r, whose variables came in another order, has the form of q once it is projected on all of them.
 */
static bool agree_renamed_form(agree *g, fmb_solver *v, const fmb_system *r, const fmb_system *q)
{
    fmb_system *p = NULL;
    fmb_result result = {.size = sizeof result};
    int all[64];
    for (int j = 0; j < fmb_system_dim(r); j++)
        all[j] = j;
    must(fmb_project(v, r, all, fmb_system_dim(r), &p, &result));
    bool good = agree_form(g, result.stop == FMB_STOP_DONE ? p : NULL, q);
    fmb_system_free(p);
    return good;
}

static bool same_answers(agree *g, fmb_solver *v, const truth *t, fmb_system *other, const int *map,
                         uint64_t choice)
{
    truth u;
    int keep[64], back[64], n = question_keep(choice, fmb_system_dim(other), keep), k = 0;
    translate(&u, t, other, map);
    bool good = agree_solve(g, v, &u) && agree_bound(g, v, &u);
    fmb_system *p = NULL, *q = NULL, *r = NULL;
    fmb_result result = {.size = sizeof result};
    /* Keep in other what map makes of keep in s. */
    int wanted[64] = {0}, place[64];
    for (int i = 0; i < n; i++)
        wanted[map[keep[i]]] = 1;
    for (int j = 0; j < fmb_system_dim(other); j++) {
        place[j] = k;
        if (wanted[j])
            back[k++] = j;
    }
    if (good) {
        must(fmb_project(v, t->s, keep, n, &p, &result));
        must(fmb_project(v, other, back, n, &q, &result));
    }
    if (p && q) { /* else a limit was reached */
        int names[64];
        for (int i = 0; i < n; i++)
            names[i] = place[map[keep[i]]];
        r = rows_none(n);
        rows_append_but(r, p, SIZE_MAX, names);
        good = agree_same(g, r, q) && agree_renamed_form(g, v, r, q);
    }
    fmb_system_free(p);
    fmb_system_free(q);
    fmb_system_free(r);
    truth_clear(&u);
    fmb_system_free(other);
    return good;
}

/* Onto K and then onto a part of K is the same as onto the part. */
static bool twice(agree *g, fmb_solver *v, const truth *t, uint64_t choice)
{
    int dim = fmb_system_dim(t->s), all[64], some[64], inner[64];
    uint64_t part = choice & (choice >> 8);
    int n = question_keep(choice, dim, all), m = question_keep(part & choice, dim, some), k = 0;
    for (int i = 0; i < n; i++)
        if (part >> all[i] & 1)
            inner[k++] = i;
    fmb_system *p = NULL, *q = NULL, *direct = NULL;
    fmb_result r = {.size = sizeof r};
    must(fmb_project(v, t->s, all, n, &p, &r));
    must(fmb_project(v, t->s, some, m, &direct, &r));
    if (p)
        must(fmb_project(v, p, inner, m, &q, &r));
    bool good = !p || !q || !direct || (agree_same(g, q, direct) && agree_form(g, q, direct));
    fmb_system_free(p);
    fmb_system_free(q);
    fmb_system_free(direct);
    return good;
}

bool property_holds(const question *q, agree *g, fmb_solver *v, const truth *t)
{
    support_rng rng = {q->choice};
    int dim = fmb_system_dim(t->s), map[64];
    for (int j = 0; j < dim; j++)
        map[j] = j;
    switch (q->kind) {
    case ASK_TWICE:
        return twice(g, v, t, q->choice);
    case ASK_PADDED:
        return same_answers(g, v, t, padded(t->s, &rng), map, q->choice);
    case ASK_RENAMED:
        shuffle(&rng, map, dim);
        break;
    default:
        break;
    }
    fmb_system *other = disguised(t->s, &rng, q->kind == ASK_SCALED, map);
    return same_answers(g, v, t, other, map, q->choice);
}
