/* evidence.c: life of an fmb_evidence, and its public accessors; see evidence.h. */
#include "proof/evidence.h"

#include <math.h>
#include <string.h>

/* ---- lists and vectors of rationals ---------------------------------------------------------- */

/* n rationals, all 0; NULL without memory. */
static mpq_t *rationals(fmb_mem *mem, size_t n)
{
    mpq_t *q = fmb_mem_get(mem, n, sizeof *q);
    for (size_t i = 0; q && i < n; i++)
        mpq_init(q[i]);
    return q;
}

static void put_rationals(fmb_mem *mem, mpq_t *q, size_t n)
{
    for (size_t i = 0; q && i < n; i++)
        mpq_clear(q[i]);
    fmb_mem_put(mem, q, n, sizeof *q);
}

static void clear_list(fmb_mem *mem, fmb_sparse *list)
{
    for (size_t k = 0; k < list->size; k++)
        mpq_clear(list->value[k]);
    fmb_mem_put(mem, list->index, list->capacity, sizeof *list->index);
    fmb_mem_put(mem, list->value, list->capacity, sizeof *list->value);
    *list = (fmb_sparse){.size = 0};
}

/* Both arrays grow or neither does: they share one capacity. */
static fmb_status grow_list(fmb_mem *mem, fmb_sparse *list)
{
    size_t capacity = list->capacity + list->capacity / 2 + 4;
    size_t *index = fmb_mem_get(mem, capacity, sizeof *index);
    mpq_t *value = index ? fmb_mem_get(mem, capacity, sizeof *value) : NULL;
    if (!value) {
        fmb_status st = fmb_mem_status(mem);
        fmb_mem_put(mem, index, capacity, sizeof *index);
        return st;
    }
    if (list->size > 0) {
        memcpy(index, list->index, list->size * sizeof *index);
        memcpy(value, list->value, list->size * sizeof *value);
    }
    fmb_mem_put(mem, list->index, list->capacity, sizeof *index);
    fmb_mem_put(mem, list->value, list->capacity, sizeof *value);
    *list = (fmb_sparse){index, value, list->size, capacity};
    return FMB_OK;
}

fmb_status fmb_evidence_push(fmb_evidence *e, fmb_sparse *list, size_t index, const mpq_t value)
{
    if (mpq_sgn(value) == 0)
        return FMB_OK;
    fmb_status st = list->size == list->capacity ? grow_list(&e->mem, list) : FMB_OK;
    if (st != FMB_OK)
        return st;
    list->index[list->size] = index;
    mpq_init(list->value[list->size]);
    mpq_set(list->value[list->size++], value);
    return FMB_OK;
}

fmb_status fmb_evidence_vector(fmb_evidence *e, mpq_t **slot)
{
    mpq_t *q = rationals(&e->mem, (size_t)e->dim);
    if (!q)
        return fmb_mem_status(&e->mem);
    put_rationals(&e->mem, *slot, (size_t)e->dim);
    *slot = q;
    return FMB_OK;
}

/* ---- claims ---------------------------------------------------------------------------------- */

static size_t limbs_of(mpq_t *q, size_t n)
{
    size_t limbs = 0;
    for (size_t i = 0; q && i < n; i++)
        limbs += mpz_size(mpq_numref(q[i])) + mpz_size(mpq_denref(q[i]));
    return limbs;
}

/* Charge the limbs of the last claim, which is filled by now. */
static fmb_status weigh_last(fmb_evidence *e)
{
    if (e->mem.limit == 0 || e->claims == 0)
        return FMB_OK;
    const fmb_claim *c = &e->claim[e->claims - 1];
    size_t limbs = limbs_of(c->multipliers.value, c->multipliers.size) +
                   limbs_of(c->reverse.value, c->reverse.size) +
                   limbs_of(c->point, (size_t)e->dim) + limbs_of(c->ray, (size_t)e->dim);
    return fmb_mem_charge(&e->mem, limbs * sizeof(mp_limb_t)) ? FMB_OK : fmb_mem_status(&e->mem);
}

fmb_status fmb_evidence_claim(fmb_evidence *e, fmb_claim_kind kind, fmb_claim **out)
{
    fmb_status st = weigh_last(e);
    if (st != FMB_OK)
        return st;
    st = fmb_mem_reserve(&e->mem, (void **)&e->claim, &e->claim_capacity, e->claims + 1,
                         sizeof *e->claim);
    if (st != FMB_OK)
        return st;
    fmb_claim *c = &e->claim[e->claims++];
    *c = (fmb_claim){.kind = kind, .row = SIZE_MAX, .var = -1};
    mpq_init(c->value);
    *out = c;
    return FMB_OK;
}

void fmb_evidence_drop_last(fmb_evidence *e)
{
    fmb_claim *c = &e->claim[--e->claims];
    mpq_clear(c->value);
    clear_list(&e->mem, &c->terms);
    clear_list(&e->mem, &c->multipliers);
    clear_list(&e->mem, &c->reverse);
    put_rationals(&e->mem, c->point, (size_t)e->dim);
    put_rationals(&e->mem, c->ray, (size_t)e->dim);
}

void fmb_evidence_reset(fmb_evidence *e)
{
    while (e->claims > 0)
        fmb_evidence_drop_last(e);
}

/* ---- whole evidence -------------------------------------------------------------------------- */

fmb_status fmb_evidence_new(int dim, size_t rows, const fmb_alloc *hook, fmb_evidence **out)
{
    fmb_mem mem;
    fmb_mem_init(&mem, hook, 0);
    fmb_evidence *e = fmb_mem_zero(&mem, 1, sizeof *e);
    if (!e)
        return FMB_ERR_MEMORY;
    e->mem = mem;
    e->dim = dim;
    e->rows = rows;
    *out = e;
    return FMB_OK;
}

void fmb_evidence_free(fmb_evidence *e)
{
    if (!e)
        return;
    fmb_evidence_reset(e);
    fmb_mem_put(&e->mem, e->claim, e->claim_capacity, sizeof *e->claim);
    fmb_mem mem = e->mem;
    fmb_mem_put(&mem, e, 1, sizeof *e);
}

static fmb_status copy_list(fmb_evidence *e, fmb_sparse *to, const fmb_sparse *from)
{
    fmb_status st = FMB_OK;
    for (size_t k = 0; st == FMB_OK && k < from->size; k++)
        st = fmb_evidence_push(e, to, from->index[k], from->value[k]);
    return st;
}

static fmb_status copy_vector(fmb_evidence *e, mpq_t **to, mpq_t *from)
{
    if (!from)
        return FMB_OK;
    fmb_status st = fmb_evidence_vector(e, to);
    for (int j = 0; st == FMB_OK && j < e->dim; j++)
        mpq_set((*to)[j], from[j]);
    return st;
}

static fmb_status copy_claim(fmb_evidence *e, const fmb_claim *from)
{
    fmb_claim *to;
    fmb_status st = fmb_evidence_claim(e, from->kind, &to);
    if (st != FMB_OK)
        return st;
    to->row = from->row;
    to->var = from->var;
    to->side = from->side;
    to->rel = from->rel;
    mpq_set(to->value, from->value);
    st = copy_list(e, &to->terms, &from->terms);
    if (st == FMB_OK)
        st = copy_list(e, &to->multipliers, &from->multipliers);
    if (st == FMB_OK)
        st = copy_list(e, &to->reverse, &from->reverse);
    if (st == FMB_OK)
        st = copy_vector(e, &to->point, from->point);
    if (st == FMB_OK)
        st = copy_vector(e, &to->ray, from->ray);
    return st;
}

fmb_status fmb_evidence_copy(const fmb_evidence *e, fmb_evidence **out)
{
    fmb_evidence *copy;
    fmb_status st = fmb_evidence_new(e->dim, e->rows, &e->mem.alloc, &copy);
    if (st != FMB_OK)
        return st;
    for (size_t i = 0; st == FMB_OK && i < e->claims; i++)
        st = copy_claim(copy, &e->claim[i]);
    if (st == FMB_OK)
        *out = copy;
    else
        fmb_evidence_free(copy);
    return st;
}

/* ---- accessors ------------------------------------------------------------------------------- */

size_t fmb_evidence_claims(const fmb_evidence *e)
{
    return e->claims;
}

fmb_claim_kind fmb_evidence_kind(const fmb_evidence *e, size_t i)
{
    return e->claim[i].kind;
}

size_t fmb_evidence_row(const fmb_evidence *e, size_t i)
{
    return e->claim[i].row;
}

int fmb_evidence_var(const fmb_evidence *e, size_t i)
{
    return e->claim[i].var;
}

/* Copy q to out, 0 for NULL. */
static void give(mpq_srcptr q, mpq_t out)
{
    if (q)
        mpq_set(out, q);
    else
        mpq_set_ui(out, 0, 1);
}

static mpq_srcptr multiplier(const fmb_evidence *e, size_t i, size_t r)
{
    const fmb_sparse *list = &e->claim[i].multipliers;
    for (size_t k = 0; k < list->size; k++)
        if (list->index[k] == r)
            return list->value[k];
    return NULL;
}

void fmb_evidence_multiplier_q(const fmb_evidence *e, size_t i, size_t r, mpq_t out)
{
    give(multiplier(e, i, r), out);
}

void fmb_evidence_coordinate_q(const fmb_evidence *e, size_t i, int j, mpq_t out)
{
    give(e->claim[i].point ? e->claim[i].point[j] : NULL, out);
}

void fmb_evidence_ray_q(const fmb_evidence *e, size_t i, int j, mpq_t out)
{
    give(e->claim[i].ray ? e->claim[i].ray[j] : NULL, out);
}

void fmb_evidence_value_q(const fmb_evidence *e, size_t i, mpq_t out)
{
    mpq_set(out, e->claim[i].value);
}

/* The double nearest to q: mpq_get_d cuts towards zero, so the answer is that or the next one
 * outward, whichever lies on q's side of the middle (inward on the middle itself). */
static double nearest(mpq_srcptr q)
{
    double in = mpq_get_d(q), out = nextafter(in, mpq_sgn(q) < 0 ? -INFINITY : INFINITY);
    if (mpq_sgn(q) == 0 || isinf(out))
        return in;
    mpq_t middle, other;
    mpq_inits(middle, other, NULL);
    mpq_set_d(middle, in);
    mpq_set_d(other, out);
    mpq_add(middle, middle, other);
    mpq_div_2exp(middle, middle, 1);
    bool beyond = mpq_cmp(q, middle) * mpq_sgn(q) > 0;
    mpq_clears(middle, other, NULL);
    return beyond ? out : in;
}

double fmb_evidence_multiplier(const fmb_evidence *e, size_t i, size_t r)
{
    mpq_srcptr q = multiplier(e, i, r);
    return q ? nearest(q) : 0;
}

double fmb_evidence_coordinate(const fmb_evidence *e, size_t i, int j)
{
    return e->claim[i].point ? nearest(e->claim[i].point[j]) : 0;
}
