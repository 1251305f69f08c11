/* project_support.c: rows of a projection from support queries (hull/support/support.h); see
 * project_support.h. */
#include "solve/portfolio/project_support.h"

#include <stdlib.h>

#include "hull/support/support.h"
#include "solve/portfolio/symmetries.h"
#include "system/system_private.h"

struct fmb_queries {
    fmb_query *q;
    const fmb_part *p;
    int part;
    const int *place;
    int *column; /* [n], k in use: the kept columns of the part */
    size_t k;
    fmb_run *run; /* the query's, or that of the share */
    fmb_share share;
    fmb_oracle *oracle; /* of the share */
    fmb_support s;
    mpz_t *z;    /* [n + 1] scratch: a row of the part */
    fmb_vec row; /* scratch: a row of the part */
    bool begun;  /* s is initialized */
    bool open;   /* s can go on: it was initialized without an error, and its hull is there */
};

/* ---- rows ------------------------------------------------------------------------------------ */

static fmb_status claim_support_row(fmb_queries *h, fmb_support_row *r)
{
    mpq_t one;
    if (!h->q->claims)
        return FMB_OK;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fmb_status st = fmb_query_take_oracle_weights(h->q, h->p, &r->proof);
    FMB_THEN(st, fmb_query_take_oracle_weights(h->q, h->p, &r->reverse));
    FMB_THEN(st, fmb_query_claim_implied(h->q, h->p, &h->row, one, r->rel, &r->proof, &r->reverse));
    mpq_clear(one);
    return st;
}

static fmb_status put_support_row(fmb_queries *h, fmb_support_row *r, fmb_system *out)
{
    size_t n = (size_t)h->p->n;
    for (size_t j = 0; j < h->k; j++)
        mpz_set(h->z[h->column[j]], r->z.z[j]);
    mpz_set(h->z[n], r->z.z[h->k]);
    fmb_status st = fmb_vec_set_z(&h->row, n + 1, h->z, h->q->run.mem);
    FMB_THEN(st, claim_support_row(h, r));
    FMB_THEN(st, fmb_system_append_dense(out, n, h->p->var, h->place, &h->row, r->rel));
    return st;
}

static int compare_support_rows(const void *a, const void *b)
{
    const fmb_integers *x = &((const fmb_support_row *)a)->z, *y = &((const fmb_support_row *)b)->z;
    int sign = 0;
    for (size_t j = 0; sign == 0 && j < x->size; j++)
        sign = mpz_cmp(x->z[j], y->z[j]);
    return sign;
}

/* Append all rows, in an order that does not depend on when they were found. */
static fmb_status put_all_support_rows(fmb_queries *h, fmb_system *out)
{
    size_t n = (size_t)h->p->n + 1;
    fmb_mem *mem = h->q->run.mem;
    h->z = fmb_vec_block(n, mem);
    h->row.s = fmb_mem_get(mem, n, sizeof *h->row.s);
    fmb_status st = h->z && h->row.s ? FMB_OK : fmb_mem_status(mem);
    if (h->s.rows > 1)
        qsort(h->s.row, h->s.rows, sizeof *h->s.row, compare_support_rows);
    for (size_t i = 0; st == FMB_OK && i < h->s.rows; i++)
        st = put_support_row(h, &h->s.row[i], out);
    fmb_vec_block_free(h->z, n, mem);
    fmb_vec_clear(&h->row, n, mem);
    fmb_mem_put(mem, h->row.s, n, sizeof *h->row.s);
    return st;
}

/* ---- inner points ---------------------------------------------------------------------------- */

/* Write a point as x[n]; a direction as the first point plus that direction. */
static void write_inner_point(const fmb_queries *h, const fmb_integers *point, mpq_t *x)
{
    const fmb_integers *first = &h->s.point[0];
    int n = h->p->n;
    bool direction = mpz_sgn(point->z[n]) == 0;
    for (int j = 0; j < n; j++) {
        mpz_set(mpq_numref(x[j]), point->z[j]);
        if (direction) {
            mpz_mul(mpq_numref(x[j]), mpq_numref(x[j]), first->z[n]);
            mpz_add(mpq_numref(x[j]), mpq_numref(x[j]), first->z[j]);
        }
        mpz_set(mpq_denref(x[j]), direction ? first->z[n] : point->z[n]);
        mpq_canonicalize(x[j]);
    }
}

/* Claim that there is a solution at that point. */
static fmb_status claim_inner_point(fmb_queries *h, const fmb_integers *point)
{
    fmb_query *q = h->q;
    fmb_claim *claim;
    fmb_status st = fmb_evidence_claim(q->claims, FMB_CLAIM_FEASIBLE, &claim);
    if (st != FMB_OK)
        return st;
    write_inner_point(h, point, q->x);
    for (int j = 0; st == FMB_OK && j < fmb_system_dim(q->s); j++) {
        mpq_srcptr value = q->parts.of_var[j] == h->part ? q->x[q->parts.place[j]] : q->point[j];
        st = fmb_evidence_push(q->claims, &claim->point, (size_t)j, value);
    }
    return fmb_query_finish_claim(q, st);
}

/* With strict rows, points of the closure need not be solutions. */
static bool has_inner_points(const fmb_queries *h)
{
    return h->s.points > 0 && !h->s.strict;
}

/* Claim all points; where memory runs out, only some of them. */
static fmb_status claim_inner_points(fmb_queries *h)
{
    fmb_status st = FMB_OK;
    bool any = h->q->claims && has_inner_points(h);
    for (size_t i = 0; st == FMB_OK && any && i < h->s.points; i++)
        st = claim_inner_point(h, &h->s.point[i]);
    return st == FMB_LIMIT ? FMB_OK : st;
}

/* ---- a part ---------------------------------------------------------------------------------- */

static fmb_status list_kept_columns(fmb_queries *h)
{
    FMB_TRY(FMB_GET(h->q->run.mem, h->column, (size_t)h->p->n));
    for (int j = 0; j < h->p->n; j++)
        if (h->place[h->p->var[j]] >= 0)
            h->column[h->k++] = j;
    return FMB_OK;
}

/* Use the symmetries that the caller gave. */
static fmb_status use_symmetries(fmb_queries *h)
{
    fmb_query *q = h->q;
    fmb_group group = {0};
    if (q->session || q->v->options.symmetry != FMB_SYMMETRY_AUTO || !q->v->moved)
        return FMB_OK;
    fmb_status st = fmb_symmetries_of_part(q, h->part, h->column, h->k, &group);
    if (st == FMB_OK && group.size > 0)
        st = fmb_support_use_symmetry(&h->s, &group);
    fmb_group_clear(&group);
    return st;
}

/* Under a limit, the number of rows kept per coordinate that are no facets: after those the hull is
 * a good approximation, and only facets are kept. */
#define OUTER_ROWS 16
/* Most projections take fewer queries. */
#define FEW_QUERIES 64

/* The share has no memory limit of its own: its memory counts as that of the query. */
static fmb_status open_share(fmb_queries *h, fmb_oracle **o)
{
    fmb_query *q = h->q;
    fmb_share_begin(&h->share, &q->run, 1);
    h->share.mem.limit = 0;
    fmb_mem_enter(&h->share.mem, q->run.mem);
    h->run = &h->share.run;
    FMB_TRY(fmb_oracle_new(h->run, &q->program[h->part], &h->oracle));
    *o = h->oracle;
    return FMB_OK;
}

static void close_share(fmb_queries *h)
{
    size_t peak = 0;
    if (h->run == &h->q->run)
        return;
    fmb_oracle_free(h->oracle);
    fmb_mem_leave(&h->share.mem);
    h->share.run.stop = h->q->run.stop; /* its own stop was reported before */
    fmb_share_end(&h->share, &h->q->run, &peak);
}

fmb_share *fmb_queries_share(fmb_queries *h)
{
    return h->run == &h->q->run ? NULL : &h->share;
}

fmb_status fmb_queries_open(fmb_query *q, int part, const int *place, bool apart, fmb_queries **out,
                            bool *feasible)
{
    fmb_oracle *o;
    fmb_queries *h = fmb_mem_zero(q->run.mem, 1, sizeof *h);
    *out = h;
    *feasible = true;
    if (!h)
        return fmb_mem_status(q->run.mem);
    *h = (fmb_queries){.q = q, .p = &q->parts.part[part], .part = part, .place = place};
    h->run = &q->run;
    fmb_status st = list_kept_columns(h);
    FMB_THEN(st, fmb_query_oracle(q, part, &o));
    if (st == FMB_OK && apart)
        st = open_share(h, &o);
    if (st == FMB_OK && !fmb_oracle_has_solution(o))
        st = fmb_oracle_feasible(o, feasible);
    if (st != FMB_OK || !*feasible)
        return st;
    h->begun = true;
    st = fmb_support_init(&h->s, h->run, o, (size_t)h->p->n, h->column, h->k,
                          q->program[part].any_strict, q->claims != NULL);
    FMB_THEN(st, use_symmetries(h));
    if (fmb_run_is_limited(&q->run))
        fmb_support_want_outer_rows(&h->s, FEW_QUERIES, OUTER_ROWS * h->k);
    h->open = st == FMB_OK;
    return st;
}

void fmb_queries_close(fmb_queries *h)
{
    if (!h)
        return;
    fmb_mem *mem = h->q->run.mem;
    if (h->begun)
        fmb_support_clear(&h->s);
    close_share(h);
    fmb_mem_put(mem, h->column, (size_t)h->p->n, sizeof *h->column);
    fmb_mem_put(mem, h, 1, sizeof *h);
}

/* Append the rows proved so far, and claim the points found: an inner approximation. */
static fmb_status put_proved_rows_and_points(fmb_queries *h, fmb_system *out)
{
    if (!h->begun)
        return FMB_OK;
    fmb_facets_clear(&h->s.hull); /* makes room for the rows */
    fmb_status st = fmb_support_keep_images(&h->s);
    FMB_THEN(st, fmb_support_keep_outer_rows(&h->s));
    if (st == FMB_OK || st == FMB_LIMIT)
        st = put_all_support_rows(h, out);
    h->q->put_out = true;
    return st == FMB_OK ? claim_inner_points(h) : st;
}

/* ---- corners --------------------------------------------------------------------------------- */

/* Move *from to *x, in memory of the query. */
static fmb_status take_over_integers(fmb_queries *h, fmb_integers *from, fmb_integers *x)
{
    FMB_TRY(fmb_integers_init(x, from->size, h->q->run.mem));
    for (size_t j = 0; j < x->size; j++)
        mpz_swap(x->z[j], from->z[j]);
    return fmb_integers_settle(x, h->q->run.mem);
}

/* Hand over h->s.g, whose last entry is t, with its preimage `above`, or NULL. */
static fmb_status hand_over_point(fmb_queries *h, fmb_integers *above, fmb_vec *y)
{
    fmb_integers x = {0};
    fmb_status st = fmb_vec_set_z(y, h->k + 1, h->s.g.z, h->q->run.mem);
    if (st == FMB_OK && above)
        st = take_over_integers(h, above, &x);
    if (st != FMB_OK)
        fmb_integers_clear(&x, h->q->run.mem);
    return st == FMB_OK ? fmb_met_points_add(&h->q->met, y, above ? &x : NULL, &h->s.hull.num) : st;
}

/* Hand over all points found; if some of them have images by symmetries, all generators of the
 * hull. */
static fmb_status hand_over_all_points(fmb_queries *h, fmb_vec *y)
{
    const fmb_facets *hull = &h->s.hull;
    mpz_t *z = h->s.g.z;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < h->s.points; i++) {
        for (size_t j = 0; j <= h->k; j++)
            mpz_set(z[j], h->s.point[i].z[j < h->k ? h->column[j] : h->p->n]);
        st = hand_over_point(h, &h->s.point[i], y);
    }
    bool images = hull->generators > h->s.points;
    for (size_t i = 0; st == FMB_OK && images && i < hull->generators; i++) {
        for (size_t j = 0; j <= h->k; j++)
            fmb_vec_get(&hull->generator[i], j < h->k ? j + 1 : 0, z[j]);
        st = hand_over_point(h, NULL, y);
    }
    return st;
}

/* The hull is the projection: hand its points over, unless there is no memory for them. */
static fmb_status hand_over_hull(fmb_queries *h)
{
    fmb_query *q = h->q;
    if (!fmb_query_proves_complete(q))
        return FMB_OK;
    fmb_vec y = {.s = fmb_mem_get(q->run.mem, h->k + 1, sizeof *y.s)};
    fmb_met_points_begin(&q->met, q->run.mem, h->part, h->k);
    fmb_status st = y.s ? hand_over_all_points(h, &y) : fmb_mem_status(q->run.mem);
    fmb_vec_clear(&y, h->k + 1, q->run.mem);
    fmb_mem_put(q->run.mem, y.s, h->k + 1, sizeof *y.s);
    if (st == FMB_LIMIT)
        fmb_met_points_clear(&q->met);
    return st == FMB_LIMIT && q->run.stop == FMB_STOP_DONE ? FMB_OK : st;
}

fmb_status fmb_queries_run(fmb_queries *h, bool *ready)
{
    *ready = h->k == 0;
    return *ready ? FMB_OK : fmb_support_ask(&h->s, 0, ready);
}

fmb_status fmb_queries_put(fmb_queries *h, fmb_system *out, fmb_status st)
{
    fmb_status put = st == FMB_OK ? hand_over_hull(h) : FMB_OK;
    if (put != FMB_OK)
        return put;
    fmb_facets_clear(&h->s.hull);
    h->open = false;
    put = st == FMB_LIMIT ? put_proved_rows_and_points(h, out) : put_all_support_rows(h, out);
    return put == FMB_OK ? st : put;
}

/* ---- behind a limit -------------------------------------------------------------------------- */

/* Pairs of facets without a clock: dozens of queries take so many. The last query may take as many
 * again, but not all that the images of one point under symmetries could. */
#define PAIRS_AT_LIMIT ((uint64_t)1 << 12)

/* Continue querying, then keep what is proved. The query's limit was lifted before. */
static fmb_status ask_on_and_keep(fmb_queries *h, fmb_system *out)
{
    bool done;
    uint64_t pairs = h->q->run.deadline > 0 ? 0 : PAIRS_AT_LIMIT;
    h->s.hull.most_pairs = pairs > 0 ? h->s.hull.pairs + 2 * pairs : 0;
    fmb_support_want_outer_rows(&h->s, 0, SIZE_MAX);
    fmb_status st = h->k > 0 ? fmb_support_ask(&h->s, pairs, &done) : FMB_OK;
    return st == FMB_OK || st == FMB_LIMIT ? put_proved_rows_and_points(h, out) : st;
}

/* May the query continue after its limit? Then *why is its stop, to be restored afterwards. */
static bool go_on_behind_limit(fmb_query *q, fmb_stop *why)
{
    *why = q->run.stop;
    return fmb_run_go_on(&q->run);
}

static void end_as_before(fmb_query *q, fmb_stop why)
{
    q->run.stop = q->run.stop == FMB_STOP_CANCELLED ? FMB_STOP_CANCELLED : why;
}

fmb_status fmb_queries_finish(fmb_queries *h, fmb_system *out)
{
    fmb_stop why;
    if (!h->open)
        return FMB_OK;
    if (h->s.ended || !go_on_behind_limit(h->q, &why))
        return put_proved_rows_and_points(h, out);
    h->run->stop = h->q->run.stop;
    h->run->deadline = h->q->run.deadline;
    fmb_status st = ask_on_and_keep(h, out);
    end_as_before(h->q, why);
    return st == FMB_LIMIT ? FMB_OK : st;
}

fmb_status fmb_queries_at_limit(fmb_query *q, int part, const int *place, fmb_system *out)
{
    bool feasible;
    fmb_queries *h;
    fmb_stop why;
    if (!go_on_behind_limit(q, &why))
        return FMB_OK;
    fmb_status st = fmb_queries_open(q, part, place, false, &h, &feasible);
    if (st == FMB_OK && feasible)
        st = ask_on_and_keep(h, out);
    fmb_queries_close(h);
    fmb_query_close_oracle(q, part);
    end_as_before(q, why);
    return st == FMB_LIMIT ? FMB_OK : st;
}

fmb_status fmb_query_support_part(fmb_query *q, int part, const int *place, fmb_system *out,
                                  bool *feasible)
{
    bool ready;
    fmb_queries *h;
    fmb_status st = fmb_queries_open(q, part, place, false, &h, feasible);
    if (st == FMB_OK && *feasible) {
        st = fmb_queries_run(h, &ready);
        if (st == FMB_OK || st == FMB_LIMIT)
            st = fmb_queries_put(h, out, st);
    }
    fmb_queries_close(h);
    return st;
}
