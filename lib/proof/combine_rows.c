/* combine_rows.c: see combine_rows.h; part of the trusted base, as check.c is. */
#include "proof/combine_rows.h"

/* Weights, and the products of entries with them, being collected. */
typedef struct combination {
    fmb_fractions w;
    size_t weights;
    fmb_product *product; /* [room] */
    size_t products, room;
    size_t right; /* the column of right sides, behind those of all variables */
} combination;

static fmb_status open_combination(combination *b, size_t weights, size_t room, size_t dim,
                                   fmb_mem *mem, const fmb_poll *poll)
{
    *b = (combination){.room = room, .right = dim};
    FMB_TRY(fmb_fractions_init(&b->w, weights, mem, poll));
    if (!(b->product = fmb_mem_get(mem, room, sizeof *b->product)))
        FMB_TRY(fmb_mem_status(mem));
    return FMB_OK;
}

static void close_combination(combination *b)
{
    fmb_mem_put(b->w.mem, b->product, b->room, sizeof *b->product);
    fmb_fractions_clear(&b->w);
}

/* Append a weight num / den, in lowest terms or not. */
static void put_weight(combination *b, mpz_srcptr num, mpz_srcptr den)
{
    mpz_set(b->w.num.z[b->weights], num);
    mpz_set(b->w.den.z[b->weights++], den);
}

/* Append the product of that weight with entry k of val, or with 1, in a column. */
static void put_product(combination *b, size_t column, const fmb_vec *val, size_t k)
{
    b->product[b->products++] =
        (fmb_product){.column = column, .val = val, .k = k, .weight = b->weights - 1};
}

/* Append a row, which is (val / den), times a weight. */
static void put_row(combination *b, const fmb_sysrow *row, mpz_srcptr num, mpz_srcptr den)
{
    mpz_t common, rest;
    mpz_inits(common, rest, NULL);
    fmb_vec_get(&row->val, row->nnz + 1, rest);
    mpz_gcd(common, num, rest);
    mpz_divexact(rest, rest, common);
    mpz_ptr to_num = b->w.num.z[b->weights], to_den = b->w.den.z[b->weights];
    mpz_divexact(to_num, num, common);
    mpz_mul(to_den, den, rest);
    b->weights++;
    mpz_clears(common, rest, NULL);
    for (size_t k = 0; k < row->nnz; k++)
        put_product(b, (size_t)row->var[k], &row->val, k);
    put_product(b, b->right, &row->val, row->nnz);
}

/* Append minus sign times the goal. */
static void put_goal(combination *b, const fmb_system *s, const fmb_combination_goal *goal)
{
    const fmb_claim *q = goal->claim;
    mpz_t factor, one;
    mpz_init_set_si(factor, -goal->sign);
    mpz_init_set_ui(one, 1);
    if (q && q->var >= 0) {
        put_weight(b, factor, one);
        put_product(b, (size_t)q->var, NULL, 0);
    }
    for (size_t k = 0; q && k <= q->terms.size; k++) {
        mpq_srcptr value = k < q->terms.size ? q->terms.value[k] : q->value;
        mpz_mul(factor, mpq_numref(value), one);
        if (goal->sign > 0)
            mpz_neg(factor, factor);
        put_weight(b, factor, mpq_denref(value));
        put_product(b, k < q->terms.size ? q->terms.index[k] : b->right, NULL, 0);
    }
    if (!q && goal->row != SIZE_MAX)
        put_row(b, fmb_system_row(s, goal->row), factor, one);
    mpz_clears(factor, one, NULL);
}

/* Compute the sum of each column. */
static fmb_status read_columns(combination *b, int *wrong, int *right)
{
    fmb_status st = fmb_fractions_share(&b->w);
    for (size_t k = 0; st == FMB_OK && k < b->products; k++)
        b->product[k].group = b->w.group[b->product[k].weight];
    if (st == FMB_OK)
        fmb_products_sort(b->product, b->products);
    *wrong = -1;
    *right = 0;
    size_t next;
    for (size_t k = 0; st == FMB_OK && k < b->products; k = next) {
        size_t column = b->product[k].column;
        int sign = 0;
        for (next = k + 1; next < b->products && b->product[next].column == column;)
            next++;
        st = fmb_products_sign(&b->w, b->product + k, next - k, &sign);
        if (column == b->right)
            *right = sign;
        else if (sign != 0 && *wrong < 0)
            *wrong = (int)column;
    }
    return st;
}

fmb_status fmb_combine_rows(const fmb_system *s, const fmb_sparse_vector *multipliers,
                            const fmb_combination_goal *goal, fmb_mem *mem, const fmb_poll *poll,
                            int *wrong, int *right)
{
    combination b;
    size_t form = goal->claim ? goal->claim->terms.size + 2 : 1, entries = form;
    if (!goal->claim && goal->row != SIZE_MAX)
        entries += fmb_system_row(s, goal->row)->nnz;
    for (size_t k = 0; k < multipliers->size; k++)
        entries += fmb_system_row(s, multipliers->index[k])->nnz + 1;
    fmb_status st =
        open_combination(&b, multipliers->size + form, entries, (size_t)s->names.size, mem, poll);
    for (size_t k = 0; st == FMB_OK && k < multipliers->size; k++) {
        mpq_srcptr m = multipliers->value[k];
        put_row(&b, fmb_system_row(s, multipliers->index[k]), mpq_numref(m), mpq_denref(m));
        st = fmb_poll_ask(poll);
    }
    if (st == FMB_OK) {
        put_goal(&b, s, goal);
        for (; b.weights < b.w.size; b.weights++)
            mpz_set_ui(b.w.den.z[b.weights], 1);
        st = read_columns(&b, wrong, right);
    }
    close_combination(&b);
    return st;
}

/* ---- points ---------------------------------------------------------------------------------- */

fmb_status fmb_place_init(fmb_place *p, size_t dim, fmb_mem *mem)
{
    *p = (fmb_place){.of = fmb_mem_zero(mem, dim, sizeof *p->of), .dim = dim};
    return p->of ? FMB_OK : fmb_mem_status(mem);
}

void fmb_place_clear(fmb_place *p, fmb_mem *mem)
{
    fmb_mem_put(mem, p->product, p->capacity, sizeof *p->product);
    fmb_mem_put(mem, p->of, p->dim, sizeof *p->of);
}

fmb_status fmb_place_put(fmb_place *p, const fmb_sparse_vector *x, bool direction, fmb_mem *mem,
                         const fmb_poll *poll)
{
    fmb_status st = fmb_fractions_init(&p->x, x->size + 1, mem, poll);
    for (size_t k = 0; k < x->size; k++)
        p->of[x->index[k]] = k + 1;
    if (st != FMB_OK)
        return st;
    for (size_t k = 0; k < x->size; k++) {
        mpz_set(p->x.num.z[k], mpq_numref(x->value[k]));
        mpz_set(p->x.den.z[k], mpq_denref(x->value[k]));
    }
    mpz_set_si(p->x.num.z[x->size], direction ? 0 : -1);
    mpz_set_ui(p->x.den.z[x->size], 1);
    return fmb_fractions_share(&p->x);
}

void fmb_place_take(fmb_place *p, const fmb_sparse_vector *x)
{
    for (size_t k = 0; k < x->size; k++)
        p->of[x->index[k]] = 0;
    fmb_fractions_clear(&p->x);
}

fmb_status fmb_place_side(fmb_place *p, const fmb_sysrow *row, int *side)
{
    const fmb_fractions *x = &p->x;
    size_t n = 0;
    bool sorted = true;
    fmb_status st = FMB_RESERVE(x->mem, &p->product, &p->capacity, row->nnz + 1);
    for (size_t k = 0; st == FMB_OK && k <= row->nnz; k++) {
        size_t of = k < row->nnz ? p->of[row->var[k]] : x->size;
        if (of == 0)
            continue;
        p->product[n] =
            (fmb_product){.group = x->group[of - 1], .val = &row->val, .k = k, .weight = of - 1};
        sorted = sorted && (n == 0 || p->product[n - 1].group <= p->product[n].group);
        n++;
    }
    if (!sorted)
        fmb_products_sort(p->product, n);
    return st == FMB_OK ? fmb_products_sign(x, p->product, n, side) : st;
}

fmb_status fmb_form_sign(const fmb_claim *q, const fmb_sparse_vector *x, mpq_srcptr value,
                         fmb_mem *mem, const fmb_poll *poll, int *sign)
{
    combination b;
    size_t n = q->terms.size + 2;
    fmb_status st = open_combination(&b, n, n, 0, mem, poll);
    if (st != FMB_OK) {
        close_combination(&b);
        return st;
    }
    mpz_t num, den;
    mpz_inits(num, den, NULL);
    mpq_srcptr at = q->var >= 0 ? fmb_sparse_find(x, (size_t)q->var) : NULL;
    if (at)
        put_weight(&b, mpq_numref(at), mpq_denref(at));
    for (size_t k = 0; k < q->terms.size; k++) {
        if (!(at = fmb_sparse_find(x, q->terms.index[k])))
            continue;
        mpz_mul(num, mpq_numref(at), mpq_numref(q->terms.value[k]));
        mpz_mul(den, mpq_denref(at), mpq_denref(q->terms.value[k]));
        put_weight(&b, num, den);
    }
    if (value) {
        mpz_neg(num, mpq_numref(value));
        put_weight(&b, num, mpq_denref(value));
    }
    mpz_clears(num, den, NULL);
    for (size_t k = b.weights; k < n; k++)
        mpz_set_ui(b.w.den.z[k], 1);
    for (size_t k = 0; k < b.weights; k++)
        b.product[b.products++] = (fmb_product){.weight = k};
    int none;
    st = read_columns(&b, &none, sign);
    close_combination(&b);
    return st;
}
