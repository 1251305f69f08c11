/* insert_value.c: the value of a row at rays that do not carry it, by a dot product; see insert.h.
 */
#include "dd/insert.h"
#include "num/gcd.h"

static fmb_status set_wide_value(const fmb_cone *c, fmb_vec *v, const fmb_vec *row, fmb_num *num)
{
    fmb_status st = fmb_vec_widen(v, c->ray.width, num->mem);
    if (st != FMB_OK)
        return st;
    mpz_ptr sum = v->z[c->coords];
    mpz_set_ui(sum, 0);
    for (size_t k = 0; k < c->coords; k++) {
        fmb_vec_get(row, k, num->t);
        mpz_addmul(sum, num->t, v->z[k]);
    }
    return fmb_vec_settle(v, c->ray.width, num->mem);
}

fmb_status fmb_insertion_set_value(const fmb_cone *c, fmb_vec *v, const fmb_vec *row, fmb_num *num)
{
    int bits = v->bits + row->bits + fmb_bits64(c->coords);
    if (v->z || row->z || bits > 126)
        return set_wide_value(c, v, row, num);
    fmb_i128 sum = fmb_i128_of(0);
    for (size_t k = 0; k < c->coords; k++)
        sum = fmb_i128_plus_product(sum, row->s[k], v->s[k]);
    if (bits > FMB_SMALL_BITS && fmb_u128_bits(fmb_i128_size(sum)) > FMB_SMALL_BITS)
        return set_wide_value(c, v, row, num);
    v->s[c->coords] = fmb_i128_low(sum);
    fmb_vec_measure(v, c->ray.width);
    return FMB_OK;
}
