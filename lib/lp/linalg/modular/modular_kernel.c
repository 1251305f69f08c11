/* modular_kernel.c: elimination modulo a prime, with one inverse; see modular_kernel.h. */
#include "lp/linalg/modular/modular_kernel.h"

#include <string.h>

#include "num/gcd.h"

fmb_status fmb_modular_kernel_init(fmb_modular_kernel *h, fmb_mem *mem, size_t n)
{
    *h = (fmb_modular_kernel){.n = n, .q = fmb_prime_number(0)};
    h->a = fmb_mem_get(mem, n * (n + 2), sizeof *h->a);
    h->row = fmb_mem_get(mem, n, sizeof *h->row);
    h->column = fmb_mem_get(mem, n, sizeof *h->column);
    h->w = fmb_mem_get(mem, n + 1, sizeof *h->w);
    h->inverse = fmb_mem_get(mem, n + 1, sizeof *h->inverse);
    h->v = fmb_mem_get(mem, n + 1, sizeof *h->v);
    bool all = h->a && h->row && h->column && h->w && h->inverse && h->v;
    return all ? FMB_OK : fmb_mem_status(mem);
}

void fmb_modular_kernel_clear(fmb_modular_kernel *h, fmb_mem *mem)
{
    size_t n = h->n;
    fmb_mem_put(mem, h->a, n * (n + 2), sizeof *h->a);
    fmb_mem_put(mem, h->row, n, sizeof *h->row);
    fmb_mem_put(mem, h->column, n, sizeof *h->column);
    fmb_mem_put(mem, h->w, n + 1, sizeof *h->w);
    fmb_mem_put(mem, h->inverse, n + 1, sizeof *h->inverse);
    fmb_mem_put(mem, h->v, n + 1, sizeof *h->v);
}

void fmb_modular_kernel_zero(fmb_modular_kernel *h, size_t columns)
{
    h->columns = columns;
    memset(h->a, 0, h->n * (h->n + 2) * sizeof *h->a);
}

/* ---- elimination ----------------------------------------------------------------------------- */

/* Bring a row with an entry in column c to place r. */
static bool find_pivot_of_column(fmb_modular_kernel *h, size_t r, size_t c)
{
    size_t i = r;
    while (i < h->n && h->row[i][c] == 0)
        i++;
    if (i == h->n)
        return false;
    uint64_t *t = h->row[i];
    h->row[i] = h->row[r];
    h->row[r] = t;
    h->column[r] = c;
    return true;
}

/* Rows below r become 0 in column c, by combinations. */
static void clear_below_pivot(fmb_modular_kernel *h, size_t r, size_t c)
{
    const uint64_t *top = h->row[r];
    for (size_t i = r + 1; i < h->n; i++) {
        uint64_t *row = h->row[i], minus = h->q.p - row[c];
        if (row[c] == 0)
            continue;
        for (size_t j = c + 1; j < h->columns; j++)
            row[j] = fmb_prime_fold(
                &h->q, fmb_u128_plus_product(fmb_u128_product(top[c], row[j]), minus, top[j]));
        row[h->n + 1] = fmb_prime_times(&h->q, row[h->n + 1], top[c]);
    }
}

/* The rows become triangular; *free is the one column without a pivot. */
static bool make_triangular(fmb_modular_kernel *h, size_t *free)
{
    size_t r = 0;
    *free = SIZE_MAX;
    for (size_t i = 0; i < h->n; i++) {
        h->row[i] = h->a + i * (h->n + 2);
        h->row[i][h->n + 1] = 1;
    }
    for (size_t c = 0; c < h->columns; c++) {
        if (find_pivot_of_column(h, r, c))
            clear_below_pivot(h, r++, c);
        else if (*free == SIZE_MAX)
            *free = c;
        else
            return false;
    }
    return *free != SIZE_MAX;
}

/* The inverses of the pivots, by one of their product times `scale`, by which their rows have been
 * multiplied; and the determinant of their rows and columns, which is that product over `scale`, up
 * to its sign. */
static uint64_t invert_pivots(fmb_modular_kernel *h)
{
    uint64_t product = 1, scale = 1;
    for (size_t r = 0; r + 1 < h->columns; r++) {
        scale = fmb_prime_times(&h->q, scale, h->row[r][h->n + 1]);
        h->inverse[r] = product;
        product = fmb_prime_times(&h->q, product, h->row[r][h->column[r]]);
    }
    uint64_t all = fmb_prime_inverse(&h->q, fmb_prime_times(&h->q, product, scale));
    uint64_t left = fmb_prime_times(&h->q, all, scale);
    uint64_t over_scale = fmb_prime_times(&h->q, all, product);
    for (size_t r = h->columns - 1; r-- > 0;) {
        h->inverse[r] = fmb_prime_times(&h->q, h->inverse[r], left);
        left = fmb_prime_times(&h->q, left, h->row[r][h->column[r]]);
    }
    return fmb_prime_times(&h->q, product, over_scale);
}

/* ---- the vector ------------------------------------------------------------------------------ */

static void take_least_residues(fmb_modular_kernel *h, uint64_t determinant)
{
    uint64_t g = 0;
    for (size_t j = 0; j < h->columns; j++) {
        uint64_t x = fmb_prime_times(&h->q, h->w[j], determinant);
        h->v[j] = x > h->q.p / 2 ? (int64_t)x - (int64_t)h->q.p : (int64_t)x;
        g = fmb_gcd64(g, fmb_abs64(h->v[j]));
    }
    for (size_t j = 0; g > 1 && j < h->columns; j++)
        h->v[j] /= (int64_t)g;
}

bool fmb_modular_kernel_find(fmb_modular_kernel *h)
{
    size_t free;
    if (!make_triangular(h, &free))
        return false;
    uint64_t determinant = invert_pivots(h);
    memset(h->w, 0, h->columns * sizeof *h->w);
    h->w[free] = 1;
    for (size_t r = h->columns - 1; r-- > 0;) {
        size_t c = h->column[r], after = h->columns - c - 1;
        uint64_t sum = fmb_prime_minus_dot(&h->q, 0, h->row[r] + c + 1, h->w + c + 1, NULL, after);
        h->w[c] = fmb_prime_times(&h->q, sum, h->inverse[r]);
    }
    take_least_residues(h, determinant);
    return true;
}
