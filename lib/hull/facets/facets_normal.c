/* facets_normal.c: the normal of a facet from the generators on it; see facets.h.
 *
 * Its entries are the minors of d - 1 independent generators, each without one of the columns.
 * Minors of k rows, in every set of k columns, give those of k + 1 rows by expansion along the last
 * row (Laplace): no divisions, and d 2^(d-1) products, so this is for few columns. If all new
 * minors are 0, the generator depends on the earlier ones, and another one is tried.
 *
 * By Hadamard's inequality a minor is no larger than the product of the lengths of its rows. If
 * that fits into 126 bits, intermediate sums may wrap around: modulo 2^128 the results are right.
 */
#include "hull/facets/facets_private.h"
#include "num/gcd.h"

#define MOST_SETS ((size_t)1 << FMB_FACETS_FEW)

/* The minors of the rows so far, by set of columns. */
typedef struct minors {
    size_t d, rows;
    fmb_i128 *s;
    mpz_t *z; /* or NULL: minors fit into s */
} minors;

/* ---- one row more ---------------------------------------------------------------------------- */

/* The minor of this set, with g as the last row. Signs alternate from the last column. */
static void expand_small_minor(minors *m, uint32_t set, const fmb_vec *g)
{
    fmb_i128 sum = fmb_i128_of(0);
    for (uint32_t left = set, sign = 0; left != 0; sign ^= 1) {
        uint32_t c = 31 - (uint32_t)__builtin_clz(left), bit = (uint32_t)1 << c;
        fmb_i128 t = fmb_i128_times(m->s[set ^ bit], fmb_i128_of(g->s[c]));
        sum = sign ? fmb_i128_minus(sum, t) : fmb_i128_plus(sum, t);
        left ^= bit;
    }
    m->s[set] = sum;
}

static void expand_wide_minor(minors *m, uint32_t set, const fmb_vec *g, mpz_t room)
{
    mpz_ptr sum = m->z[set];
    mpz_set_ui(sum, 0);
    for (uint32_t left = set, sign = 0; left != 0; sign ^= 1) {
        uint32_t c = 31 - (uint32_t)__builtin_clz(left), bit = (uint32_t)1 << c;
        fmb_vec_get(g, c, room);
        if (sign)
            mpz_submul(sum, m->z[set ^ bit], room);
        else
            mpz_addmul(sum, m->z[set ^ bit], room);
        left ^= bit;
    }
}

/* *added: g is independent of the rows so far, and became a row. */
static void add_row_to_minors(minors *m, const fmb_vec *g, mpz_t room, bool *added)
{
    uint32_t end = (uint32_t)1 << m->d;
    *added = false;
    for (uint32_t set = ((uint32_t)2 << m->rows) - 1; set < end; set = fmb_facets_next_set(set)) {
        if (m->z)
            expand_wide_minor(m, set, g, room);
        else
            expand_small_minor(m, set, g);
        *added |= m->z ? mpz_sgn(m->z[set]) != 0 : fmb_i128_sign(m->s[set]) != 0;
    }
    m->rows += *added;
}

/* ---- the normal ------------------------------------------------------------------------------ */

/* For a small vector, the least b with length^2 < 2^b. */
static int bits_of_squared_length(const fmb_vec *v, size_t d)
{
    fmb_u128 sum = fmb_u128_of(0);
    for (size_t j = 0; j < d; j++)
        sum = fmb_u128_plus_product(sum, fmb_abs64(v->s[j]), fmb_abs64(v->s[j]));
    return fmb_u128_bits(sum);
}

/* Do all minors of generators on the facet fit into 126 bits? */
static bool are_minors_small(const fmb_facets *f, const fmb_facet *a)
{
    int most = 0;
    for (size_t i = fmb_facet_next(a, 0, true); i < f->generators;
         i = fmb_facet_next(a, i + 1, true)) {
        if (f->generator[i].z)
            return false;
        int bits = bits_of_squared_length(&f->generator[i], f->d);
        most = bits > most ? bits : most;
    }
    return (int)(f->d - 1) * most <= 2 * 126;
}

static void find_minors(const fmb_facets *f, const fmb_facet *a, minors *m, mpz_t room)
{
    bool added;
    if (m->z)
        mpz_set_ui(m->z[0], 1);
    else
        m->s[0] = fmb_i128_of(1);
    for (size_t i = 0; m->rows + 1 < f->d; i++) {
        i = fmb_facet_next(a, i, true);
        add_row_to_minors(m, &f->generator[i], room, &added);
    }
}

/* If the minors are small enough, store them in the vector as int64. */
static bool take_short_minors(const minors *m, fmb_vec *normal)
{
    uint32_t all = ((uint32_t)1 << m->d) - 1;
    for (size_t j = 0; j < m->d; j++) {
        fmb_i128 t = m->s[all ^ (uint32_t)1 << j];
        if (fmb_u128_bits(fmb_i128_size(t)) > FMB_SMALL_BITS)
            return false;
        normal->s[j] = j % 2 ? -fmb_i128_low(t) : fmb_i128_low(t);
    }
    normal->s[m->d] = 0;
    return true;
}

static fmb_status take_minors(const minors *m, fmb_vec *normal, fmb_mem *mem)
{
    uint32_t all = ((uint32_t)1 << m->d) - 1;
    if (!m->z && !normal->z && take_short_minors(m, normal))
        return FMB_OK;
    FMB_TRY(fmb_vec_widen(normal, m->d + 1, mem));
    for (size_t j = 0; j < m->d; j++) {
        uint32_t set = all ^ (uint32_t)1 << j;
        if (m->z)
            mpz_set(normal->z[j], m->z[set]);
        else
            fmb_integer_set_128(normal->z[j], m->s[set]);
        if (j % 2)
            mpz_neg(normal->z[j], normal->z[j]);
    }
    mpz_set_ui(normal->z[m->d], 0);
    return fmb_vec_settle(normal, m->d + 1, mem);
}

/* Choose the sign that makes the normal positive on a generator not on the facet. */
static void turn_normal_inwards(const fmb_facets *f, fmb_facet *a, fmb_num *num)
{
    size_t i = fmb_facet_next(a, 0, false);
    if (fmb_vec_product_sign(&a->normal, &f->generator[i], f->d, num) < 0)
        fmb_vec_negate(&a->normal, f->d + 1);
}

static fmb_status need_wide_minors(const fmb_facets *f, fmb_normal_tools *by)
{
    if (!by->minor)
        by->minor = fmb_vec_block((size_t)1 << f->d, by->num->mem);
    return by->minor ? FMB_OK : fmb_mem_status(by->num->mem);
}

void fmb_normal_tools_clear(const fmb_facets *f, fmb_normal_tools *by)
{
    if (!by->minor)
        return;
    fmb_vec_block_free(by->minor, (size_t)1 << f->d, by->num->mem);
    by->minor = NULL;
}

fmb_status fmb_facets_find_normal(const fmb_facets *f, fmb_facet *a, fmb_normal_tools *by)
{
    fmb_i128 small[MOST_SETS];
    minors m = {.d = f->d, .s = small};
    fmb_status st = FMB_OK;
    if (!are_minors_small(f, a)) {
        st = need_wide_minors(f, by);
        m.z = by->minor;
    }
    if (st != FMB_OK)
        return st;
    find_minors(f, a, &m, by->num->p);
    st = take_minors(&m, &a->normal, by->num->mem);
    FMB_THEN(st, fmb_vec_reduce(&a->normal, f->d + 1, by->num));
    if (st != FMB_OK)
        return st;
    turn_normal_inwards(f, a, by->num);
    a->known = true;
    fmb_facets_round_normal(f, a);
    return FMB_OK;
}

/* Work: there are 2^d minors, of at most d terms, on average half as long as the final ones.
 */
static uint64_t work_of_normal(const fmb_facets *f, const fmb_vec *normal)
{
    size_t limbs = normal->z ? normal->limbs / (f->d + 1) : 0;
    uint64_t products = (uint64_t)f->d << f->d;
    return normal->z ? products * fmb_limbs_work(limbs / 4) : 20 * products;
}

fmb_status fmb_facets_need_normal(fmb_facets *f, size_t at)
{
    fmb_normal_tools own = {&f->num, f->minor};
    if (f->facet[at].known)
        return FMB_OK;
    fmb_status st = fmb_facets_find_normal(f, &f->facet[at], &own);
    fmb_run_count(f->run, work_of_normal(f, &f->facet[at].normal));
    f->minor = own.minor;
    return st;
}
