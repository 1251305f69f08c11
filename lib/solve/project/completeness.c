/* completeness.c: corners of a projection, and the claim that they span it (proof/complete.h).
 *
 * The corners are the vertices, rays and lines of the rows found, by double description in the kept
 * variables alone; the oracle finds a preimage of each. So they are independent of the engine that
 * found the rows. Where strict rows exclude faces, a strict preimage of an inner point of each face
 * that is not excluded is added, as far as the checker requires it. The checker decides in the end:
 * what it would not accept is not claimed.
 */
#include "solve/project/completeness.h"

#include "num/rationals.h"
#include "proof/complete.h"
#include "solve/project/met_corners.h"
#include "solve/project/order_complete.h"
#include "solve/project/preimages.h"
#include "solve/query/lifted.h"

/* The work of the projection, estimated in operations as proof/elimination.h counts them: a proof
 * may cost a few times that, and at least some milliseconds. */
#define WORK_OF_ANY     ((uint64_t)1 << 24)
#define WORK_OF_ROW     256 /* per row and variable */
#define WORK_OF_PAIR    16
#define WORK_OF_PROGRAM ((uint64_t)1 << 14)
/* The first attempt may take 1 / FIRST_SHARE of that; each further one so many times as much. */
#define FIRST_SHARE 64
#define NEXT_SHARE  8
/* The work of an intermediate ray in the search for corners. */
#define WORK_OF_RAY 1024
/* The proof is given up if more faces need an inner point. */
#define MOST_MIDDLES 2000

typedef struct completeness_proof {
    fmb_query *q;
    const int *place;
    const fmb_system *image;
    size_t first;             /* claim of this proof */
    fmb_preimages *preimages; /* NULL: not opened yet */
    fmb_integers y;           /* a point or direction of the image, with t last */
    mpq_t *x;                 /* [dim] its preimage */
    bool any_strict, done;
    const char *why; /* the proof failed */
    uint64_t work;   /* the most that it may cost */
    fmb_lifted lifted;
    bool cornered, claimed; /* corners are known; they were tried */
    bool tight;             /* some row holds with equality at y */
} completeness_proof;

/* ---- corners --------------------------------------------------------------------------------- */

/* Claim the solution w->x, a preimage of w->y. */
static fmb_status claim_corner_at(completeness_proof *w)
{
    fmb_claim *claim;
    bool point = mpz_sgn(w->y.z[w->y.size - 1]) > 0;
    FMB_TRY(fmb_evidence_claim(w->q->claims, FMB_CLAIM_CORNER, &claim));
    fmb_status st = fmb_evidence_push_all(w->q->claims, point ? &claim->point : &claim->ray,
                                          (size_t)fmb_system_dim(w->q->s), NULL, w->x);
    return fmb_query_finish_claim(w->q, st);
}

/* Find and claim a preimage of w->y; strict rows hold strictly if `strict`, else as <=. */
static fmb_status claim_corner_above(completeness_proof *w, bool strict, bool *found)
{
    FMB_TRY(w->preimages ? FMB_OK : fmb_preimages_open(w->q, w->place, &w->preimages));
    FMB_TRY(fmb_preimages_find(w->preimages, &w->y, strict, w->tight, w->x, found));
    return *found ? claim_corner_at(w) : FMB_OK;
}

/* Claim x, a known preimage of w->y; variables of other parts are as in some solution, or 0. */
static fmb_status claim_met_corner(completeness_proof *w, const fmb_integers *x)
{
    const fmb_query *q = w->q;
    const fmb_part *p = &q->parts.part[q->met.part];
    mpz_srcptr t = x->z[p->n];
    for (int j = 0; j < fmb_system_dim(q->s); j++) {
        if (q->parts.of_var[j] != q->met.part) {
            mpq_set_ui(w->x[j], 0, 1);
            if (mpz_sgn(t) > 0)
                mpq_set(w->x[j], q->point[j]);
            continue;
        }
        mpz_set(mpq_numref(w->x[j]), x->z[q->parts.place[j]]);
        mpz_set_ui(mpq_denref(w->x[j]), 1);
        if (mpz_sgn(t) > 0)
            mpz_set(mpq_denref(w->x[j]), t);
        mpq_canonicalize(w->x[j]);
    }
    return claim_corner_at(w);
}

/* The sign of the slack of row r of the image at w->y. */
static int sign_at_corner(completeness_proof *w, const fmb_sysrow *r)
{
    mpz_t sum, a;
    mpz_inits(sum, a, NULL);
    fmb_vec_get(&r->val, r->nnz, sum);
    mpz_mul(sum, sum, w->y.z[w->y.size - 1]);
    for (size_t k = 0; k < r->nnz; k++) {
        fmb_vec_get(&r->val, k, a);
        mpz_submul(sum, a, w->y.z[r->var[k]]);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, a, NULL);
    return sign;
}

/* Is w->y in the image, strict rows included? Only then it has a strict preimage. */
static bool is_in_image(completeness_proof *w)
{
    bool inside = mpz_sgn(w->y.z[w->y.size - 1]) > 0;
    for (size_t i = 0; inside && i < w->image->rows; i++)
        if (w->image->row[i].rel == FMB_LT)
            inside = sign_at_corner(w, &w->image->row[i]) > 0;
    return inside;
}

/* Claim a ray with a preimage; a point with a strict one, if there is one. */
static fmb_status claim_corner(completeness_proof *w, const fmb_vec *ray, int sign, bool *found)
{
    *found = false;
    for (size_t k = 0; k < w->y.size; k++) {
        fmb_vec_get(ray, k, w->y.z[k]);
        if (sign < 0)
            mpz_neg(w->y.z[k], w->y.z[k]);
    }
    if (w->any_strict && is_in_image(w))
        FMB_TRY(claim_corner_above(w, true, found));
    if (*found)
        return FMB_OK;
    const fmb_met_point *met = sign > 0 ? fmb_met_points_find(&w->q->met, ray) : NULL;
    *found = met != NULL;
    return met ? claim_met_corner(w, &met->x) : claim_corner_above(w, false, found);
}

/* *found false: some corner has no preimage, so the rows are incomplete. */
static fmb_status claim_all_corners(completeness_proof *w, const fmb_image *m, bool *found)
{
    fmb_status st = FMB_OK;
    *found = true;
    w->why = "above some corner no solution was found";
    w->tight = true;
    for (size_t i = 0; st == FMB_OK && *found && i < m->rays; i++)
        st = claim_corner(w, &m->ray[i], 1, found);
    w->tight = false;
    for (size_t i = 0; st == FMB_OK && *found && i < 2 * m->lines; i++)
        st = claim_corner(w, &m->line[i / 2], i % 2 ? -1 : 1, found);
    return st;
}

/* Take the corners from the points that the engine met, if these are all corners. */
static fmb_status find_met_corners(completeness_proof *w, bool *found)
{
    fmb_image m = {0};
    fmb_status st = fmb_met_corners(w->q, w->place, w->image, &m, found);
    if (st == FMB_OK && *found)
        st = claim_all_corners(w, &m, found);
    fmb_image_clear(&m);
    return st;
}

static uint64_t affordable_work(const fmb_query *q)
{
    const fmb_stats *s = &q->run.stats;
    uint64_t row = WORK_OF_ROW * ((uint64_t)fmb_system_dim(q->s) + 1);
    return WORK_OF_ANY + row * s->rows_made + WORK_OF_PAIR * s->pairs + WORK_OF_PROGRAM * s->lps;
}

/* Compute the corners from the rows, within the work for them. */
static fmb_status find_corners_of_rows(completeness_proof *w)
{
    FMB_TRY(w->lifted.q ? FMB_OK : fmb_lifted_open(&w->lifted, w->q, w->image));
    return !w->cornered ? fmb_lifted_run(&w->lifted, w->work / WORK_OF_RAY, &w->cornered) : FMB_OK;
}

/* ---- faces that strict rows leave ------------------------------------------------------------ */

/* y = the mean of points among the corners on[], plus the directions. */
static fmb_status find_middle(completeness_proof *w, const bool *on)
{
    const fmb_evidence *e = w->q->claims;
    size_t dim = (size_t)e->dim, points = 0;
    for (size_t j = 0; j < dim; j++)
        mpq_set_ui(w->x[j], 0, 1);
    for (size_t i = w->first; i < e->claims; i++) {
        const fmb_sparse_vector *list =
            e->claim[i].ray.size > 0 ? &e->claim[i].ray : &e->claim[i].point;
        points += on[i] && e->claim[i].ray.size == 0;
        for (size_t k = 0; on[i] && k < list->size; k++)
            mpq_add(w->x[list->index[k]], w->x[list->index[k]], list->value[k]);
    }
    mpz_ptr t = w->y.z[w->y.size - 1];
    mpz_set_ui(t, 1);
    for (size_t j = 0; j < dim; j++)
        if (w->place[j] >= 0)
            mpz_lcm(t, t, mpq_denref(w->x[j]));
    for (size_t j = 0; j < dim; j++) {
        if (w->place[j] < 0)
            continue;
        mpz_ptr y = w->y.z[w->place[j]];
        mpz_divexact(y, t, mpq_denref(w->x[j]));
        mpz_mul(y, y, mpq_numref(w->x[j]));
    }
    mpz_mul_ui(t, t, points > 0 ? points : 1);
    return fmb_integers_settle(&w->y, w->q->run.mem);
}

/* Run the checker; while it only lacks a preimage for some face, add one. */
static fmb_status satisfy_checker(completeness_proof *w, size_t claim)
{
    const fmb_poll poll = fmb_run_asked(&w->q->run);
    fmb_evidence *e = w->q->claims;
    size_t room = e->claims + MOST_MIDDLES;
    bool *on = fmb_mem_zero(w->q->run.mem, room, sizeof *on), more = on != NULL;
    fmb_status st = on ? FMB_OK : fmb_mem_status(w->q->run.mem);
    while (st == FMB_OK && more) {
        const char *why = NULL;
        more = false;
        st = fmb_complete_check(w->q->s, e, &e->claim[claim], w->q->run.mem, &poll, &why, on);
        w->done = st == FMB_OK && !why;
        w->why = why;
        for (size_t i = w->first; st == FMB_OK && why && i < e->claims; i++)
            more = more || on[i];
        more = more && e->claims < room;
        if (more)
            st = find_middle(w, on);
        if (more && st == FMB_OK)
            st = claim_corner_above(w, true, &more);
    }
    fmb_mem_put(w->q->run.mem, on, room, sizeof *on);
    return st;
}

/* ---- the proof ------------------------------------------------------------------------------- */

static fmb_status claim_complete(completeness_proof *w)
{
    fmb_claim *claim;
    FMB_TRY(fmb_query_claim_whole(w->q, w->place, &claim));
    return satisfy_checker(w, (size_t)(claim - w->q->claims->claim));
}

static void drop_claims(completeness_proof *w)
{
    while (w->q->claims->claims > w->first)
        fmb_evidence_drop_last(w->q->claims);
}

static fmb_status claim_corners_of_rows(completeness_proof *w)
{
    bool found;
    drop_claims(w);
    w->claimed = true;
    FMB_TRY(claim_all_corners(w, &w->lifted.image, &found));
    return found ? claim_complete(w) : FMB_OK;
}

/* Try corners, if cheap enough, then the order of elimination; last: the order comes first. */
static fmb_status try_corners_or_order(completeness_proof *w, bool last)
{
    FMB_TRY(last ? FMB_OK : find_corners_of_rows(w));
    size_t corners = w->lifted.image.rays + 2 * w->lifted.image.lines;
    if (w->cornered && !w->claimed && corners <= 2 * w->work / WORK_OF_PROGRAM)
        FMB_TRY(claim_corners_of_rows(w));
    if (w->done)
        return FMB_OK;
    drop_claims(w);
    return fmb_query_order_complete(w->q, w->place, w->image, w->work, &w->done);
}

static fmb_status prove_complete(completeness_proof *w)
{
    fmb_mem *mem = w->q->run.mem;
    size_t dim = (size_t)fmb_system_dim(w->q->s);
    bool found = false;
    for (size_t i = 0; i < fmb_system_rows(w->q->s); i++)
        w->any_strict = w->any_strict || fmb_system_rel(w->q->s, i) == FMB_LT;
    fmb_status st = fmb_integers_init(&w->y, (size_t)fmb_system_dim(w->image) + 1, mem);
    FMB_THEN(st, fmb_rationals_new(&w->x, dim, mem));
    FMB_THEN(st, find_met_corners(w, &found));
    if (st == FMB_OK && found)
        st = claim_complete(w);
    const uint64_t work = affordable_work(w->q);
    w->why = w->done ? NULL : "it has too many corners";
    for (uint64_t share = FIRST_SHARE; st == FMB_OK && !w->done && share > 0; share /= NEXT_SHARE) {
        w->work = work / share;
        st = try_corners_or_order(w, share == 1);
    }
    if (st == FMB_OK && !w->done)
        st = find_corners_of_rows(w);
    if (st == FMB_OK && !w->done && w->cornered && !w->claimed)
        st = claim_corners_of_rows(w);
    if (w->lifted.q)
        fmb_lifted_close(&w->lifted);
    fmb_preimages_close(w->preimages);
    fmb_rationals_free(w->x, dim, mem);
    fmb_integers_clear(&w->y, mem);
    return st;
}

fmb_status fmb_query_prove_complete(fmb_query *q, const int *place, const fmb_system *image)
{
    if (!fmb_query_proves_complete(q))
        return FMB_OK;
    completeness_proof w = {.q = q, .place = place, .image = image, .first = q->claims->claims};
    fmb_status st = prove_complete(&w);
    if (st != FMB_OK || !w.done)
        drop_claims(&w);
    if (st == FMB_LIMIT) /* a limit of memory if the run was not stopped */
        fmb_solver_refuse(
            q->v, st, "not proved whole: a limit (%s)",
            fmb_stop_text(q->run.stop == FMB_STOP_DONE ? FMB_STOP_BYTES : q->run.stop));
    else if (st == FMB_OK && !w.done)
        fmb_solver_refuse(q->v, st, "not proved whole: %s", w.why);
    if (st == FMB_LIMIT)
        q->run.stop = FMB_STOP_DONE;
    return st == FMB_LIMIT ? FMB_OK : st;
}
