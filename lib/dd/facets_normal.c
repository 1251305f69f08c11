/* facets_normal.c: the normal of a facet from the generators on it; see facets.h.
 *
 * Its entries are the minors of d - 1 independent generators, a column left out in turn. Minors of
 * k rows, in every set of k columns, give those of k + 1 rows by expansion along the last row
 * (Laplace): no divisions, and d 2^(d-1) products, which is why this is for few columns. If all new
 * minors are 0, the generator depends on those before it, and another one is taken.
 */
#include "dd/facets_inside.h"
#include "num/gcd.h"

#define MOST_SETS ((size_t)1 << FMB_FACETS_FEW)

/* Minors so far, by set of columns: rows of them. */
typedef struct minors {
    size_t d, rows;
    fmb_i128 *s;
    mpz_t *z; /* or NULL: minors fit into s */
} minors;

static uint32_t next_set_of_same_size(uint32_t set)
{
    uint32_t low = set & -set, up = set + low;
    return up | ((set ^ up) / low) >> 2;
}

/* ---- one row more ---------------------------------------------------------------------------- */

/* The minor of this set, with g as the last row. Signs alternate from the last column. */
static void expand_small_minor(minors *m, uint32_t set, const fmb_vec *g)
{
    fmb_i128 sum = 0;
    for (uint32_t left = set, sign = 0; left != 0; sign ^= 1) {
        uint32_t c = 31 - (uint32_t)__builtin_clz(left), bit = (uint32_t)1 << c;
        fmb_i128 t = m->s[set ^ bit] * g->s[c];
        sum += sign ? -t : t;
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

/* *added: g is independent of the rows so far, and a row now. */
static void add_row_to_minors(minors *m, const fmb_vec *g, mpz_t room, bool *added)
{
    uint32_t end = (uint32_t)1 << m->d;
    *added = false;
    for (uint32_t set = ((uint32_t)2 << m->rows) - 1; set < end; set = next_set_of_same_size(set)) {
        if (m->z)
            expand_wide_minor(m, set, g, room);
        else
            expand_small_minor(m, set, g);
        *added |= m->z ? mpz_sgn(m->z[set]) != 0 : m->s[set] != 0;
    }
    m->rows += *added;
}

/* ---- the normal ------------------------------------------------------------------------------ */

/* Do minors of any generators on the facet fit into 126 bits? Of k rows, they are less than k!
 * times the product of their largest entries. */
static bool are_minors_small(const fmb_facets *f, const fmb_facet *a)
{
    int most = 0, bits = 0;
    for (size_t i = fmb_facet_next(a, 0, true); i < f->generators;
         i = fmb_facet_next(a, i + 1, true)) {
        if (f->generator[i].z)
            return false;
        most = f->generator[i].bits > most ? f->generator[i].bits : most;
    }
    for (size_t k = 1; k < f->d; k++)
        bits += most + fmb_bits64(k);
    return bits <= 126;
}

static void find_minors(fmb_facets *f, const fmb_facet *a, minors *m)
{
    bool added;
    if (m->z)
        mpz_set_ui(m->z[0], 1);
    else
        m->s[0] = 1;
    for (size_t i = 0; m->rows + 1 < f->d; i++) {
        i = fmb_facet_next(a, i, true);
        add_row_to_minors(m, &f->generator[i], f->num.p, &added);
    }
}

/* Where they are small, they may fit into the vector as it is. */
static bool take_short_minors(const minors *m, fmb_vec *normal)
{
    uint32_t all = ((uint32_t)1 << m->d) - 1;
    for (size_t j = 0; j < m->d; j++) {
        fmb_i128 t = m->s[all ^ (uint32_t)1 << j];
        if (t >> FMB_SMALL_BITS != 0 && t >> FMB_SMALL_BITS != -1)
            return false;
        normal->s[j] = (int64_t)(j % 2 ? -t : t);
    }
    normal->s[m->d] = 0;
    return true;
}

static fmb_status take_minors(fmb_facets *f, const minors *m, fmb_vec *normal)
{
    uint32_t all = ((uint32_t)1 << m->d) - 1;
    if (!m->z && !normal->z && take_short_minors(m, normal))
        return FMB_OK;
    fmb_status st = fmb_vec_widen(normal, f->d + 1, f->num.mem);
    if (st != FMB_OK)
        return st;
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
    return fmb_vec_settle(normal, f->d + 1, f->num.mem);
}

/* Its sign is that which makes it positive on a generator that is not on the facet. */
static void turn_normal_inwards(fmb_facets *f, fmb_facet *a)
{
    size_t i = fmb_facet_next(a, 0, false);
    if (fmb_facets_sign(f, &a->normal, &f->generator[i]) < 0)
        fmb_facets_negate(&a->normal, f->d + 1);
}

static fmb_status need_wide_minors(fmb_facets *f)
{
    if (!f->minor)
        f->minor = fmb_vec_block((size_t)1 << f->d, f->num.mem);
    return f->minor ? FMB_OK : fmb_mem_status(f->num.mem);
}

fmb_status fmb_facets_need_normal(fmb_facets *f, size_t at)
{
    fmb_facet *a = &f->facet[at];
    fmb_i128 small[MOST_SETS];
    minors m = {.d = f->d, .s = small};
    fmb_status st = FMB_OK;
    if (a->known)
        return FMB_OK;
    if (!are_minors_small(f, a)) {
        st = need_wide_minors(f);
        m.z = f->minor;
    }
    if (st != FMB_OK)
        return st;
    find_minors(f, a, &m);
    st = take_minors(f, &m, &a->normal);
    if (st == FMB_OK)
        st = fmb_vec_reduce(&a->normal, f->d + 1, &f->num);
    if (st != FMB_OK)
        return st;
    turn_normal_inwards(f, a);
    a->known = true;
    fmb_facets_round_normal(f, a);
    return FMB_OK;
}
