/* project.c: the projection, irredundant.
 *
 * Each part is eliminated by itself; of the rows left, the oracle keeps the irredundant ones. Every
 * row that comes out carries the multipliers that prove it.
 */
#include "elim/derive.h"
#include "elim/witness.h"
#include "solve/irredundant.h"
#include "solve/prune_lp.h"
#include "solve/solver.h"
#include "system/system.h"

/* One part on its way. Row k of the oracle is row e.live[k] of the store. */
typedef struct shadow {
    fmb_query *q;
    const fmb_part *p;
    const int *place; /* [dim] column in the projection, -1 for variables that go */
    fmb_system *out;
    fmb_elim e;
    fmb_lp lp;
    bool has_lp;
    fmb_rel *rel;         /* [lives] */
    fmb_fate *fate;       /* [lives] */
    fmb_weights *reverse; /* [lives] proofs that rows are equalities, over oracle rows */
} shadow;

/* ---- evidence -------------------------------------------------------------------------------- */

/* Weights over oracle rows become weights over the part's rows. */
static fmb_status derive(const shadow *h, fmb_weights *w)
{
    for (size_t i = 0; i < w->size; i++)
        w->index[i] = h->e.live[w->index[i]];
    return fmb_elim_derive(&h->e, w);
}

static fmb_status note_equality(void *self, size_t i, const fmb_weights *w)
{
    shadow *h = self;
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < w->size; k++)
        st = fmb_weights_add(&h->reverse[i], w->index[k], w->value[k], h->q->run.mem);
    return st;
}

static fmb_status claim_conflict(shadow *h)
{
    fmb_weights w = {0};
    if (!h->q->evidence)
        return FMB_OK;
    fmb_status st = fmb_lp_conflict(&h->lp, &w);
    if (st == FMB_OK)
        st = derive(h, &w);
    if (st == FMB_OK)
        st = fmb_query_claim_infeasible(h->q, h->p, &w);
    fmb_weights_clear(&w, h->q->run.mem);
    return st;
}

/* A point of the projection, and above it one of the part. */
static fmb_status note_point(shadow *h)
{
    fmb_query *q = h->q;
    mpq_t *x;
    if (!q->evidence)
        return FMB_OK;
    fmb_status st = fmb_vector_new(&x, (size_t)h->p->n, q->run.mem);
    if (st != FMB_OK)
        return st;
    st = fmb_lp_point(&h->lp, false, x);
    if (st == FMB_OK)
        st = fmb_elim_point(&h->e, FMB_POINT_INSIDE, x);
    if (st == FMB_OK)
        fmb_query_scatter(h->p, x, q->point);
    fmb_vector_free(x, (size_t)h->p->n, q->run.mem);
    return st;
}

static fmb_status push_row(shadow *h, size_t k, int sign, fmb_sparse *list)
{
    fmb_weights w = {0};
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    fmb_status st = fmb_weights_add(&w, (uint32_t)k, one, h->q->run.mem);
    if (st == FMB_OK)
        st = derive(h, &w);
    if (st == FMB_OK)
        st = fmb_query_push(h->q, h->p, &w, SIZE_MAX, sign, list);
    fmb_weights_clear(&w, h->q->run.mem);
    mpq_clear(one);
    return st;
}

static fmb_status fill_claim(shadow *h, size_t k, fmb_claim *claim)
{
    const fmb_derived *r = &h->e.row[h->e.live[k]];
    fmb_status st = FMB_OK;
    claim->rel = h->fate[k] == FMB_FATE_EQUALITY ? FMB_EQ : h->rel[k];
    fmb_vec_get(&r->v, (size_t)h->p->n, mpq_numref(claim->value));
    mpq_t a;
    mpq_init(a);
    for (int j = 0; st == FMB_OK && j < h->p->n; j++) {
        fmb_vec_get(&r->v, (size_t)j, mpq_numref(a));
        st = fmb_evidence_push(h->q->evidence, &claim->terms, (size_t)h->p->var[j], a);
    }
    mpq_clear(a);
    if (st == FMB_OK)
        st = push_row(h, k, 1, &claim->multipliers);
    if (st != FMB_OK || claim->rel != FMB_EQ)
        return st;
    if (h->fate[k] != FMB_FATE_EQUALITY)
        return push_row(h, k, -1, &claim->reverse);
    st = derive(h, &h->reverse[k]);
    return st == FMB_OK ? fmb_query_push(h->q, h->p, &h->reverse[k], SIZE_MAX, 1, &claim->reverse)
                        : st;
}

static fmb_status claim_row(shadow *h, size_t k)
{
    fmb_claim *claim;
    if (!h->q->evidence)
        return FMB_OK;
    fmb_status st = fmb_evidence_claim(h->q->evidence, FMB_CLAIM_IMPLIED, &claim);
    if (st != FMB_OK)
        return st;
    st = fill_claim(h, k, claim);
    if (st != FMB_OK)
        fmb_evidence_drop_last(h->q->evidence);
    return st;
}

/* ---- rows out -------------------------------------------------------------------------------- */

/* Oracle row k as a row of the projection. */
static fmb_status append_row(shadow *h, size_t k)
{
    const fmb_derived *r = &h->e.row[h->e.live[k]];
    size_t n = (size_t)h->p->n, terms = 0;
    fmb_mem *mem = h->q->run.mem;
    mpz_t *z = fmb_mem_get(mem, n + 2, sizeof *z);
    int *var = fmb_mem_get(mem, n, sizeof *var);
    fmb_status st = z && var ? FMB_OK : fmb_mem_status(mem);
    for (size_t j = 0; z && j < n + 2; j++)
        mpz_init(z[j]);
    for (size_t j = 0; st == FMB_OK && j < n; j++) {
        if (fmb_vec_sgn(&r->v, j) == 0)
            continue;
        var[terms] = h->place[h->p->var[j]];
        fmb_vec_get(&r->v, j, z[terms++]);
    }
    if (st == FMB_OK) {
        fmb_vec_get(&r->v, n, z[terms]);
        mpz_set_ui(z[terms + 1], 1);
        st = fmb_system_append(h->out, terms, var, z,
                               h->fate[k] == FMB_FATE_EQUALITY ? FMB_EQ : h->rel[k]);
    }
    for (size_t j = 0; z && j < n + 2; j++)
        mpz_clear(z[j]);
    fmb_mem_put(mem, z, n + 2, sizeof *z);
    fmb_mem_put(mem, var, n, sizeof *var);
    return st;
}

/* Keep what is irredundant of the rows left. */
static fmb_status thin_out(shadow *h)
{
    fmb_verdicts told = {NULL, note_equality, NULL, h};
    fmb_status st = fmb_irredundant(&h->lp, h->rel, h->fate, h->q->evidence ? &told : NULL);
    for (size_t k = 0; st == FMB_OK && k < h->e.lives; k++) {
        if (h->fate[k] == FMB_FATE_REDUNDANT)
            continue;
        st = append_row(h, k);
        if (st == FMB_OK)
            st = claim_row(h, k);
    }
    return st;
}

/* ---- one part -------------------------------------------------------------------------------- */

static fmb_status open_oracle(shadow *h)
{
    fmb_arena *arena = &h->q->v->arena;
    size_t m = h->e.lives;
    fmb_lp_row *rows = fmb_arena_get(arena, m, sizeof *rows);
    h->rel = fmb_arena_get(arena, m, sizeof *h->rel);
    h->fate = fmb_arena_get(arena, m, sizeof *h->fate);
    fmb_weights *reverse = fmb_arena_get(arena, m, sizeof *reverse);
    if (!rows || !h->rel || !h->fate || !reverse)
        return fmb_mem_status(arena->mem);
    for (size_t k = 0; k < m; k++) {
        fmb_derived *r = &h->e.row[h->e.live[k]];
        fmb_status st = fmb_vec_reduce(&r->v, (size_t)h->e.n + 1, &h->e.num);
        if (st != FMB_OK)
            return st;
        h->rel[k] = r->equality ? FMB_EQ : r->strict ? FMB_LT : FMB_LE;
        h->fate[k] = FMB_FATE_UNKNOWN;
        reverse[k] = (fmb_weights){0};
        rows[k] = (fmb_lp_row){&r->v, h->rel[k]};
    }
    h->reverse = reverse;
    h->has_lp = true;
    return fmb_lp_init(&h->lp, &h->q->run, h->p->n, m, rows, fmb_query_is_wide(h->q));
}

static void close_shadow(shadow *h)
{
    if (h->has_lp)
        fmb_lp_clear(&h->lp);
    for (size_t k = 0; h->reverse && k < h->e.lives; k++)
        fmb_weights_clear(&h->reverse[k], h->q->run.mem);
    fmb_elim_clear(&h->e);
}

static fmb_status eliminate(shadow *h)
{
    fmb_query *q = h->q;
    const fmb_solver *v = q->v;
    fmb_prune_lp state = {&q->run, fmb_query_is_wide(q), 2 * h->p->m + 16};
    fmb_rule lp_rule = fmb_prune_lp_rule(&state);
    const fmb_rule *rule[FMB_MAX_RULES];
    int rules = 0;
    for (; rules < v->rules && rules < FMB_MAX_RULES - 1; rules++)
        rule[rules] = v->rule[rules];
    if (v->prunes_by_lp)
        rule[rules++] = &lp_rule;
    bool *drop = fmb_arena_get(&q->v->arena, (size_t)h->p->n, sizeof *drop);
    if (!drop)
        return fmb_mem_status(q->run.mem);
    for (int j = 0; j < h->p->n; j++)
        drop[j] = h->place[h->p->var[j]] < 0;
    fmb_status st = fmb_query_load(q, h->p, rule, rules, &h->e);
    return st == FMB_OK ? fmb_elim_eliminate(&h->e, drop) : st;
}

static fmb_status project_part(shadow *h, fmb_verdict *out)
{
    bool feasible;
    fmb_status st = eliminate(h);
    if (st != FMB_OK)
        return st;
    if (h->e.clash != FMB_NO_ROW) {
        *out = FMB_INFEASIBLE;
        return fmb_query_claim_clash(h->q, h->p, &h->e);
    }
    st = open_oracle(h);
    if (st == FMB_OK)
        st = fmb_lp_feasible(&h->lp, &feasible);
    if (st != FMB_OK)
        return st;
    if (!feasible) {
        *out = FMB_INFEASIBLE;
        return claim_conflict(h);
    }
    st = note_point(h);
    return st == FMB_OK ? thin_out(h) : st;
}

/* ---- the verb -------------------------------------------------------------------------------- */

/* An empty system over the variables kept; keep NULL: the first n. */
static fmb_status open_projection(const fmb_system *s, const int *keep, int n, fmb_system **out)
{
    fmb_system *t;
    fmb_status st = fmb_system_new(0, &s->mem.alloc, &t);
    if (st != FMB_OK)
        return st;
    for (int i = 0; st == FMB_OK && i < n; i++)
        st = fmb_system_add_variable(t, fmb_system_name(s, keep ? keep[i] : i), NULL);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}

fmb_status fmb_empty_set(const fmb_system *like, const int *keep, int n, fmb_system **out)
{
    fmb_system *t;
    mpz_t z[2];
    fmb_status st = open_projection(like, keep, n, &t);
    if (st != FMB_OK)
        return st;
    mpz_init_set_si(z[0], -1);
    mpz_init_set_ui(z[1], 1);
    st = fmb_system_append(t, 0, NULL, z, FMB_LE);
    mpz_clears(z[0], z[1], NULL);
    if (st == FMB_OK)
        *out = t;
    else
        fmb_system_free(t);
    return st;
}

static fmb_status project(fmb_query *q, const int *place, fmb_system *out, fmb_verdict *verdict)
{
    fmb_status st = FMB_OK;
    fmb_verdict found = FMB_FEASIBLE;
    if (q->parts.false_row != SIZE_MAX) {
        *verdict = FMB_INFEASIBLE;
        return fmb_query_claim_false_row(q, q->parts.false_row);
    }
    for (int c = 0; st == FMB_OK && found == FMB_FEASIBLE && c < q->parts.count; c++) {
        shadow h = {.q = q, .p = &q->parts.part[c], .place = place, .out = out};
        h.e.run = &q->run;
        st = project_part(&h, &found);
        close_shadow(&h);
    }
    if (st == FMB_OK && found == FMB_FEASIBLE)
        st = fmb_query_claim_feasible(q);
    if (st == FMB_OK)
        *verdict = found;
    return st;
}

/* The place of each variable in keep, -1 where it is not kept; NULL if keep is not increasing. */
static int *invert(const fmb_system *s, const int *keep, int n, fmb_mem *mem, fmb_status *st)
{
    int dim = fmb_system_dim(s);
    *st = FMB_ERR_ARG;
    for (int i = 0; i < n; i++)
        if (keep[i] < 0 || keep[i] >= dim || (i > 0 && keep[i] <= keep[i - 1]))
            return NULL;
    int *place = n < 0 ? NULL : fmb_mem_get(mem, (size_t)dim, sizeof *place);
    if (!place) {
        *st = n < 0 ? FMB_ERR_ARG : FMB_ERR_MEMORY;
        return NULL;
    }
    for (int j = 0; j < dim; j++)
        place[j] = -1;
    for (int i = 0; i < n; i++)
        place[keep[i]] = i;
    *st = FMB_OK;
    return place;
}

fmb_status fmb_project(fmb_solver *v, const fmb_system *s, const int *keep, int n, fmb_system **out,
                       fmb_result *res)
{
    fmb_query q;
    fmb_system *image = NULL, *empty = NULL;
    fmb_verdict verdict = FMB_UNKNOWN;
    fmb_status st = FMB_ERR_ARG;
    int *place = out ? invert(s, keep, n, &v->mem, &st) : NULL;
    if (!place)
        return st;
    st = fmb_query_begin(&q, v, s, "project");
    if (st == FMB_OK)
        st = open_projection(s, keep, n, &image);
    if (st == FMB_OK)
        st = project(&q, place, image, &verdict);
    if (st != FMB_OK || verdict == FMB_INFEASIBLE) {
        fmb_system_free(image);
        image = NULL;
    }
    if (st == FMB_OK && verdict == FMB_INFEASIBLE)
        st = fmb_empty_set(s, keep, n, &empty);
    fmb_mem_put(&v->mem, place, (size_t)fmb_system_dim(s), sizeof *place);
    st = fmb_query_end(&q, st, verdict, res);
    if (st == FMB_OK)
        *out = empty ? empty : image;
    else
        fmb_system_free(empty ? empty : image);
    return st;
}
