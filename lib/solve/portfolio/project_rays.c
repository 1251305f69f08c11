/* project_rays.c: the projection of a part by double description; see project_rays.h.
 *
 * The rays of the homogenized cone of the reduced part (reduced_part.h) are computed (dd/cone.h),
 * projected by leaving out coordinates, and converted back into rows (hull/image/image.h). Each
 * facet is a combination of the rows that are tight on all of its preimage: a small linear program
 * finds the multipliers.
 */
#include "solve/portfolio/project_rays.h"

#include <string.h>

#include "dd/cone_rows.h"
#include "elim/store/derive.h"
#include "hull/image/image.h"
#include "lp/linalg/exact/combination.h"
#include "lp/oracle/oracle.h"
#include "solve/portfolio/ray_corners.h"
#include "solve/prepare/irredundant_rows.h"
#include "system/system_private.h"

/* A projection in progress. Row 0 of the cone is t >= 0, row 1 + i is live row i. */
struct fmb_ray_projection {
    fmb_reduced_part *of;
    fmb_system *out;
    size_t d, *column;   /* [d - 1] columns of the part that live rows name; then comes t */
    size_t keeps, *keep; /* [d] kept coordinates of the cone, t last; then the others */
    fmb_cone_rows rows;
    fmb_cone cone;
    fmb_image image;
    fmb_dual dual;       /* computes facets of the image as rays of the dual cone, */
    fmb_image_hull hull; /* or by inserting rays one by one */
    fmb_vec facet;       /* scratch: a row of the part */
    fmb_lp_row *row;     /* for proofs: live rows, behind them the facet; NULL: not yet */
    fmb_combination sum; /* of these rows */
    bool lifted;         /* the cone was made */
    bool pictured;       /* its image was made */
    bool over;           /* too many faces are excluded */
};

/* ---- the cone -------------------------------------------------------------------------------- */

static bool is_column_nonzero(const fmb_elim *e, int j)
{
    for (size_t i = 0; i < e->live.size; i++)
        if (fmb_vec_sgn(&e->row[e->live.row[i]].v, (size_t)j) != 0)
            return true;
    return false;
}

static bool is_column_kept(const fmb_ray_projection *h, size_t k)
{
    return h->of->place[h->of->p->var[h->column[k]]] >= 0;
}

static fmb_status list_coordinates(fmb_ray_projection *h)
{
    fmb_arena *arena = &h->of->q->v->arena;
    size_t n = (size_t)h->of->p->n + 1;
    FMB_TRY(FMB_ARENA_GET(arena, h->column, n));
    FMB_TRY(FMB_ARENA_GET(arena, h->keep, n));
    for (int j = 0; j < h->of->p->n; j++)
        if (is_column_nonzero(&h->of->e, j))
            h->column[h->d++] = (size_t)j;
    for (size_t k = 0; k < h->d; k++)
        if (is_column_kept(h, k))
            h->keep[h->keeps++] = k;
    h->keep[h->keeps++] = h->d;
    for (size_t k = 0, at = h->keeps; k < h->d; k++)
        if (!is_column_kept(h, k))
            h->keep[at++] = k;
    h->d++;
    return FMB_OK;
}

/* Write a.x <= b as b t - a.x >= 0. */
static void write_live_row(const void *of, size_t i, mpz_t *z, fmb_cone_row *row)
{
    const fmb_ray_projection *h = of;
    const fmb_derived *r = i > 0 ? &h->of->e.row[h->of->e.live.row[i - 1]] : NULL;
    for (size_t k = 0; k + 1 < h->d; k++) {
        mpz_set_ui(z[k], 0);
        if (r)
            fmb_vec_get(&r->v, h->column[k], z[k]);
        mpz_neg(z[k], z[k]);
    }
    mpz_set_ui(z[h->d - 1], 1);
    if (r)
        fmb_vec_get(&r->v, (size_t)h->of->p->n, z[h->d - 1]);
    row->equality = r && r->equality;
    row->wanted = r && r->strict;
}

static fmb_status open_cone_of_part(fmb_ray_projection *h)
{
    fmb_status st = list_coordinates(h);
    FMB_THEN(st, fmb_cone_rows_write(&h->rows, &h->of->q->v->arena, &h->of->q->run, h->d,
                                     h->of->e.live.size + 1, write_live_row, h));
    fmb_cone_problem of = {.d = h->d,
                           .m = h->rows.size,
                           .row = h->rows.row,
                           .keeps = fmb_query_proves_complete(h->of->q) ? h->d : h->keeps,
                           .keep = h->keep,
                           .wide_only = fmb_query_is_wide(h->of->q)};
    h->lifted = true;
    return st == FMB_OK ? fmb_cone_init(&h->cone, &h->of->q->run, &of) : st;
}

/* ---- proofs ---------------------------------------------------------------------------------- */

/* List the rows that are tight on all of the facet's preimage, by their places among live rows:
 * those whose bits are not in its slack, and equalities. */
static size_t list_tight_rows(const fmb_ray_projection *h, const fmb_image_row *f, size_t *place)
{
    size_t n = 0;
    for (size_t i = 1; i < h->rows.size; i++)
        if (h->rows.row[i].equality)
            place[n++] = i - 1;
    for (size_t b = 0; b < h->cone.bits; b++)
        if (!fmb_set_has(f->slack, b) && h->cone.row_of_bit[b] > 0)
            place[n++] = h->cone.row_of_bit[b] - 1;
    return n;
}

/* Find multipliers of the oracle's rows that combine to the facet, or to its reverse. */
static fmb_status maximize_facet(fmb_ray_projection *h, fmb_oracle *o, int sign, fmb_weights *w)
{
    fmb_weights form = {0};
    fmb_oracle_end end;
    bool attained;
    fmb_status st = FMB_OK;
    mpq_t a;
    mpq_init(a);
    for (size_t j = 0; st == FMB_OK && j < (size_t)h->of->p->n; j++) {
        fmb_vec_get_q(&h->facet, j, a);
        if (sign < 0)
            mpq_neg(a, a);
        if (mpq_sgn(a) != 0)
            st = fmb_weights_add(&form, (uint32_t)j, a, h->of->q->run.mem);
    }
    mpq_clear(a);
    FMB_THEN(st, fmb_oracle_maximize(o, &form, &end, &attained));
    FMB_THEN(st, fmb_oracle_multipliers(o, w));
    fmb_weights_clear(&form, h->of->q->run.mem);
    return st;
}

/* w[0] proves the facet, and if it is an equality w[1] its reverse; by number of the tight row. */
static fmb_status combine_dependent_rows(fmb_ray_projection *h, const fmb_image_row *f,
                                         const size_t *place, size_t size, fmb_weights *w)
{
    fmb_program tight;
    fmb_oracle *o = NULL;
    fmb_status st = FMB_OK;
    fmb_program_init(&tight, h->of->q->run.mem, h->of->p->n);
    for (size_t i = 0; st == FMB_OK && i < size; i++)
        st = fmb_program_add_dense(&tight, h->row[place[i]].v, h->row[place[i]].rel);
    FMB_THEN(st, fmb_oracle_new(&h->of->q->run, &tight, &o));
    FMB_THEN(st, maximize_facet(h, o, 1, &w[0]));
    if (st == FMB_OK && f->equality)
        st = maximize_facet(h, o, -1, &w[1]);
    fmb_oracle_free(o);
    fmb_program_clear(&tight);
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < w[k].size; i++)
            w[k].index[i] = (uint32_t)place[w[k].index[i]];
    return st;
}

/* If the tight rows are linearly independent, exactly one combination of them is the facet. */
static fmb_status combine_independent_rows(fmb_ray_projection *h, const fmb_image_row *f,
                                           const size_t *place, size_t size, fmb_weights *w,
                                           bool *found)
{
    fmb_combination *c = &h->sum;
    size_t facet = h->of->e.live.size;
    *found = false;
    if (f->equality || size > c->n)
        return FMB_OK;
    h->row[facet] = (fmb_lp_row){&h->facet, f->strict ? FMB_LT : FMB_LE};
    fmb_status st = fmb_combine(c, &h->of->q->run, facet, place, size, found);
    *found = st == FMB_OK && *found && fmb_combination_proves(c);
    mpq_t part;
    mpq_init(part);
    for (size_t k = 0; st == FMB_OK && *found && k < c->size; k++) {
        mpq_set_num(part, c->part[k]);
        mpq_set_den(part, c->all);
        mpq_canonicalize(part);
        st = fmb_weights_add(w, (uint32_t)c->index[k], part, h->of->q->run.mem);
    }
    mpq_clear(part);
    return st;
}

static fmb_status open_proofs(fmb_ray_projection *h)
{
    const fmb_elim *e = &h->of->e;
    FMB_TRY(FMB_ARENA_GET(&h->of->q->v->arena, h->row, e->live.size + 1));
    for (size_t i = 0; i < e->live.size; i++) {
        const fmb_derived *r = &e->row[e->live.row[i]];
        h->row[i] = (fmb_lp_row){&r->v, fmb_derived_rel(r)};
    }
    return fmb_combination_init(&h->sum, h->of->q->run.mem, (size_t)h->of->p->n, h->row);
}

/* w[0] proves the facet, and if it is an equality w[1] its reverse. */
static fmb_status prove_facet(fmb_ray_projection *h, const fmb_image_row *f, size_t *place,
                              fmb_weights *w)
{
    const fmb_elim *e = &h->of->e;
    bool found = false;
    size_t size = list_tight_rows(h, f, place);
    fmb_status st = h->row ? FMB_OK : open_proofs(h);
    FMB_THEN(st, combine_independent_rows(h, f, place, size, &w[0], &found));
    if (st == FMB_OK && !found)
        st = combine_dependent_rows(h, f, place, size, w);
    for (size_t k = 0; st == FMB_OK && k < 1 + (size_t)f->equality; k++) {
        for (size_t i = 0; i < w[k].size; i++)
            w[k].index[i] = e->live.row[w[k].index[i]];
        st = fmb_elim_derive(e, &w[k]);
    }
    return st;
}

static fmb_status claim_facet(fmb_ray_projection *h, const fmb_image_row *f, fmb_rel rel)
{
    fmb_mem *mem = h->of->q->run.mem;
    fmb_weights w[2] = {{0}, {0}};
    size_t *place = fmb_mem_get(mem, h->rows.size, sizeof *place);
    fmb_status st = place ? prove_facet(h, f, place, w) : fmb_mem_status(mem);
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    FMB_THEN(st, fmb_query_claim_implied(h->of->q, h->of->p, &h->facet, one, rel, &w[0],
                                         f->equality ? &w[1] : NULL));
    mpq_clear(one);
    fmb_weights_clear(&w[0], mem);
    fmb_weights_clear(&w[1], mem);
    fmb_mem_put(mem, place, h->rows.size, sizeof *place);
    return st;
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* Write the facet as a row over the part's columns; z[n + 1] is zero before and after. */
static fmb_status write_facet_row(fmb_ray_projection *h, const fmb_image_row *f, mpz_t *z)
{
    size_t n = (size_t)h->of->p->n;
    for (size_t k = 0; k + 1 < h->keeps; k++)
        fmb_vec_get(&f->v, k, z[h->column[h->keep[k]]]);
    fmb_vec_get(&f->v, h->keeps - 1, z[n]);
    fmb_status st = fmb_vec_set_z(&h->facet, n + 1, z, h->of->q->run.mem);
    for (size_t k = 0; k + 1 < h->keeps; k++)
        mpz_set_ui(z[h->column[h->keep[k]]], 0);
    return st;
}

static fmb_status put_facet(fmb_ray_projection *h, const fmb_image_row *f, mpz_t *z)
{
    fmb_rel rel = f->equality ? FMB_EQ : f->strict ? FMB_LT : FMB_LE;
    fmb_status st = write_facet_row(h, f, z);
    if (st == FMB_OK && h->of->q->claims)
        st = claim_facet(h, f, rel);
    FMB_THEN(st, fmb_system_append_dense(h->out, (size_t)h->of->p->n, h->of->p->var, h->of->place,
                                         &h->facet, rel));
    return st;
}

static fmb_status put_all_facets(fmb_ray_projection *h)
{
    fmb_mem *mem = h->of->q->run.mem;
    size_t n = (size_t)h->of->p->n + 1;
    mpz_t *z = fmb_vec_block(n, mem);
    h->facet.s = fmb_arena_get(&h->of->q->v->arena, n, sizeof *h->facet.s);
    fmb_status st = z && h->facet.s ? FMB_OK : fmb_mem_status(mem);
    for (size_t k = 0; st == FMB_OK && k < h->image.facets; k++)
        st = put_facet(h, &h->image.facet[k], z);
    fmb_vec_block_free(z, n, mem);
    fmb_vec_clear(&h->facet, n, mem);
    return st;
}

/* ---- the whole way --------------------------------------------------------------------------- */

static bool has_strict_row(const fmb_ray_projection *h)
{
    for (size_t i = 0; i < h->rows.size; i++)
        if (h->rows.row[i].wanted)
            return true;
    return false;
}

static fmb_status exclude_faces(fmb_ray_projection *h, bool *feasible, bool *done)
{
    size_t words = h->image.words;
    bool empty;
    uint64_t *excludes;
    FMB_TRY(FMB_ARENA_GET(&h->of->q->v->arena, excludes, words));
    memset(excludes, 0, words * sizeof *excludes);
    for (size_t b = 0; b < h->cone.bits; b++)
        if (h->rows.row[h->cone.row_of_bit[b]].wanted)
            fmb_set_put(excludes, b);
    fmb_status st = fmb_image_open_faces(&h->image, excludes, &empty, done);
    *feasible = st != FMB_OK || !empty;
    return st;
}

/* *done false: the slice is used up. */
static fmb_status find_facets_of_image(fmb_ray_projection *h, bool slacks, bool *done)
{
    if (fmb_image_has_few_coordinates(&h->image)) {
        fmb_status st = h->hull.of ? FMB_OK : fmb_image_hull_open(&h->hull, &h->image);
        return st == FMB_OK ? fmb_image_hull_find_facets(&h->hull, slacks, done) : st;
    }
    fmb_status st = h->dual.of ? FMB_OK : fmb_dual_open(&h->dual, &h->image, false);
    return st == FMB_OK ? fmb_dual_find_facets(&h->dual, 0, slacks, done) : st;
}

static fmb_status project_rays(fmb_ray_projection *h, bool *feasible, bool *done)
{
    bool strict = has_strict_row(h);
    fmb_status st = FMB_OK;
    if (!h->pictured)
        st = fmb_image_init(&h->image, &h->of->q->run, &h->cone, h->keeps,
                            fmb_query_is_wide(h->of->q));
    h->pictured = true;
    *feasible = h->image.has_point;
    if (st == FMB_OK && *feasible)
        st = find_facets_of_image(h, strict || h->of->q->claims, done);
    if (st != FMB_OK || !*feasible || !*done)
        return st;
    if (strict)
        st = exclude_faces(h, feasible, done);
    h->over = !*done;
    return st;
}

fmb_status fmb_ray_projection_open(fmb_reduced_part *of, fmb_ray_projection **out)
{
    fmb_ray_projection *h;
    FMB_TRY(FMB_ARENA_GET(&of->q->v->arena, h, 1));
    *h = (fmb_ray_projection){.of = of};
    *out = h;
    return FMB_OK;
}

void fmb_ray_projection_close(fmb_ray_projection *h)
{
    if (!h)
        return;
    fmb_cone_rows_clear(&h->rows, h->of->q->run.mem);
    fmb_dual_close(&h->dual);
    fmb_image_hull_close(&h->hull);
    fmb_image_clear(&h->image);
    fmb_combination_clear(&h->sum);
    fmb_cone_clear(&h->cone);
}

fmb_status fmb_ray_projection_run(fmb_ray_projection *h, bool *feasible, bool *ready)
{
    *feasible = true;
    *ready = !h->of->rest;
    if (*ready || h->over)
        return FMB_OK;
    fmb_status st = h->lifted ? FMB_OK : open_cone_of_part(h);
    FMB_THEN(st, fmb_cone_run(&h->cone, 0, ready));
    *ready &= h->pictured || !fmb_run_is_slice_over(&h->of->q->run);
    return st == FMB_OK && *ready ? project_rays(h, feasible, ready) : st;
}

fmb_status fmb_ray_projection_put(fmb_ray_projection *h, fmb_system *out, bool *feasible)
{
    h->out = out;
    if (!h->of->rest)
        return fmb_irredundant_rows_append(h->of->q, h->of->p, h->of->place, &h->of->e,
                                           h->of->q->decided, out, feasible);
    fmb_ray_corners corners = {h->of, &h->image, h->d, h->keeps, h->column, h->keep};
    FMB_TRY(put_all_facets(h));
    return fmb_ray_corners_hand_over(&corners);
}

bool fmb_ray_projection_has_given_up(const fmb_ray_projection *h)
{
    return h->over;
}
