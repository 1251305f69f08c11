/* evidence.c: creation of an fmb_evidence, and its public accessors; see evidence.h. */
#include "proof/evidence/evidence.h"

#include <string.h>

#include "num/rationals.h"

/* ---- lists ----------------------------------------------------------------------------------- */

/* About what malloc uses for the limbs of a rational: blocks of 16 bytes, with a header of 8. */
static size_t limb_bytes(mpq_srcptr q)
{
    size_t num = mpz_size(mpq_numref(q)), den = mpz_size(mpq_denref(q));
    return (num + den) * sizeof(mp_limb_t) + 2 * 24;
}

static void clear_list(fmb_mem *mem, fmb_sparse_vector *list)
{
    for (size_t k = 0; k < list->size; k++) {
        fmb_mem_refund(mem, limb_bytes(list->value[k]));
        mpq_clear(list->value[k]);
    }
    fmb_mem_put(mem, list->index, list->capacity, sizeof *list->index);
    fmb_mem_put(mem, list->value, list->capacity, sizeof *list->value);
    *list = (fmb_sparse_vector){.size = 0};
}

/* Grow both arrays or neither: they share one capacity. */
static fmb_status grow_list(fmb_mem *mem, fmb_sparse_vector *list)
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
    *list = (fmb_sparse_vector){index, value, list->size, capacity, list->mixed};
    return FMB_OK;
}

fmb_status fmb_evidence_push(fmb_evidence *e, fmb_sparse_vector *list, size_t index,
                             const mpq_t value)
{
    if (mpq_sgn(value) == 0)
        return FMB_OK;
    FMB_TRY(list->size == list->capacity ? grow_list(&e->mem, list) : FMB_OK);
    if (!fmb_mem_charge(&e->mem, limb_bytes(value)))
        return fmb_mem_status(&e->mem);
    list->mixed = list->mixed || (list->size > 0 && list->index[list->size - 1] > index);
    list->index[list->size] = index;
    mpq_init(list->value[list->size]);
    mpq_set(list->value[list->size++], value);
    return FMB_OK;
}

fmb_status fmb_evidence_push_all(fmb_evidence *e, fmb_sparse_vector *list, size_t n, const int *at,
                                 mpq_t *x)
{
    for (size_t j = 0; j < n; j++)
        FMB_TRY(fmb_evidence_push(e, list, at ? (size_t)at[j] : j, x[j]));
    return FMB_OK;
}

fmb_status fmb_evidence_scale(fmb_evidence *e, fmb_sparse_vector *list, const mpq_t factor)
{
    fmb_status st = FMB_OK;
    mpq_t product;
    mpq_init(product);
    for (size_t k = 0; st == FMB_OK && k < list->size; k++) {
        mpq_mul(product, list->value[k], factor);
        if (!fmb_mem_charge(&e->mem, limb_bytes(product))) {
            st = fmb_mem_status(&e->mem);
            break;
        }
        fmb_mem_refund(&e->mem, limb_bytes(list->value[k]));
        mpq_set(list->value[k], product);
    }
    mpq_clear(product);
    return st;
}

static void swap_entries(fmb_sparse_vector *list, size_t a, size_t b)
{
    size_t index = list->index[a];
    list->index[a] = list->index[b];
    list->index[b] = index;
    mpq_swap(list->value[a], list->value[b]);
}

/* Move entry k down in a heap of that size, with the largest index at the top. */
static void restore_heap(fmb_sparse_vector *list, size_t k, size_t size)
{
    for (size_t child; (child = 2 * k + 1) < size; k = child) {
        child += child + 1 < size && list->index[child + 1] > list->index[child];
        if (list->index[k] >= list->index[child])
            return;
        swap_entries(list, k, child);
    }
}

void fmb_sparse_sort(fmb_sparse_vector *list)
{
    size_t size = list->mixed ? list->size : 0;
    for (size_t k = size / 2; k-- > 0;)
        restore_heap(list, k, size);
    for (; size > 1; size--) {
        swap_entries(list, 0, size - 1);
        restore_heap(list, 0, size - 1);
    }
    list->mixed = false;
}

/* By binary search if the indices increase. */
mpq_srcptr fmb_sparse_find(const fmb_sparse_vector *list, size_t index)
{
    size_t low = 0, high = list->size;
    while (!list->mixed && high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(list->index[middle] <= index ? &low : &high) = middle;
    }
    for (; low < high; low++)
        if (list->index[low] == index)
            return list->value[low];
    return NULL;
}

/* ---- claims ---------------------------------------------------------------------------------- */

/* Charge the limbs of the last claim's value, which has been filled in. */
static fmb_status weigh_last_value(fmb_evidence *e)
{
    fmb_claim *c = e->claims > 0 ? &e->claim[e->claims - 1] : NULL;
    size_t bytes = c ? limb_bytes(c->value) : 0;
    if (!c || bytes <= c->value_bytes)
        return FMB_OK;
    if (!fmb_mem_charge(&e->mem, bytes - c->value_bytes))
        return fmb_mem_status(&e->mem);
    c->value_bytes = bytes;
    return FMB_OK;
}

fmb_status fmb_evidence_claim(fmb_evidence *e, fmb_claim_kind kind, fmb_claim **out)
{
    FMB_TRY(weigh_last_value(e));
    FMB_TRY(FMB_RESERVE(&e->mem, &e->claim, &e->claim_capacity, e->claims + 1));
    fmb_claim *c = &e->claim[e->claims++];
    *c = (fmb_claim){.kind = kind, .row = SIZE_MAX, .var = -1};
    mpq_init(c->value);
    *out = c;
    return FMB_OK;
}

void fmb_evidence_drop_last(fmb_evidence *e)
{
    fmb_claim *c = &e->claim[--e->claims];
    fmb_mem_refund(&e->mem, c->value_bytes);
    mpq_clear(c->value);
    clear_list(&e->mem, &c->terms);
    clear_list(&e->mem, &c->multipliers);
    clear_list(&e->mem, &c->reverse);
    clear_list(&e->mem, &c->point);
    clear_list(&e->mem, &c->ray);
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
    fmb_evidence *e;
    FMB_TRY(FMB_GET_ZERO(&mem, e, 1));
    e->mem = mem;
    atomic_init(&e->holders, 1);
    e->dim = dim;
    e->rows = rows;
    *out = e;
    return FMB_OK;
}

fmb_evidence *fmb_evidence_share(fmb_evidence *e)
{
    atomic_fetch_add_explicit(&e->holders, 1, memory_order_relaxed);
    return e;
}

void fmb_evidence_free(fmb_evidence *e)
{
    if (!e || atomic_fetch_sub_explicit(&e->holders, 1, memory_order_acq_rel) > 1)
        return;
    fmb_evidence_reset(e);
    fmb_mem_put(&e->mem, e->claim, e->claim_capacity, sizeof *e->claim);
    fmb_mem mem = e->mem;
    fmb_mem_put(&mem, e, 1, sizeof *e);
}

/* ---- accessors ------------------------------------------------------------------------------- */

/* Claim i, or a claim without numbers if there is none. */
static const fmb_claim *claim_at(const fmb_evidence *e, size_t i)
{
    static const fmb_claim none = {.row = SIZE_MAX, .var = -1};
    return i < fmb_evidence_claims(e) ? &e->claim[i] : &none;
}

size_t fmb_evidence_claims(const fmb_evidence *e)
{
    return e ? e->claims : 0;
}

fmb_claim_kind fmb_evidence_kind(const fmb_evidence *e, size_t i)
{
    return claim_at(e, i)->kind;
}

size_t fmb_evidence_row(const fmb_evidence *e, size_t i)
{
    return claim_at(e, i)->row;
}

int fmb_evidence_var(const fmb_evidence *e, size_t i)
{
    return claim_at(e, i)->var;
}

fmb_side fmb_evidence_side(const fmb_evidence *e, size_t i)
{
    return claim_at(e, i)->side;
}

fmb_rel fmb_evidence_rel(const fmb_evidence *e, size_t i)
{
    return claim_at(e, i)->rel;
}

void fmb_evidence_multiplier_q(const fmb_evidence *e, size_t i, size_t r, mpq_t out)
{
    fmb_rational_give(fmb_sparse_find(&claim_at(e, i)->multipliers, r), out);
}

void fmb_evidence_coordinate_q(const fmb_evidence *e, size_t i, int j, mpq_t out)
{
    fmb_rational_give(fmb_sparse_find(&claim_at(e, i)->point, (size_t)j), out);
}

void fmb_evidence_ray_q(const fmb_evidence *e, size_t i, int j, mpq_t out)
{
    fmb_rational_give(fmb_sparse_find(&claim_at(e, i)->ray, (size_t)j), out);
}

/* The value of claim i; NULL: there is no such claim. */
static mpq_srcptr value_of_claim(const fmb_evidence *e, size_t i)
{
    return i < fmb_evidence_claims(e) ? e->claim[i].value : NULL;
}

void fmb_evidence_value_q(const fmb_evidence *e, size_t i, mpq_t out)
{
    fmb_rational_give(value_of_claim(e, i), out);
}

size_t fmb_evidence_terms(const fmb_evidence *e, size_t i)
{
    return claim_at(e, i)->terms.size;
}

int fmb_evidence_term_q(const fmb_evidence *e, size_t i, size_t k, mpq_t coef)
{
    const fmb_sparse_vector *terms = &claim_at(e, i)->terms;
    bool there = k < terms->size;
    fmb_rational_give(there ? terms->value[k] : NULL, coef);
    return there ? (int)terms->index[k] : -1;
}

double fmb_evidence_multiplier(const fmb_evidence *e, size_t i, size_t r)
{
    return fmb_nearest_double(fmb_sparse_find(&claim_at(e, i)->multipliers, r));
}

size_t fmb_evidence_next_row(const fmb_evidence *e, size_t i, size_t r)
{
    const fmb_sparse_vector *list = &claim_at(e, i)->multipliers;
    size_t low = 0, high = list->size, next = SIZE_MAX;
    while (!list->mixed && high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(list->index[middle] <= r ? &low : &high) = middle;
    }
    for (high = list->size; low < high && (list->mixed || next == SIZE_MAX); low++)
        if (list->index[low] >= r && list->index[low] < next && mpq_sgn(list->value[low]) != 0)
            next = list->index[low];
    return next;
}

double fmb_evidence_coordinate(const fmb_evidence *e, size_t i, int j)
{
    return fmb_nearest_double(fmb_sparse_find(&claim_at(e, i)->point, (size_t)j));
}

double fmb_evidence_ray(const fmb_evidence *e, size_t i, int j)
{
    return fmb_nearest_double(fmb_sparse_find(&claim_at(e, i)->ray, (size_t)j));
}

double fmb_evidence_value(const fmb_evidence *e, size_t i)
{
    return fmb_nearest_double(value_of_claim(e, i));
}

int fmb_evidence_term(const fmb_evidence *e, size_t i, size_t k, double *coef)
{
    const fmb_sparse_vector *terms = &claim_at(e, i)->terms;
    bool there = k < terms->size;
    if (coef)
        *coef = there ? fmb_nearest_double(terms->value[k]) : 0;
    return there ? (int)terms->index[k] : -1;
}

/* ---- as text --------------------------------------------------------------------------------- */

size_t fmb_evidence_multiplier_text(const fmb_evidence *e, size_t i, size_t r, char *text,
                                    size_t size)
{
    return fmb_rational_print(fmb_sparse_find(&claim_at(e, i)->multipliers, r), text, size);
}

size_t fmb_evidence_coordinate_text(const fmb_evidence *e, size_t i, int j, char *text, size_t size)
{
    return fmb_rational_print(fmb_sparse_find(&claim_at(e, i)->point, (size_t)j), text, size);
}

size_t fmb_evidence_ray_text(const fmb_evidence *e, size_t i, int j, char *text, size_t size)
{
    return fmb_rational_print(fmb_sparse_find(&claim_at(e, i)->ray, (size_t)j), text, size);
}

size_t fmb_evidence_value_text(const fmb_evidence *e, size_t i, char *text, size_t size)
{
    return fmb_rational_print(value_of_claim(e, i), text, size);
}

size_t fmb_evidence_term_text(const fmb_evidence *e, size_t i, size_t k, char *text, size_t size)
{
    const fmb_sparse_vector *terms = &claim_at(e, i)->terms;
    return fmb_rational_print(k < terms->size ? terms->value[k] : NULL, text, size);
}
