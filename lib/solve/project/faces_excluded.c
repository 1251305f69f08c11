/* faces_excluded.c: strict rows of a projection that describe no facet; see canonical.h.
 *
 * The inequalities are irredundant and reduced by the equations, so none is always tight. Theorem
 * 26 in docs/theory.md shows how to find the facets that contain the face of a strict row, and how
 * to prove their sum.
 */
#include <string.h>

#include "lp/oracle/oracle.h"
#include "lp/redundancy/irredundant.h"
#include "lp/redundancy/ray_shooting/ray_shooting.h"
#include "num/bitset.h"
#include "num/integers.h"
#include "num/rationals.h"
#include "solve/project/canonical.h"

typedef struct excluded_face {
    size_t row;     /* of the image: strict, describes no facet */
    uint64_t *on;   /* facets that contain the face */
    fmb_weights y;  /* multipliers of facets that combine to the row */
    bool redundant; /* other rows imply the row */
} excluded_face;

typedef struct face_search {
    fmb_claimed_rows *c;
    fmb_arena *arena;
    size_t n; /* columns of the image */
    size_t facets, faces, words;
    size_t *facet;       /* [facets] rows of the image */
    excluded_face *face; /* [faces] */
    fmb_program program; /* facets, < read as <= */
    fmb_oracle *oracle;
    mpq_t *x; /* [n] a point of the current face */
} face_search;

/* ---- which rows are facets ------------------------------------------------------------------- */

/* The inequalities as input of the redundancy test, and its results. */
typedef struct closure {
    size_t n, m;
    size_t *row; /* [m] of the image */
    fmb_lp_row *lp;
    fmb_fate *fate;
} closure;

static fmb_status close_row(const face_search *f, const fmb_sysrow *r, mpz_t *z, fmb_lp_row *out)
{
    fmb_vec *v;
    FMB_TRY(FMB_ARENA_GET(f->arena, v, 1));
    int64_t *s;
    FMB_TRY(FMB_ARENA_GET(f->arena, s, f->n + 1));
    *v = (fmb_vec){.s = s};
    *out = (fmb_lp_row){v, FMB_LE};
    fmb_sysrow_expand(r, f->n, z);
    return fmb_vec_set_z(v, f->n + 1, z, f->arena->mem);
}

/* Close it, even after an error. */
static fmb_status open_closure(closure *o, const face_search *f)
{
    const fmb_system *image = f->c->image;
    fmb_integers z = {0};
    *o = (closure){.n = f->n};
    FMB_TRY(FMB_ARENA_GET(f->arena, o->row, image->rows));
    FMB_TRY(FMB_ARENA_GET(f->arena, o->lp, image->rows));
    FMB_TRY(FMB_ARENA_GET(f->arena, o->fate, image->rows));
    fmb_status st = fmb_integers_init(&z, f->n + 1, f->arena->mem);
    for (size_t i = 0; st == FMB_OK && i < image->rows; i++) {
        if (image->row[i].rel == FMB_EQ)
            continue;
        o->row[o->m] = i;
        o->fate[o->m] = FMB_FATE_UNKNOWN;
        st = close_row(f, &image->row[i], z.z, &o->lp[o->m]);
        o->m += st == FMB_OK;
    }
    fmb_integers_clear(&z, f->arena->mem);
    return st;
}

static void close_closure(closure *o, const face_search *f)
{
    for (size_t i = 0; i < o->m; i++) {
        fmb_vec v = *o->lp[i].v;
        fmb_vec_clear(&v, o->n + 1, f->arena->mem);
    }
}

static fmb_status sort_by_ray_shooting(closure *o, fmb_run *run)
{
    fmb_ray_shooting shooting;
    bool inner = false;
    fmb_status st = fmb_ray_shooting_open(&shooting, run, o->n, o->m, o->lp, &inner);
    if (st == FMB_OK && inner)
        st = fmb_ray_shooting_sort(&shooting, o->fate, NULL);
    fmb_ray_shooting_close(&shooting);
    return st;
}

static fmb_status tell_facets_from_faces(face_search *f, closure *o)
{
    fmb_run *run = &f->c->q->run;
    fmb_status st =
        fmb_ray_shooting_is_affordable(o->n, o->m) ? sort_by_ray_shooting(o, run) : FMB_OK;
    bool unknown = false;
    for (size_t i = 0; i < o->m; i++)
        unknown = unknown || o->fate[i] == FMB_FATE_UNKNOWN;
    bool feasible; /* always true: the projection is not empty */
    return st == FMB_OK && unknown ? fmb_redundant(run, o->n, o->m, o->lp, NULL, o->fate, &feasible)
                                   : st;
}

static fmb_status list_facets_and_faces(face_search *f)
{
    closure o;
    fmb_status st = open_closure(&o, f);
    FMB_THEN(st, tell_facets_from_faces(f, &o));
    f->facet = fmb_arena_get(f->arena, o.m, sizeof *f->facet);
    f->face = fmb_arena_get(f->arena, o.m, sizeof *f->face);
    if (st == FMB_OK && (!f->facet || !f->face))
        st = fmb_mem_status(f->arena->mem);
    for (size_t i = 0; st == FMB_OK && i < o.m; i++) {
        if (o.fate[i] == FMB_FATE_REDUNDANT)
            f->face[f->faces++] = (excluded_face){.row = o.row[i]};
        else
            f->facet[f->facets++] = o.row[i];
    }
    f->words = fmb_set_words(f->facets);
    close_closure(&o, f);
    return st;
}

/* ---- the facets that hold a face ------------------------------------------------------------- */

static fmb_status add_row_to_program(const face_search *f, size_t i, fmb_rel rel, fmb_program *p)
{
    const fmb_sysrow *r = &f->c->image->row[i];
    return fmb_program_add(p, r->nnz, r->var, NULL, &r->val, rel);
}

static fmb_status open_facets_program(face_search *f)
{
    fmb_run *run = &f->c->q->run;
    bool feasible;
    FMB_TRY(fmb_rationals_new(&f->x, f->n, run->mem));
    for (size_t i = 0; i < f->facets; i++)
        FMB_TRY(add_row_to_program(f, f->facet[i], FMB_LE, &f->program));
    FMB_TRY(fmb_oracle_new(run, &f->program, &f->oracle));
    return fmb_oracle_feasible(f->oracle, &feasible);
}

/* Find face->y, multipliers of facets that combine to the row, and a point where it is tight. */
static fmb_status write_row_by_facets(face_search *f, excluded_face *face)
{
    fmb_mem *mem = f->c->q->run.mem;
    const fmb_sysrow *r = &f->c->image->row[face->row];
    fmb_weights form = {0};
    fmb_oracle_end end = FMB_ORACLE_UNBOUNDED;
    bool attained;
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < r->nnz; k++) {
        fmb_vec_get_q(&r->val, k, a);
        st = fmb_weights_add(&form, (uint32_t)r->var[k], a, mem);
    }
    FMB_THEN(st, fmb_oracle_maximize(f->oracle, &form, &end, &attained));
    FMB_THEN(st, fmb_oracle_value(f->oracle, a));
    FMB_THEN(st, fmb_oracle_point(f->oracle, f->x));
    if (st == FMB_OK) {
        fmb_vec_get_q(&r->val, r->nnz, b);
        face->redundant = mpq_cmp(a, b) < 0;
        st = fmb_oracle_multipliers(f->oracle, &face->y);
    }
    for (size_t k = 0; st == FMB_OK && k < face->y.size; k++)
        if (mpq_sgn(face->y.value[k]) > 0)
            fmb_set_put(face->on, face->y.index[k]);
    mpq_clears(a, b, NULL);
    fmb_weights_clear(&form, mem);
    return st;
}

static bool is_tight_at_point(const face_search *f, size_t i)
{
    const fmb_sysrow *r = &f->c->image->row[i];
    mpq_t sum, a;
    mpq_inits(sum, a, NULL);
    fmb_vec_get_q(&r->val, r->nnz, sum);
    for (size_t k = 0; k < r->nnz; k++) {
        fmb_vec_get_q(&r->val, k, a);
        mpq_mul(a, a, f->x[r->var[k]]);
        mpq_sub(sum, sum, a);
    }
    bool tight = mpq_sgn(sum) == 0;
    mpq_clears(sum, a, NULL);
    return tight;
}

/* Is there a point where the facets in face->on are tight and no doubtful facet is? *more: some of
 * the doubtful ones are always tight, and are in face->on now. */
static fmb_status ask_about_doubtful_facets(face_search *f, excluded_face *face,
                                            const uint64_t *doubtful, bool *more)
{
    fmb_run *run = &f->c->q->run;
    fmb_program p;
    fmb_oracle *o = NULL;
    fmb_weights w = {0};
    bool feasible = true;
    fmb_status st = FMB_OK;
    fmb_program_init(&p, run->mem, (int)f->n);
    for (size_t i = 0; st == FMB_OK && i < f->facets; i++) {
        fmb_rel rel = fmb_set_has(face->on, i)   ? FMB_EQ
                      : fmb_set_has(doubtful, i) ? FMB_LT
                                                 : FMB_LE;
        st = add_row_to_program(f, f->facet[i], rel, &p);
    }
    FMB_THEN(st, fmb_oracle_new(run, &p, &o));
    FMB_THEN(st, fmb_oracle_feasible(o, &feasible));
    if (st == FMB_OK && !feasible)
        st = fmb_oracle_conflict(o, &w);
    *more = st == FMB_OK && !feasible;
    for (size_t k = 0; st == FMB_OK && k < w.size; k++)
        if (mpq_sgn(w.value[k]) > 0)
            fmb_set_put(face->on, w.index[k]);
    fmb_weights_clear(&w, run->mem);
    fmb_oracle_free(o);
    fmb_program_clear(&p);
    return st;
}

static fmb_status find_facets_of_face(face_search *f, excluded_face *face)
{
    bool more = true;
    uint64_t *doubtful;
    FMB_TRY(FMB_ARENA_GET(f->arena, doubtful, f->words));
    FMB_TRY(FMB_ARENA_GET(f->arena, face->on, f->words));
    memset(doubtful, 0, f->words * sizeof *doubtful);
    memset(face->on, 0, f->words * sizeof *face->on);
    FMB_TRY(write_row_by_facets(f, face));
    for (size_t i = 0; i < f->facets; i++)
        if (is_tight_at_point(f, f->facet[i]))
            fmb_set_put(doubtful, i);
    while (!face->redundant && more) {
        more = !fmb_set_is_inside(doubtful, face->on, f->words);
        if (more)
            FMB_TRY(ask_about_doubtful_facets(f, face, doubtful, &more));
    }
    return FMB_OK;
}

/* Mark rows as redundant whose face lies in another excluded face, or in an excluded facet. */
static void find_faces_of_missing_ones(face_search *f)
{
    for (size_t i = 0; i < f->faces; i++) {
        excluded_face *face = &f->face[i];
        face->redundant = face->redundant || f->c->image->row[face->row].rel != FMB_LT;
        for (size_t k = 0; !face->redundant && k < f->facets; k++)
            face->redundant =
                fmb_set_has(face->on, k) && f->c->image->row[f->facet[k]].rel == FMB_LT;
    }
    for (size_t i = 0; i < f->faces; i++)
        for (size_t k = 0; !f->face[i].redundant && k < f->faces; k++)
            f->face[i].redundant = k != i && !f->face[k].redundant &&
                                   fmb_set_is_inside(f->face[k].on, f->face[i].on, f->words);
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* z[n + 1] = the sum of the facets that contain the face, over its content, which is also set. */
static fmb_status sum_facets_of_face(const face_search *f, const excluded_face *face, mpz_t *z,
                                     mpz_t content)
{
    const fmb_poll poll = fmb_run_asked(&f->c->q->run);
    mpz_t a;
    mpz_init(a);
    for (size_t j = 0; j <= f->n; j++)
        mpz_set_ui(z[j], 0);
    for (size_t i = 0; i < f->facets; i++) {
        const fmb_sysrow *r = &f->c->image->row[f->facet[i]];
        for (size_t k = 0; fmb_set_has(face->on, i) && k <= r->nnz; k++) {
            mpz_ptr to = z[k < r->nnz ? (size_t)r->var[k] : f->n];
            fmb_vec_get(&r->val, k, a);
            mpz_add(to, to, a);
        }
    }
    mpz_clear(a);
    return fmb_integers_reduce(z, f->n + 1, content, &poll);
}

/* The multipliers in the proof of theorem 27, over the content. */
static fmb_status prove_sum(const face_search *f, const excluded_face *face, const mpz_t content,
                            fmb_weights *w)
{
    fmb_mem *mem = f->c->q->run.mem;
    fmb_status st = FMB_OK;
    mpq_t most, part, whole;
    mpq_inits(most, part, whole, NULL);
    mpz_set(mpq_numref(whole), content);
    mpq_inv(whole, whole);
    for (size_t k = 0; k < face->y.size; k++)
        if (mpq_cmp(face->y.value[k], most) > 0)
            mpq_set(most, face->y.value[k]);
    mpq_div(part, whole, most);
    st = fmb_weights_add(w, (uint32_t)face->row, part, mem);
    for (size_t i = 0; st == FMB_OK && i < f->facets; i++)
        if (fmb_set_has(face->on, i))
            st = fmb_weights_add(w, (uint32_t)f->facet[i], whole, mem);
    for (size_t k = 0; st == FMB_OK && k < face->y.size; k++) {
        mpq_div(part, face->y.value[k], most);
        mpq_mul(part, part, whole);
        for (size_t i = 1; i < w->size; i++)
            if (w->index[i] == f->facet[face->y.index[k]])
                mpq_sub(w->value[i], w->value[i], part);
    }
    mpq_clears(most, part, whole, NULL);
    return st;
}

static fmb_status put_row_of_face(face_search *f, const excluded_face *face)
{
    fmb_mem *mem = f->c->q->run.mem;
    fmb_integers z;
    fmb_weights w = {0};
    mpz_t content;
    mpz_init(content);
    fmb_status st = fmb_integers_init(&z, f->n + 1, mem);
    FMB_THEN(st, sum_facets_of_face(f, face, z.z, content));
    FMB_THEN(st, fmb_integers_settle(&z, mem));
    FMB_THEN(st, prove_sum(f, face, content, &w));
    FMB_THEN(st, fmb_claimed_rows_append(f->c, z.z, FMB_LT, &w));
    if (st == FMB_OK)
        fmb_claimed_rows_put_last(f->c, face->row);
    mpz_clear(content);
    fmb_weights_clear(&w, mem);
    fmb_integers_clear(&z, mem);
    return st;
}

/* Replace the rows of all faces; remove the redundant ones, last first, as later rows move up. */
static fmb_status put_all_faces(face_search *f)
{
    for (size_t i = 0; i < f->faces; i++)
        if (!f->face[i].redundant)
            FMB_TRY(put_row_of_face(f, &f->face[i]));
    for (size_t i = f->faces; i-- > 0;)
        if (f->face[i].redundant)
            fmb_claimed_rows_drop(f->c, f->face[i].row);
    return FMB_OK;
}

/* ---- all ------------------------------------------------------------------------------------- */

static fmb_status settle_faces(face_search *f)
{
    FMB_TRY(open_facets_program(f));
    for (size_t i = 0; i < f->faces; i++)
        FMB_TRY(find_facets_of_face(f, &f->face[i]));
    find_faces_of_missing_ones(f);
    return put_all_faces(f);
}

fmb_status fmb_canonical_faces(fmb_claimed_rows *c)
{
    fmb_query *q = c->q;
    face_search f = {.c = c, .arena = &q->v->arena, .n = (size_t)fmb_system_dim(c->image)};
    bool strict = false;
    for (size_t i = 0; !strict && i < c->image->rows; i++)
        strict = c->image->row[i].rel == FMB_LT;
    if (!strict)
        return FMB_OK;
    fmb_program_init(&f.program, q->run.mem, (int)f.n);
    fmb_status st = list_facets_and_faces(&f);
    if (st == FMB_OK && f.faces > 0)
        st = settle_faces(&f);
    for (size_t i = 0; i < f.faces; i++)
        fmb_weights_clear(&f.face[i].y, q->run.mem);
    fmb_oracle_free(f.oracle);
    fmb_program_clear(&f.program);
    fmb_rationals_free(f.x, f.n, q->run.mem);
    return st;
}
