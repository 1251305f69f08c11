/* rounded_proof.c: see rounded_proof.h. */
#include "lp/redundancy/active_set/rounded_proof.h"

#include <math.h>

#include "base/arrays.h"
#include "num/gcd.h"

/* Denominators of multipliers, and of all of them together. */
#define MOST_ONE 4096
#define MOST_ALL ((int64_t)1 << 31)

static fmb_status hold_arrays_of_proof(fmb_rounded_proof *c, fmb_mem *mem, bool get)
{
    return FMB_ARRAYS_IN_BLOCK(mem, get, FMB_ARRAY(c->index, c->room), FMB_ARRAY(c->part, c->room),
                               FMB_ARRAY(c->unit, c->room));
}

fmb_status fmb_rounded_proof_init(fmb_rounded_proof *c, fmb_mem *mem, size_t room)
{
    *c = (fmb_rounded_proof){.room = room};
    return hold_arrays_of_proof(c, mem, true);
}

void fmb_rounded_proof_clear(fmb_rounded_proof *c, fmb_mem *mem)
{
    (void)hold_arrays_of_proof(c, mem, false);
}

void fmb_rounded_proof_begin(fmb_rounded_proof *c)
{
    c->size = 0;
    c->all = 1;
}

/* The fraction p / q, q <= MOST_ONE, next to v by continued fractions; false if none is near. */
static bool find_simple_fraction(double v, int64_t *p, int64_t *q)
{
    int64_t p0 = 0, q0 = 1, p1 = 1, q1 = 0;
    double rest = fabs(v), size = 1e-7 * (1 + rest);
    if (!(rest < 1e6))
        return false;
    for (;;) {
        double whole = floor(rest + 1e-9);
        int64_t a = (int64_t)whole, p2 = a * p1 + p0, q2 = a * q1 + q0;
        if (q2 > MOST_ONE || p2 >= MOST_ALL)
            return false;
        p0 = p1, q0 = q1, p1 = p2, q1 = q2;
        if (fabs((double)p1 / (double)q1 - fabs(v)) <= size)
            break;
        rest = 1 / (rest - whole);
    }
    *p = v < 0 ? -p1 : p1;
    *q = q1;
    return true;
}

bool fmb_rounded_proof_add(fmb_rounded_proof *c, size_t row, double multiplier)
{
    if (!find_simple_fraction(multiplier, &c->part[c->size], &c->unit[c->size]))
        return false;
    int64_t unit = c->unit[c->size];
    c->index[c->size++] = row;
    c->all *= unit / (int64_t)fmb_gcd64((uint64_t)c->all, (uint64_t)unit);
    return c->all < MOST_ALL;
}

/* Over one denominator; false if the parts become long. */
static bool write_parts_over_all(fmb_rounded_proof *c)
{
    for (size_t k = 0; k < c->size; k++)
        if (__builtin_mul_overflow(c->part[k], c->all / c->unit[k], &c->part[k]) ||
            fmb_bits64(fmb_abs64(c->part[k])) > 54)
            return false;
    return true;
}

/* all (row i) - sum part_k row_k, at entry j. Fewer than 2^8 products of 54 + 62 bits. */
static fmb_i128 difference_at_entry(const fmb_rounded_proof *c, const fmb_lp_row *row, size_t i,
                                    size_t j)
{
    fmb_i128 sum = fmb_i128_product(c->all, row[i].v->s[j]);
    for (size_t k = 0; k < c->size; k++)
        sum = fmb_i128_minus_product(sum, c->part[k], row[c->index[k]].v->s[j]);
    return sum;
}

/* A strict row needs a smaller right side, or a strict row among the parts. */
bool fmb_rounded_proof_holds(fmb_rounded_proof *c, size_t n, const fmb_lp_row *row, size_t i)
{
    bool strict = false;
    if (!write_parts_over_all(c))
        return false;
    for (size_t k = 0; k < c->size; k++) {
        if (c->part[k] < 0 && row[c->index[k]].rel != FMB_EQ)
            return false;
        strict |= row[c->index[k]].rel == FMB_LT && c->part[k] > 0;
    }
    for (size_t j = 0; j < n; j++)
        if (fmb_i128_sign(difference_at_entry(c, row, i, j)) != 0)
            return false;
    int slack = fmb_i128_sign(difference_at_entry(c, row, i, n));
    return slack > 0 || (slack == 0 && (strict || row[i].rel != FMB_LT));
}
