/* rank.c: the rank of a small matrix of integers, first modulo a prime, then exactly.
 *
 * The multipliers of a row with history H form a kernel vector of A_{H,O}, transposed: the rank is
 * at most |H| - 1, and equal to it if and only if no other combination uses only rows of H: the row
 * is minimal. The rank modulo a prime is never more than the rank, so |H| - 1 modulo 2^61 - 1 is
 * proof; less is not, and then GMP decides by elimination without fractions. Source: Imbert 1993;
 * Bareiss 1968.
 */
#include "elim/history/history.h"

#include <string.h>

#include "num/prime.h"

/* The rows of the history and the eliminated variables, as lists. */
typedef struct minor {
    size_t *row, *var;
    size_t rows, vars;
} minor;

static size_t list_members(const uint64_t *set, size_t words, size_t *out)
{
    size_t n = 0;
    for (size_t w = 0; w < words; w++)
        for (uint64_t left = set[w]; left != 0; left &= left - 1)
            out[n++] = w * 64 + (size_t)__builtin_ctzll(left);
    return n;
}

/* Gaussian elimination modulo the prime; a[rows][cols] is overwritten. */
static size_t rank_mod_prime(const fmb_prime *q, uint64_t *a, size_t rows, size_t cols)
{
    size_t rank = 0;
    for (size_t c = 0; c < cols && rank < rows; c++) {
        size_t p = rank;
        while (p < rows && a[p * cols + c] == 0)
            p++;
        if (p == rows)
            continue;
        for (size_t j = c; j < cols; j++) {
            uint64_t t = a[p * cols + j];
            a[p * cols + j] = a[rank * cols + j];
            a[rank * cols + j] = t;
        }
        uint64_t scale = fmb_prime_inverse(q, a[rank * cols + c]);
        for (size_t i = rank + 1; i < rows; i++) {
            uint64_t f = fmb_prime_times(q, a[i * cols + c], scale);
            for (size_t j = c; f != 0 && j < cols; j++)
                a[i * cols + j] =
                    fmb_prime_minus(q, a[i * cols + j], fmb_prime_times(q, f, a[rank * cols + j]));
        }
        rank++;
    }
    return rank;
}

/* The same in integers: each new entry is a minor, so the division by the last pivot is exact. */
static size_t rank_by_bareiss(mpz_t *a, size_t rows, size_t cols)
{
    size_t rank = 0;
    mpz_t last, t;
    mpz_inits(last, t, NULL);
    mpz_set_ui(last, 1);
    for (size_t c = 0; c < cols && rank < rows; c++) {
        size_t p = rank;
        while (p < rows && mpz_sgn(a[p * cols + c]) == 0)
            p++;
        if (p == rows)
            continue;
        for (size_t j = 0; j < cols; j++)
            mpz_swap(a[p * cols + j], a[rank * cols + j]);
        mpz_ptr pivot = a[rank * cols + c];
        for (size_t i = rank + 1; i < rows; i++)
            for (size_t j = cols; j-- > c;) {
                mpz_ptr x = a[i * cols + j];
                mpz_mul(x, x, pivot);
                mpz_mul(t, a[i * cols + c], a[rank * cols + j]);
                mpz_sub(x, x, t);
                mpz_divexact(x, x, last);
            }
        mpz_set(last, pivot);
        rank++;
    }
    mpz_clears(last, t, NULL);
    return rank;
}

static fmb_status minor_rank_mod_prime(const fmb_elim *e, const minor *m, size_t *rank)
{
    fmb_mem *mem = e->run->mem;
    fmb_prime q = fmb_prime_number(0);
    uint64_t *a;
    FMB_TRY(FMB_GET(mem, a, m->rows * m->vars));
    for (size_t i = 0; i < m->rows; i++)
        for (size_t j = 0; j < m->vars; j++)
            a[i * m->vars + j] = fmb_prime_of_entry(&q, &e->row[e->base[m->row[i]]].v, m->var[j]);
    *rank = rank_mod_prime(&q, a, m->rows, m->vars);
    fmb_mem_put(mem, a, m->rows * m->vars, sizeof *a);
    return FMB_OK;
}

static fmb_status minor_rank_exactly(const fmb_elim *e, const minor *m, size_t *rank)
{
    fmb_mem *mem = e->run->mem;
    size_t size = m->rows * m->vars;
    mpz_t *a = fmb_vec_block(size, mem);
    if (!a)
        return fmb_mem_status(mem);
    for (size_t k = 0; k < size; k++)
        fmb_vec_get(&e->row[e->base[m->row[k / m->vars]]].v, m->var[k % m->vars], a[k]);
    *rank = rank_by_bareiss(a, m->rows, m->vars);
    fmb_vec_block_free(a, size, mem);
    return FMB_OK;
}

fmb_status fmb_elim_minimal(const fmb_elim *e, const fmb_derived *r, bool *minimal)
{
    fmb_mem *mem = e->run->mem;
    size_t room = 64 * (e->words + e->var_words), rank = 0;
    size_t *list;
    FMB_TRY(FMB_GET(mem, list, room));
    minor m = {.row = list, .var = list + 64 * e->words};
    m.rows = list_members(r->history, e->words, m.row);
    m.vars = list_members(e->gone, e->var_words, m.var);
    fmb_status st = minor_rank_mod_prime(e, &m, &rank);
    if (st == FMB_OK && rank + 1 < m.rows)
        st = minor_rank_exactly(e, &m, &rank);
    if (st == FMB_OK)
        *minimal = rank + 1 >= m.rows;
    fmb_mem_put(mem, list, room, sizeof *list);
    return st;
}
