/* low_words.c: see low_words.h. */
#include "pair/exact_box/low_words.h"

#include "num/laplace.h"

#define DIM FMB_EXACT_BOX_DIM

/* ---- entries --------------------------------------------------------------------------------- */

static fmb_u128 low_of(const fmb_wide *a)
{
    fmb_u128 size = fmb_u128_join(a->n > 1 ? a->word[1] : 0, a->n > 0 ? a->word[0] : 0);
    return a->minus ? fmb_u128_minus(fmb_u128_of(0), size) : size;
}

/* A row of P, followed by that of the rest. */
static void list_row(const fmb_exact_box_program *s, const int *basic, const int *reference,
                     const bool *is_one, int row, fmb_u128 *a)
{
    for (int k = 0; k < s->dim; k++) {
        a[k] = low_of(&s->m[basic[k]].whole[row]);
        if (reference[k] >= 0)
            a[k] = fmb_u128_minus(a[k], low_of(&s->m[reference[k]].whole[row]));
    }
    a[s->dim] = low_of(&s->h.whole[row]);
    for (int j = 0; j < s->columns; j++)
        if (is_one[j])
            a[s->dim] = fmb_u128_minus(a[s->dim], low_of(&s->m[j].whole[row]));
}

/* At least |det P|, by Hadamard: the product of the lengths of its columns, each scaled entry being
 * off by less than 2^-50; and what rows are scaled by. Artificial columns are not scaled, and
 * longer here than they should be by as much as their unknowns are less: products of both are
 * bounded. */
static double bound_det(const fmb_exact_box_program *s, const int *basic, const int *reference)
{
    double most = 1 + 0x1p-40;
    int power = 0;
    for (int k = 0; k < s->dim; k++) {
        double square = 0;
        for (int row = 0; row < s->dim; row++) {
            const double less = reference[k] < 0 ? 0 : s->m[reference[k]].near[row];
            const double entry = fabs(s->m[basic[k]].near[row] - less) + 0x1p-50;
            square += entry * entry;
        }
        most *= sqrt(square);
        power += s->scale[k];
    }
    return ldexp(most, power);
}

/* ---- minors ---------------------------------------------------------------------------------- */

/* The rest is the last column; by Cramer's rule it would replace column k for x_k. */
void fmb_exact_box_find_low(const fmb_exact_box_program *s, const int *basic, const int *reference,
                            const bool *is_one, fmb_exact_box_low *out)
{
    fmb_u128 a[DIM + 1], minor[1 << (DIM + 1)];
    const int n = s->dim;
    const unsigned all = (2U << n) - 1;
    minor[0] = fmb_u128_of(1);
    for (int row = 0; row < n; row++) {
        list_row(s, basic, reference, is_one, row, a);
        fmb_words_take_vector(2, n + 1, row, a, minor);
    }
    out->most = bound_det(s, basic, reference);
    out->det = minor[all >> 1];
    for (int k = 0; k < n; k++) {
        out->x[k] = minor[all & ~(1U << k)];
        if ((n - 1 - k) % 2 == 1)
            out->x[k] = fmb_u128_minus(fmb_u128_of(0), out->x[k]);
    }
}
