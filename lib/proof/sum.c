/* sum.c: see sum.h; part of the trusted base, as check.c is. */
#include "proof/sum.h"

#include <stdlib.h>

fmb_status fmb_fractions_init(fmb_fractions *w, size_t n, fmb_mem *mem, const fmb_poll *poll)
{
    *w = (fmb_fractions){.mem = mem, .poll = poll, .size = n};
    FMB_TRY(fmb_integers_init(&w->num, n, mem));
    FMB_TRY(fmb_integers_init(&w->den, n, mem));
    return !(w->group = fmb_mem_get(mem, n, sizeof *w->group)) ? fmb_mem_status(mem) : FMB_OK;
}

void fmb_fractions_clear(fmb_fractions *w)
{
    fmb_mem_put(w->mem, w->group, w->size, sizeof *w->group);
    fmb_integers_clear(&w->den, w->mem);
    fmb_integers_clear(&w->num, w->mem);
    w->group = NULL;
}

/* ---- groups ---------------------------------------------------------------------------------- */

/* A weight with its own denominator. */
typedef struct lone_weight {
    mpz_t den;
    size_t i;
} lone_weight;

static int compare_denominators(const void *x, const void *y)
{
    const lone_weight *a = x, *b = y;
    int order = mpz_cmp(a->den, b->den);
    return order != 0 ? order : (a->i > b->i) - (a->i < b->i);
}

/* The most limbs of a common denominator that makes the weight at most twice as long. */
static size_t longest_denominator(const fmb_fractions *w, const lone_weight *x)
{
    return mpz_size(w->num.z[x->i]) + 2 * mpz_size(x->den) + 1;
}

/* Make the weights x[n] group number g with denominator den, a multiple of theirs. */
static void close_group(fmb_fractions *w, const lone_weight *x, size_t n, size_t g, mpz_t den)
{
    mpz_t factor;
    mpz_init(factor);
    for (size_t k = 0; k < n; k++) {
        mpz_ptr num = w->num.z[x[k].i];
        mpz_divexact(factor, den, x[k].den);
        mpz_mul(num, num, factor);
        w->group[x[k].i] = g;
    }
    mpz_clear(factor);
    mpz_swap(w->den.z[g], den);
}

/* x[size] is sorted by denominator. The denominators of the groups are written to w->den. */
static fmb_status form_groups(fmb_fractions *w, const lone_weight *x)
{
    size_t first = 0, groups = 0, most = SIZE_MAX;
    fmb_status st = FMB_OK;
    mpz_t common, larger;
    mpz_inits(common, larger, NULL);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++) {
        size_t own = longest_denominator(w, &x[k]);
        most = own < most ? own : most;
        if (k > first)
            mpz_lcm(larger, common, x[k].den);
        if (k > first && mpz_size(larger) > most) {
            close_group(w, x + first, k - first, groups++, common);
            first = k;
            most = own;
        }
        if (k > first)
            mpz_swap(common, larger);
        else
            mpz_set(common, x[k].den);
        st = fmb_poll_ask(w->poll);
    }
    if (st == FMB_OK && w->size > 0)
        close_group(w, x + first, w->size - first, groups, common);
    mpz_clears(common, larger, NULL);
    return st;
}

fmb_status fmb_fractions_share(fmb_fractions *w)
{
    FMB_TRY(fmb_integers_settle(&w->num, w->mem));
    FMB_TRY(fmb_integers_settle(&w->den, w->mem));
    lone_weight *x;
    FMB_TRY(FMB_GET(w->mem, x, w->size));
    for (size_t i = 0; i < w->size; i++) {
        x[i].i = i;
        mpz_init(x[i].den);
        mpz_swap(x[i].den, w->den.z[i]);
    }
    qsort(x, w->size, sizeof *x, compare_denominators);
    fmb_status st = form_groups(w, x);
    for (size_t i = 0; i < w->size; i++)
        mpz_clear(x[i].den);
    fmb_mem_put(w->mem, x, w->size, sizeof *x);
    FMB_THEN(st, fmb_integers_settle(&w->num, w->mem));
    return st == FMB_OK ? fmb_integers_settle(&w->den, w->mem) : st;
}

/* ---- sums ------------------------------------------------------------------------------------ */

static int compare_products(const void *x, const void *y)
{
    const fmb_product *a = x, *b = y;
    if (a->column != b->column)
        return a->column < b->column ? -1 : 1;
    return (a->group > b->group) - (a->group < b->group);
}

void fmb_products_sort(fmb_product *p, size_t n)
{
    qsort(p, n, sizeof *p, compare_products);
}

/* sum = the sum of products of one group, over its denominator. */
static void add_in_group(const fmb_fractions *w, const fmb_product *p, size_t n, mpz_t sum)
{
    mpz_t factor;
    mpz_init(factor);
    mpz_set_ui(sum, 0);
    for (size_t k = 0; k < n; k++) {
        if (p[k].val) {
            fmb_vec_get(p[k].val, p[k].k, factor);
            mpz_addmul(sum, factor, w->num.z[p[k].weight]);
        } else {
            mpz_add(sum, sum, w->num.z[p[k].weight]);
        }
    }
    mpz_clear(factor);
}

/* num/den += more/den_more; both denominators are positive. */
static void add_fraction(mpz_t num, mpz_t den, mpz_t more, const mpz_t den_more)
{
    mpz_mul(num, num, den_more);
    mpz_mul(more, more, den);
    mpz_add(num, num, more);
    mpz_mul(den, den, den_more);
}

/* Where to split p[n], of several groups: near the middle, between two groups. */
static size_t find_cut(const fmb_product *p, size_t n)
{
    size_t cut = n / 2;
    while (cut < n && p[cut].group == p[cut - 1].group)
        cut++;
    if (cut == n)
        for (cut = n / 2; p[cut].group == p[cut - 1].group;)
            cut--;
    return cut;
}

/* num/den = the sum of p[n], n > 0. Its numbers are no longer than those of all groups together. */
static fmb_status add_by_halves(const fmb_fractions *w, const fmb_product *p, size_t n, mpz_t num,
                                mpz_t den)
{
    if (p[0].group == p[n - 1].group) {
        add_in_group(w, p, n, num);
        mpz_set(den, w->den.z[p[0].group]);
        return FMB_OK;
    }
    size_t cut = find_cut(p, n);
    mpz_t more, den_more;
    mpz_inits(more, den_more, NULL);
    fmb_status st = add_by_halves(w, p, cut, num, den);
    FMB_THEN(st, add_by_halves(w, p + cut, n - cut, more, den_more));
    FMB_THEN(st, fmb_poll_ask(w->poll));
    if (st == FMB_OK)
        add_fraction(num, den, more, den_more);
    mpz_clears(more, den_more, NULL);
    return st;
}

/* A bound on the bytes of numbers in add_by_halves: on each side of the last addition a numerator
 * and a denominator, and as much for the result. */
static size_t bytes_of_halves(const fmb_fractions *w, const fmb_product *p, size_t n)
{
    size_t limbs = 0;
    for (size_t k = 0; k < n; k++) {
        limbs += mpz_size(w->num.z[p[k].weight]) + 2;
        limbs += p[k].val && p[k].val->z ? mpz_size(p[k].val->z[p[k].k]) : 0;
        if (k == 0 || p[k].group != p[k - 1].group)
            limbs += 2 * mpz_size(w->den.z[p[k].group]);
    }
    return 2 * limbs * sizeof(mp_limb_t);
}

fmb_status fmb_products_sign(const fmb_fractions *w, const fmb_product *p, size_t n, int *sign)
{
    fmb_status st = fmb_poll_ask(w->poll);
    *sign = 0;
    if (st != FMB_OK || n == 0)
        return st;
    size_t bytes = p[0].group != p[n - 1].group ? bytes_of_halves(w, p, n) : 0;
    if (!fmb_mem_charge(w->mem, bytes))
        return fmb_mem_status(w->mem);
    mpz_t num, den;
    mpz_inits(num, den, NULL);
    if (bytes == 0)
        add_in_group(w, p, n, num);
    else
        st = add_by_halves(w, p, n, num, den);
    *sign = mpz_sgn(num);
    mpz_clears(num, den, NULL);
    fmb_mem_refund(w->mem, bytes);
    return st;
}
