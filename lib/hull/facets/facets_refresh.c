/* facets_refresh.c: the normal of a facet in doubles from the generators on it; see facets.h.
 *
 * The errors of normals computed as combinations of others grow with every generation, until signs
 * are in doubt. Computing them anew from minors of generators, as in facets_normal.c but in
 * doubles, resets these errors.
 *
 * Theorem. Let g be a vector of which some positive multiple has entries within |g_c| 2^-50 +
 * 2^-1073 of x_c, |x_c| <= 1, and let minors of k rows be within e of m. Then a minor of k + 1 rows
 * is within sum_c (e_c + |m_c| (d + 10) 2^-51) |x_c| + LEAST of the computed sum_c +-m_c x_c, with
 * some room. Proof. The sum of at most d products rounds each of them at most d times: that is less
 * than |m_c x_c| (d + 1) 2^-53. The errors of x_c contribute |m_c x_c| (2^-50 + 2^-99), and the
 * minors' own errors e_c |x_c| (1 + 2^-49). Underflow, in products and in x, contributes less than
 * d (d + d!) 2^-1073, as no minor is larger than d!, and thus less than LEAST. The room is for
 * rounding errors of the bound itself, and for 2^-49.
 */
#include <math.h>

#include "hull/facets/facets_private.h"

#define MOST_SETS ((size_t)1 << FMB_FACETS_FEW)
#define ROOM      (1 + 0x1p-40)
#define LEAST     0x1p-900

/* Minors of some rows, by set of columns, with bounds on their errors. */
typedef struct rough_minors {
    size_t d, rows;
    double m[MOST_SETS], e[MOST_SETS];
} rough_minors;

void fmb_facets_scale_down(double *x, size_t d)
{
    double most = 0;
    int exponent;
    for (size_t j = 0; j < d; j++)
        most = fmax(most, fabs(x[j]));
    frexp(most, &exponent);
    for (size_t j = 0; j < d; j++)
        x[j] = ldexp(x[j], -exponent);
}

static void expand_rough_minor(rough_minors *a, uint32_t set, const double *x)
{
    double sum = 0, off = 0, unit = (double)(a->d + 10) * 0x1p-51;
    for (uint32_t left = set, sign = 0; left != 0; sign ^= 1) {
        uint32_t c = 31 - (uint32_t)__builtin_clz(left), bit = (uint32_t)1 << c;
        double m = a->m[set ^ bit];
        sum += sign ? -m * x[c] : m * x[c];
        off += (a->e[set ^ bit] + fabs(m) * unit) * fabs(x[c]);
        left ^= bit;
    }
    a->m[set] = sum;
    a->e[set] = ROOM * off + LEAST;
}

/* Add x as a row if it is certainly independent of the others. */
static void add_rough_row(rough_minors *a, const double *x)
{
    bool sure = false;
    uint32_t set = ((uint32_t)2 << a->rows) - 1;
    for (; set < (uint32_t)1 << a->d; set = fmb_facets_next_set(set)) {
        expand_rough_minor(a, set, x);
        sure |= fabs(a->m[set]) > a->e[set];
    }
    a->rows += sure;
}

/* The sign of the normal on a generator not on the facet, which is inwards; 0: in doubt. */
static int find_direction(const fmb_facets *f, fmb_facet *a)
{
    int side;
    size_t i = fmb_facet_next(a, 0, false);
    if (i >= f->generators || !fmb_facets_guess_side(f, a, f->rounded + i * f->d, &side))
        return 0;
    return side;
}

/* Take the minors as the normal up to its sign, if they are accurate enough. */
static bool take_rough_minors(const fmb_facets *f, const rough_minors *by, fmb_facet *a)
{
    uint32_t all = ((uint32_t)1 << f->d) - 1;
    double most = 0, *r = a->roughly, *e = r + f->d;
    bool lost = false;
    int exponent;
    for (size_t j = 0; j < f->d; j++) {
        uint32_t set = all ^ (uint32_t)1 << j;
        r[j] = j % 2 ? -by->m[set] : by->m[set];
        e[j] = by->e[set];
        most = fmax(most, fabs(r[j]));
    }
    frexp(most, &exponent);
    double scale = ldexp(1, -exponent);
    for (size_t j = 0; j < f->d; j++) {
        r[j] *= scale;
        e[j] = ROOM * ((e[j] + LEAST) * scale + LEAST) + fabs(r[j]) * (double)(f->d + 8) * 0x1p-51;
        lost |= !(e[j] <= 1);
    }
    int side = lost ? 0 : find_direction(f, a);
    for (size_t j = 0; side < 0 && j < f->d; j++)
        r[j] = -r[j];
    if (side == 0)
        e[0] = INFINITY;
    return side != 0;
}

bool fmb_facets_refresh(const fmb_facets *f, fmb_facet *a)
{
    rough_minors by = {.d = f->d};
    if (a->fresh || f->rank < f->d || f->d > FMB_FACETS_FEW)
        return false;
    a->fresh = true;
    by.m[0] = 1;
    for (size_t i = fmb_facet_next(a, 0, true); i < f->generators && by.rows + 1 < f->d;
         i = fmb_facet_next(a, i + 1, true))
        add_rough_row(&by, f->rounded + i * f->d);
    return by.rows + 1 == f->d && take_rough_minors(f, &by, a);
}
