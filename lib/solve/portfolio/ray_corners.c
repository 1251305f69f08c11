/* ray_corners.c: see ray_corners.h. A proof that no row is missing begins with corners; here each
 * comes with a ray of the cone that projects to it, and eliminated variables are reconstructed.
 */
#include "solve/portfolio/ray_corners.h"

#include "elim/round/witness.h"
#include "num/rationals.h"

/* Scratch for the points and directions that are handed over. */
typedef struct corner_room {
    size_t kept; /* columns of the part, whether rows name them or not */
    mpz_t *z;    /* [kept + 1] */
    mpq_t *x;    /* [n] */
    fmb_vec y;   /* [kept + 1] */
    fmb_num num; /* of kept + 1 entries */
} corner_room;

/* Write x as integers with their common denominator last; for directions that entry is 0. */
static fmb_status write_over_denominator(const fmb_ray_corners *h, mpq_t *x, bool point,
                                         fmb_integers *out)
{
    size_t n = (size_t)h->of->p->n;
    FMB_TRY(fmb_integers_init(out, n + 1, h->of->q->run.mem));
    mpz_ptr t = out->z[n];
    mpz_set_ui(t, 1);
    for (size_t j = 0; j < n; j++)
        mpz_lcm(t, t, mpq_denref(x[j]));
    for (size_t j = 0; j < n; j++) {
        mpz_divexact(out->z[j], t, mpq_denref(x[j]));
        mpz_mul(out->z[j], out->z[j], mpq_numref(x[j]));
    }
    if (!point)
        mpz_set_ui(t, 0);
    return fmb_integers_settle(out, h->of->q->run.mem);
}

/* No variable was eliminated: copy v, a vector of the cone. */
static fmb_status copy_solution(const fmb_ray_corners *h, const fmb_vec *v, fmb_integers *out)
{
    size_t n = (size_t)h->of->p->n;
    fmb_status st = fmb_integers_init(out, n + 1, h->of->q->run.mem);
    for (size_t k = 0; st == FMB_OK && k < h->d; k++)
        fmb_vec_get(v, k, out->z[k + 1 == h->keeps ? n : h->column[h->keep[k]]]);
    return st == FMB_OK ? fmb_integers_settle(out, h->of->q->run.mem) : st;
}

/* Find a preimage by reconstructing the eliminated variables. v is a vector of the cone; or NULL,
 * and x holds the kept variables. */
static fmb_status find_solution(const fmb_ray_corners *h, const fmb_vec *v, mpq_t *x,
                                fmb_integers *out)
{
    bool point = v && fmb_vec_sgn(v, h->keeps - 1) > 0;
    if (v && h->of->e.rounds == 0)
        return copy_solution(h, v, out);
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(t, 1, 1);
    if (point)
        fmb_vec_get_q(v, h->keeps - 1, t);
    for (size_t k = 0; v && k < h->d; k++) {
        if (k + 1 == h->keeps)
            continue;
        mpq_ptr to = x[h->column[h->keep[k]]];
        fmb_vec_get_q(v, k, to);
        mpq_div(to, to, t);
    }
    mpq_clear(t);
    fmb_status st = fmb_elim_point(&h->of->e, point ? FMB_POINT_CLOSURE : FMB_POINT_RAY, x);
    return st == FMB_OK ? write_over_denominator(h, x, point, out) : st;
}

/* Hand over the projection of v, a vector of the cone, with its preimage; or, where v is NULL, the
 * direction of kept variable number `free`, if no row names it. */
static fmb_status hand_over_vector(const fmb_ray_corners *h, const fmb_vec *v, size_t free,
                                   corner_room *r)
{
    fmb_query *q = h->of->q;
    fmb_integers x = {0};
    size_t at = 0, named = 0;
    bool nonzero = v != NULL;
    for (int j = 0; j < h->of->p->n; j++) {
        mpq_set_ui(r->x[j], 0, 1);
        if (h->of->place[h->of->p->var[j]] < 0)
            continue;
        bool is_named = named + 1 < h->keeps && h->column[h->keep[named]] == (size_t)j;
        bool is_free = !v && !is_named && at == free;
        nonzero |= is_free;
        mpq_set_ui(r->x[j], is_free, 1);
        mpz_set_ui(r->z[at], is_free);
        if (v && is_named)
            fmb_vec_get(v, named, r->z[at]);
        named += is_named;
        at++;
    }
    mpz_set_ui(r->z[at], 0);
    if (v)
        fmb_vec_get(v, h->keeps - 1, r->z[at]);
    if (!nonzero)
        return FMB_OK;
    fmb_status st = fmb_vec_set_z(&r->y, at + 1, r->z, q->run.mem);
    FMB_THEN(st, find_solution(h, v, r->x, &x));
    if (st == FMB_OK)
        return fmb_met_points_add(&q->met, &r->y, &x, &r->num);
    fmb_integers_clear(&x, q->run.mem);
    return st;
}

static fmb_status hand_over_vectors(const fmb_ray_corners *h, corner_room *r)
{
    fmb_status st = fmb_image_keep_corners(h->image);
    for (size_t i = 0; st == FMB_OK && i < h->image->rays; i++)
        st = hand_over_vector(h, h->image->above[i], 0, r);
    for (size_t i = 0; st == FMB_OK && i < h->image->lines; i++)
        st = hand_over_vector(h, h->image->line_above[i], 0, r);
    for (size_t k = 0; st == FMB_OK && k < r->kept; k++)
        st = hand_over_vector(h, NULL, k, r);
    return st;
}

fmb_status fmb_ray_corners_hand_over(const fmb_ray_corners *h)
{
    fmb_query *q = h->of->q;
    fmb_mem *mem = q->run.mem;
    size_t n = (size_t)h->of->p->n;
    corner_room r = {0};
    for (size_t j = 0; j < n; j++)
        r.kept += h->of->place[h->of->p->var[j]] >= 0;
    if (!fmb_query_proves_complete(q) || r.kept == 0)
        return FMB_OK;
    r.z = fmb_vec_block(r.kept + 1, mem);
    r.y.s = fmb_mem_get(mem, r.kept + 1, sizeof *r.y.s);
    fmb_met_points_begin(&q->met, mem, (int)(h->of->p - q->parts.part), r.kept);
    fmb_status st = fmb_run_open_num(&q->run, &r.num, r.kept + 1, fmb_query_is_wide(q));
    FMB_THEN(st, fmb_rationals_new(&r.x, n, mem));
    FMB_THEN(st, r.z && r.y.s ? hand_over_vectors(h, &r) : fmb_mem_status(mem));
    fmb_num_clear(&r.num);
    fmb_rationals_free(r.x, n, mem);
    fmb_vec_block_free(r.z, r.kept + 1, mem);
    fmb_vec_clear(&r.y, r.kept + 1, mem);
    fmb_mem_put(mem, r.y.s, r.kept + 1, sizeof *r.y.s);
    if (st == FMB_LIMIT)
        fmb_met_points_clear(&q->met);
    return st == FMB_LIMIT && q->run.stop == FMB_STOP_DONE ? FMB_OK : st;
}
