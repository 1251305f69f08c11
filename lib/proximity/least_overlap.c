/* least_overlap.c: see least_overlap.h.
 *
 * All normals of flat.h in integers. The least of o / |n| is found by comparing o^2 |m|^2 with
 * p^2 |n|^2, or o |m| with p |n| where sizes are sums. A normal that is 0 does not count. If all
 * are 0 then M is at most a segment: anything at right angles to it is a normal.
 */
#include "proximity/least_overlap.h"

#include "frame/flat.h"

typedef struct normal_search {
    fmb_minkowski *m;
    fmb_norm norm;
    fmb_flat_kind kind;
    mpz_t direction[FMB_FLAT_DIRECTIONS][3];
    fmb_least_overlap at; /* the one at hand */
    mpz_t low, high, span[2], t, s;
} normal_search;

static void for_each_number(normal_search *x, void (*what)(mpz_ptr))
{
    mpz_ptr one[] = {x->low, x->high, x->span[0], x->span[1], x->t, x->s};
    for (size_t i = 0; i < sizeof one / sizeof *one; i++)
        what(one[i]);
    for (int i = 0; i < FMB_FLAT_DIRECTIONS; i++)
        for (int j = 0; j < 3; j++)
            what(x->direction[i][j]);
}

static void start_number(mpz_ptr x)
{
    mpz_init(x);
}

static void end_number(mpz_ptr x)
{
    mpz_clear(x);
}

void fmb_least_overlap_init(fmb_least_overlap *x)
{
    x->found = false;
    mpz_inits(x->normal[0], x->normal[1], x->normal[2], x->overlap, x->size, NULL);
}

void fmb_least_overlap_clear(fmb_least_overlap *x)
{
    mpz_clears(x->normal[0], x->normal[1], x->normal[2], x->overlap, x->size, NULL);
}

static mpz_t *row_of(const normal_search *x, int side, int row)
{
    return x->m->frame[side].row + row * x->m->dim;
}

static void read_directions(normal_search *x)
{
    for (int side = 0; side < 2; side++) {
        const fmb_flat_side *s = &x->kind.side[side];
        mpz_t(*to)[3] = x->direction + side * FMB_FLAT_MOST_EDGES;
        for (int i = 0; i < s->edges; i++) {
            const uint8_t *ends = i < s->naxes ? NULL : fmb_flat_ends(i, s->naxes);
            for (int j = 0; j < x->m->dim; j++) {
                if (ends)
                    mpz_sub(to[i][j], to[ends[1]][j], to[ends[0]][j]);
                else
                    mpz_set(to[i][j], row_of(x, side, 1 + i)[j]);
            }
        }
    }
    for (int j = 0; j < x->m->dim; j++) {
        mpz_set(x->direction[FMB_FLAT_DRIFT][j], x->m->drift[j]);
        mpz_set_ui(x->direction[FMB_FLAT_WORLD + j][j], 1);
    }
}

static void measure_normal(normal_search *x)
{
    fmb_least_overlap *n = &x->at;
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        fmb_minkowski_dot(x->m, n->normal, n->normal, n->size);
        return;
    }
    mpz_set_ui(n->size, 0);
    for (int j = 0; j < x->m->dim; j++) {
        mpz_abs(x->t, n->normal[j]);
        mpz_add(n->size, n->size, x->t);
    }
}

/* The normal of number i. */
static void make_normal(normal_search *x, int i)
{
    mpz_t *f = x->direction[x->kind.normal[i][0]], *g = x->direction[x->kind.normal[i][1]];
    mpz_t *n = x->at.normal;
    if (x->m->dim == 2) {
        mpz_set(n[0], f[1]);
        mpz_neg(n[1], f[0]);
    }
    for (int j = 0; x->m->dim == 3 && j < 3; j++) {
        mpz_mul(n[j], f[(j + 1) % 3], g[(j + 2) % 3]);
        mpz_submul(n[j], f[(j + 2) % 3], g[(j + 1) % 3]);
    }
}

/* Add sign times what a side spans along the normal to [low, high]. */
static void add_span(normal_search *x, int side, int sign)
{
    const fmb_flat_side *f = &x->kind.side[side];
    mpz_set_ui(x->span[0], 0);
    mpz_set_ui(x->span[1], 0);
    for (int i = 0; i < f->naxes; i++) {
        fmb_minkowski_dot(x->m, x->at.normal, row_of(x, side, 1 + i), x->t);
        if (sign < 0)
            mpz_neg(x->t, x->t);
        mpz_ptr end = x->span[mpz_sgn(x->t) > 0];
        if (!f->simplex)
            mpz_add(end, end, x->t);
        else if (mpz_cmpabs(x->t, end) > 0)
            mpz_set(end, x->t);
    }
    mpz_add(x->low, x->low, x->span[0]);
    mpz_add(x->high, x->high, x->span[1]);
}

/* What M spans along the normal; the overlap is the smaller way from 0 out of it, and the normal is
 * turned to where that leads. */
static void measure_overlap(normal_search *x)
{
    fmb_least_overlap *n = &x->at;
    fmb_minkowski_dot(x->m, n->normal, row_of(x, 0, 0), x->low);
    fmb_minkowski_dot(x->m, n->normal, row_of(x, 1, 0), x->t);
    mpz_sub(x->low, x->low, x->t);
    mpz_set(x->high, x->low);
    add_span(x, 0, 1);
    add_span(x, 1, -1);
    fmb_minkowski_dot(x->m, n->normal, x->m->drift, x->t);
    mpz_ptr end = mpz_sgn(x->t) < 0 ? x->low : x->high;
    mpz_add(end, end, x->t);
    mpz_neg(x->low, x->low);
    bool back = mpz_cmp(x->low, x->high) < 0;
    mpz_set(n->overlap, back ? x->low : x->high);
    for (int j = 0; back && j < x->m->dim; j++)
        mpz_neg(n->normal[j], n->normal[j]);
}

/* Is what is at hand less than the least? Neither is less than 0, but where that decides. */
static bool is_less(normal_search *x, const fmb_least_overlap *least)
{
    if (!least->found || mpz_sgn(x->at.overlap) < 0)
        return true;
    mpz_set(x->t, x->at.overlap);
    mpz_set(x->s, least->overlap);
    if (x->norm == FMB_NORM_EUCLIDEAN) {
        mpz_mul(x->t, x->t, x->t);
        mpz_mul(x->s, x->s, x->s);
    }
    mpz_mul(x->t, x->t, least->size);
    mpz_mul(x->s, x->s, x->at.size);
    return mpz_cmp(x->t, x->s) < 0;
}

/* At right angles to all directions, which are parallel. */
static void take_any_normal(normal_search *x, fmb_least_overlap *out)
{
    mpz_t *f = x->direction[FMB_FLAT_WORLD];
    for (int i = 0; i <= FMB_FLAT_DRIFT; i++)
        for (int j = 0; j < x->m->dim; j++)
            f = mpz_sgn(x->direction[i][j]) != 0 ? x->direction[i] : f;
    int a = mpz_sgn(f[0]) != 0 ? 0 : 1, b = (a + 1) % x->m->dim;
    mpz_set(out->normal[b], f[a]);
    mpz_neg(out->normal[a], f[b]);
    if (mpz_sgn(out->normal[a]) == 0 && mpz_sgn(out->normal[b]) == 0)
        mpz_set_ui(out->normal[0], 1);
}

static void swap_overlaps(fmb_least_overlap *a, fmb_least_overlap *b)
{
    fmb_least_overlap t = *a;
    *a = *b;
    *b = t;
}

bool fmb_has_normals(const fmb_minkowski *m)
{
    return (m->dim == 2 || m->dim == 3) && m->frame[0].naxes <= m->dim &&
           m->frame[1].naxes <= m->dim;
}

void fmb_find_least_overlap(fmb_minkowski *m, fmb_norm norm, fmb_least_overlap *out)
{
    normal_search x = {.m = m, .norm = norm};
    const int naxes[2] = {m->frame[0].naxes, m->frame[1].naxes};
    const bool simplex[2] = {m->frame[0].shape == FMB_SIMPLEX, m->frame[1].shape == FMB_SIMPLEX};
    for_each_number(&x, start_number);
    fmb_least_overlap_init(&x.at);
    fmb_flat_kind_of(m->dim, m->moves, naxes, simplex, &x.kind);
    read_directions(&x);
    for (int i = 0; i < x.kind.normals && mpz_sgn(out->overlap) >= 0; i++) {
        make_normal(&x, i);
        measure_normal(&x);
        if (mpz_sgn(x.at.size) == 0)
            continue;
        measure_overlap(&x);
        x.at.found = true;
        if (is_less(&x, out))
            swap_overlaps(&x.at, out);
    }
    if (!out->found)
        take_any_normal(&x, out);
    fmb_least_overlap_clear(&x.at);
    for_each_number(&x, end_number);
}
