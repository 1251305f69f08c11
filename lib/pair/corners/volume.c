/* volume.c: see volume.h.
 *
 * An expansion is a sum of doubles, not 0, that do not overlap, from the smallest on: its sign is
 * that of the last one. The empty expansion is 0.
 */
#include "pair/corners/volume.h"

#include <math.h>

bool fmb_is_tame(double x)
{
    return x == 0 || (fabs(x) >= 0x1p-200 && fabs(x) <= 0x1p200);
}

/* ---- sums and products without an error ------------------------------------------------------ */

/* a + b = *sum + what is returned (Knuth) */
static double error_of_sum(double a, double b, double *sum)
{
    double s = a + b, of_b = s - a, of_a = s - of_b;
    *sum = s;
    return (a - of_a) + (b - of_b);
}

/* The upper 26 bits of a (Veltkamp). */
static double upper_bits(double a)
{
    double c = (0x1p27 + 1) * a, low = c - a;
    return c - low;
}

/* ab = *product + what is returned (Dekker) */
static double error_of_product(double a, double b, double *product)
{
    double p = a * b, ah = upper_bits(a), bh = upper_bits(b), al = a - ah, bl = b - bh;
    *product = p;
    return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}

/* ---- expansions ------------------------------------------------------------------------------ */

/* Append x, unless it is 0. */
static int append_component(double *h, int n, double x)
{
    h[n] = x;
    return n + (x != 0);
}

/* h = e + f, n + m components at most (Shewchuk, "fast expansion sum"). */
static int add_expansions(const double *e, int n, const double *f, int m, double *h)
{
    int i = 0, j = 0, k = 0;
    double q = 0;
    while (i < n || j < m) {
        bool from_e = j == m || (i < n && fabs(e[i]) < fabs(f[j]));
        double error = error_of_sum(q, from_e ? e[i++] : f[j++], &q);
        k = append_component(h, k, error);
    }
    return append_component(h, k, q);
}

/* h = b e, 2 n components at most (Shewchuk, "scale expansion"). */
static int scale_expansion(const double *e, int n, double b, double *h)
{
    int k = 0;
    double q = 0;
    for (int i = 0; i < n; i++) {
        double product, low = error_of_product(e[i], b, &product);
        k = append_component(h, k, error_of_sum(q, low, &q));
        k = append_component(h, k, error_of_sum(product, q, &q));
    }
    return append_component(h, k, q);
}

enum { LINEAR = 2, QUADRATIC = 2 * LINEAR * LINEAR, CUBIC = 2 * LINEAR * QUADRATIC * 2 };

/* h = e (hi + lo), where the second factor has at most two components; scratch: as long as h. */
static int multiply_by_difference(const double *e, int n, const double *f, int m, double *scratch,
                                  double *h)
{
    if (m == 0)
        return 0;
    if (m == 1)
        return scale_expansion(e, n, f[0], h);
    double *upper = scratch + 2 * n;
    int low = scale_expansion(e, n, f[0], scratch), high = scale_expansion(e, n, f[1], upper);
    return add_expansions(scratch, low, upper, high, h);
}

/* One coordinate of a difference, exactly: at most two components. */
typedef struct linear {
    double c[LINEAR];
    int n;
} linear;

static linear exact_coordinate(fmb_difference u, int j)
{
    linear out = {.n = 0};
    double difference, error = error_of_sum(u.to[j], -u.from[j], &difference);
    out.n = append_component(out.c, out.n, error);
    if (difference != 0)
        out.c[out.n++] = difference;
    return out;
}

/* u_0 (v_i w_j - v_j w_i) */
static int exact_part(linear u, const linear v[2], const linear w[2], double h[CUBIC])
{
    double scratch[CUBIC], left[QUADRATIC], right[QUADRATIC], minor[2 * QUADRATIC];
    int l = multiply_by_difference(v[0].c, v[0].n, w[1].c, w[1].n, scratch, left);
    int r = multiply_by_difference(v[1].c, v[1].n, w[0].c, w[0].n, scratch, right);
    for (int i = 0; i < r; i++)
        right[i] = -right[i];
    int n = add_expansions(left, l, right, r, minor);
    return multiply_by_difference(minor, n, u.c, u.n, scratch, h);
}

static int exact_sign(fmb_difference u, fmb_difference v, fmb_difference w)
{
    double part[CUBIC], sum[2][3 * CUBIC];
    int n = 0;
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        linear vs[2] = {exact_coordinate(v, i), exact_coordinate(v, j)};
        linear ws[2] = {exact_coordinate(w, i), exact_coordinate(w, j)};
        int m = exact_part(exact_coordinate(u, k), vs, ws, part);
        n = add_expansions(sum[k & 1], n, part, m, sum[(k + 1) & 1]);
    }
    double top = n > 0 ? sum[1][n - 1] : 0;
    return (top > 0) - (top < 0);
}

/* ---- both ------------------------------------------------------------------------------------ */

/* The error is at most (7 + 56 e) e times the same sum of absolute values, e = 2^-53 (Shewchuk,
 * "the 3D orientation test", whose proof asks nothing of the differences but that each is rounded).
 */
int fmb_sign_of_determinant(fmb_difference u, fmb_difference v, fmb_difference w)
{
    double a[3], b[3], c[3], det = 0, sum = 0;
    for (int j = 0; j < 3; j++) {
        a[j] = u.to[j] - u.from[j];
        b[j] = v.to[j] - v.from[j];
        c[j] = w.to[j] - w.from[j];
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        double left = b[i] * c[j], right = b[j] * c[i];
        det += a[k] * (left - right);
        sum += fabs(a[k]) * (fabs(left) + fabs(right));
    }
    if (fabs(det) > 0x1p-50 * sum)
        return det > 0 ? 1 : -1;
    return sum == 0 ? 0 : exact_sign(u, v, w);
}
