/* complete.c: the check of claims WHOLE; part of the trusted base, as check.c is.
 *
 * Let S be the system, S' the same with < read as <=, and "image" the projection on the k kept
 * variables. Claims IMPLIED give valid rows a.x <= b, some of them strict, and equations; Q is the
 * set of x that satisfy them with < read as <=, and Q* the set of x that satisfy them as written.
 * Claims CORNER give points p and directions d of S'.
 *
 * No index comes twice in a list of a claim: the reader ensures that.
 *
 * The image of S is Q* if the conditions of docs/theory.md, theorem 10, hold, which are checked
 * here.
 *
 * The space A is that of all (x, t) with a.x = b t for the equations; its dimension is k + 1 minus
 * their rank. The forms R are b t - a.x for the rows, and t. The vectors G are (x(p), 1) and (x(d),
 * 0). Let N be the set of those in G on which all forms vanish.
 *   1. With each g, N has a negative multiple of g. So cone N is a linear space, of dimension l.
 *   2. The rest of G is closed of dimension dim A - l (lattice.h), in A modulo cone N.
 *   3. Let F be a face of P that contains a point with t > 0 and on which no form of a strict row
 *      vanishes. Then for each strict row of S, some corner on F satisfies it strictly; for a
 *      direction, that means a.d < 0.
 */
#include "proof/complete.h"

#include "base/arrays.h"
#include "num/bitset.h"
#include "num/integers.h"
#include "num/prime.h"
#include "num/residue.h"
#include "system/system_private.h"

typedef struct assembly {
    const fmb_system *s;
    const fmb_evidence *e;
    fmb_mem *mem;
    const fmb_poll *poll;
    size_t width;          /* k + 1 */
    bool *kept;            /* [dim] */
    size_t *column;        /* [dim] of a kept variable */
    const fmb_claim **row; /* [rows] inequalities, then equations[equations] */
    size_t rows, equations;
    const fmb_claim **corner; /* [corners] */
    size_t corners;
    fmb_integers *form,
        *vector; /* [rows + equations], [corners]: over (x, t), each with a factor */
    uint32_t *form_residue, *vector_residue; /* [rows][width], [corners][width] of these */
    fmb_lattice faces;
    uint64_t *free, *rest; /* N, and all others */
    uint64_t *face;        /* see fmb_lattice_check */
    mpz_t t, z;
} assembly;

bool fmb_complete_names_only(const fmb_claim *c, int dim, const bool *kept)
{
    bool only = true;
    for (size_t k = 0; only && k < c->terms.size; k++)
        only = c->terms.index[k] < (size_t)dim && kept[c->terms.index[k]];
    return only;
}

/* ---- numbers --------------------------------------------------------------------------------- */

static bool is_entry_taken(const assembly *a, const fmb_sparse_vector *list, const size_t *column,
                           size_t k)
{
    return !column || a->kept[list->index[k]];
}

/* out = a common denominator of the entries [from, to) that are taken, by halves: so long numbers
 * meet long ones. */
static void find_denominator(const assembly *a, const fmb_sparse_vector *list, const size_t *column,
                             size_t from, size_t to, mpz_t out)
{
    mpz_t half;
    mpz_set_ui(out, 1);
    if (to - from == 1 && is_entry_taken(a, list, column, from))
        mpz_set(out, mpq_denref(list->value[from]));
    if (to - from < 2)
        return;
    mpz_init(half);
    find_denominator(a, list, column, from, from + (to - from) / 2, out);
    find_denominator(a, list, column, from + (to - from) / 2, to, half);
    mpz_lcm(out, out, half);
    mpz_clear(half);
}

/* v = sign times the list, by column (NULL: by index; entries without a column are left out), then
 * `last`; all times a common denominator. */
static fmb_status gather(assembly *a, const fmb_sparse_vector *list, const size_t *column, int sign,
                         mpq_srcptr last, size_t width, fmb_integers *v)
{
    FMB_TRY(fmb_integers_init(v, width, a->mem));
    find_denominator(a, list, column, 0, list->size, a->t);
    mpz_lcm(a->t, a->t, mpq_denref(last));
    for (size_t k = 0; k <= list->size; k++) {
        bool behind = k == list->size;
        mpq_srcptr from = behind ? last : list->value[k];
        if (!behind && !is_entry_taken(a, list, column, k))
            continue;
        size_t at = behind ? width - 1 : column ? column[list->index[k]] : list->index[k];
        mpz_divexact(a->z, a->t, mpq_denref(from));
        mpz_mul(v->z[at], a->z, mpq_numref(from));
        if (!behind && sign < 0)
            mpz_neg(v->z[at], v->z[at]);
    }
    return fmb_integers_settle(v, a->mem);
}

/* A corner over all variables, or over kept ones; t is 1 for points. */
static fmb_status gather_corner(assembly *a, const fmb_claim *c, const size_t *column, size_t width,
                                fmb_integers *v)
{
    bool point = c->ray.size == 0;
    mpq_t t;
    mpq_init(t);
    mpq_set_ui(t, point, 1);
    fmb_status st = gather(a, point ? &c->point : &c->ray, column, 1, t, width, v);
    mpq_clear(t);
    return st;
}

/* *out = residues [n][width] of v[n]. */
static fmb_status find_residues(assembly *a, const fmb_integers *v, size_t n, uint32_t **out)
{
    uint32_t *m = *out = fmb_mem_get(a->mem, n, a->width * sizeof *m);
    for (size_t i = 0; m && i < n; i++)
        for (size_t k = 0; k < a->width; k++)
            m[i * a->width + k] = fmb_residue_of_integer(v[i].z[k]);
    return m ? FMB_OK : fmb_mem_status(a->mem);
}

/* Is form number i zero at vector number g? */
static bool is_form_zero(assembly *a, size_t i, size_t g)
{
    size_t width = a->width;
    const uint32_t *of_vector = a->vector_residue + g * width;
    if (i == a->rows)
        return mpz_sgn(a->vector[g].z[width - 1]) == 0;
    if (!fmb_residues_vanish(a->form_residue + i * width, of_vector, width))
        return false;
    mpz_set_ui(a->t, 0);
    for (size_t k = 0; k < width; k++)
        mpz_addmul(a->t, a->form[i].z[k], a->vector[g].z[k]);
    return mpz_sgn(a->t) == 0;
}

/* The rank of m[n][width] modulo the prime; m is overwritten. */
static fmb_status eliminate_modulo(assembly *a, const fmb_prime *prime, uint64_t *m, size_t n,
                                   size_t *rank)
{
    size_t width = a->width;
    for (size_t c = 0; c < width && *rank < n; c++) {
        size_t pivot = *rank;
        while (pivot < n && m[pivot * width + c] == 0)
            pivot++;
        if (pivot == n)
            continue;
        uint64_t *p = m + *rank * width, *q = m + pivot * width;
        for (size_t k = 0; k < width; k++) {
            uint64_t x = p[k];
            p[k] = q[k];
            q[k] = x;
        }
        uint64_t inverse = fmb_prime_inverse(prime, p[c]);
        for (size_t i = ++*rank; i < n; i++) {
            uint64_t *row = m + i * width, factor = fmb_prime_times(prime, row[c], inverse);
            for (size_t k = c; k < width && factor != 0; k++)
                row[k] = fmb_prime_minus(prime, row[k], fmb_prime_times(prime, factor, p[k]));
        }
        FMB_TRY(fmb_poll_ask(a->poll));
    }
    return FMB_OK;
}

/* *rank = the rank of v[n] modulo a prime, which is at most the rank of v[n]. */
static fmb_status find_rank_modulo(assembly *a, const fmb_integers *v, size_t n, size_t *rank)
{
    const fmb_prime prime = fmb_prime_number(0);
    *rank = 0;
    uint64_t *m = fmb_mem_get(a->mem, n, a->width * sizeof *m);
    if (!m)
        return fmb_mem_status(a->mem);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < a->width; k++)
            m[i * a->width + k] = fmb_prime_of_integer(&prime, v[i].z[k]);
    fmb_status st = eliminate_modulo(a, &prime, m, n, rank);
    fmb_mem_put(a->mem, m, n, a->width * sizeof *m);
    return st;
}

/* *found = the rank of v[n], which is overwritten. */
static fmb_status find_rank(assembly *a, fmb_integers *v, size_t n, size_t *found)
{
    size_t rank = 0;
    fmb_status st = FMB_OK;
    for (size_t c = 0; st == FMB_OK && c < a->width && rank < n; c++) {
        size_t pivot = rank;
        while (pivot < n && mpz_sgn(v[pivot].z[c]) == 0)
            pivot++;
        if (pivot == n)
            continue;
        fmb_integers chosen = v[pivot];
        v[pivot] = v[rank];
        v[rank++] = chosen;
        for (size_t i = rank; st == FMB_OK && i < n; i++) {
            mpz_neg(a->z, v[i].z[c]);
            for (size_t k = 0; k < a->width && mpz_sgn(a->z) != 0; k++) {
                mpz_mul(v[i].z[k], v[i].z[k], chosen.z[c]);
                mpz_addmul(v[i].z[k], a->z, chosen.z[k]);
            }
            st = fmb_integers_reduce(v[i].z, v[i].size, a->t, a->poll);
            FMB_THEN(st, fmb_poll_ask(a->poll));
        }
    }
    *found = rank;
    return st;
}

/* ---- rows and corners ------------------------------------------------------------------------ */

static fmb_status list_kept_variables(assembly *a, const fmb_claim *q)
{
    size_t dim = (size_t)a->e->dim;
    FMB_TRY(FMB_ARRAYS(a->mem, true, FMB_ARRAY_ZERO(a->kept, dim), FMB_ARRAY(a->column, dim)));
    for (size_t k = 0; k < q->terms.size; k++) {
        a->kept[q->terms.index[k]] = true;
        a->column[q->terms.index[k]] = k;
    }
    a->width = q->terms.size + 1;
    return FMB_OK;
}

static bool is_row_of_image(const assembly *a, const fmb_claim *c)
{
    return c->kind == FMB_CLAIM_IMPLIED && fmb_complete_names_only(c, a->e->dim, a->kept);
}

static fmb_status list_rows_and_corners(assembly *a)
{
    const fmb_evidence *e = a->e;
    FMB_TRY(
        FMB_ARRAYS(a->mem, true, FMB_ARRAY(a->row, e->claims), FMB_ARRAY(a->corner, e->claims)));
    for (int equation = 0; equation <= 1; equation++)
        for (size_t i = 0; i < e->claims; i++)
            if (is_row_of_image(a, &e->claim[i]) && (e->claim[i].rel == FMB_EQ) == equation) {
                a->row[a->rows + a->equations] = &e->claim[i];
                *(equation ? &a->equations : &a->rows) += 1;
            }
    for (size_t i = 0; i < e->claims; i++)
        if (e->claim[i].kind == FMB_CLAIM_CORNER)
            a->corner[a->corners++] = &e->claim[i];
    return FMB_OK;
}

static fmb_status write_out_numbers(assembly *a)
{
    size_t forms = a->rows + a->equations;
    FMB_TRY(FMB_ARRAYS(a->mem, true, FMB_ARRAY_ZERO(a->form, forms),
                       FMB_ARRAY_ZERO(a->vector, a->corners)));
    for (size_t i = 0; i < forms; i++)
        FMB_TRY(
            gather(a, &a->row[i]->terms, a->column, -1, a->row[i]->value, a->width, &a->form[i]));
    for (size_t g = 0; g < a->corners; g++) {
        FMB_TRY(gather_corner(a, a->corner[g], a->column, a->width, &a->vector[g]));
        FMB_TRY(fmb_integers_reduce(a->vector[g].z, a->vector[g].size, a->t, a->poll));
    }
    FMB_TRY(find_residues(a, a->form, a->rows, &a->form_residue));
    return find_residues(a, a->vector, a->corners, &a->vector_residue);
}

/* ---- incidences of corners ------------------------------------------------------------------- */

/* Find the zeros of all forms; the last one is t, which excludes faces at infinity. */
static fmb_status find_zeros(assembly *a)
{
    fmb_lattice *l = &a->faces;
    l->forms = a->rows + 1;
    l->words = a->corners / 64 + 1;
    l->zero = fmb_mem_zero(a->mem, l->forms, l->words * sizeof *l->zero);
    fmb_status st = FMB_ARRAYS(a->mem, true, FMB_ARRAY_ZERO(l->excludes, l->forms),
                               FMB_ARRAY_ZERO(a->free, l->words), FMB_ARRAY_ZERO(a->rest, l->words),
                               FMB_ARRAY_ZERO(a->face, l->words));
    FMB_TRY(l->zero ? st : fmb_mem_status(a->mem));
    for (size_t g = 0; st == FMB_OK && g < a->corners; g++) {
        size_t zeros = 0;
        for (size_t i = 0; i < l->forms; i++) {
            st = st == FMB_OK ? fmb_poll_ask(a->poll) : st;
            bool on = is_form_zero(a, i, g);
            if (on)
                fmb_set_put(l->zero + i * l->words, g);
            zeros += on;
        }
        fmb_set_put(zeros == l->forms ? a->free : a->rest, g);
    }
    for (size_t i = 0; i < l->forms; i++)
        l->excludes[i] = i == a->rows || a->row[i]->rel == FMB_LT;
    return st;
}

static bool are_opposite(const fmb_integers *v, const fmb_integers *w)
{
    bool opposite = true;
    for (size_t k = 0; opposite && k < v->size; k++)
        opposite = mpz_cmpabs(v->z[k], w->z[k]) == 0 && mpz_sgn(v->z[k]) == -mpz_sgn(w->z[k]);
    return opposite;
}

/* Condition 1. Vectors are in lowest terms. The vectors of N are moved to the front, *n of them. */
static bool is_free_part_linear(assembly *a, size_t *n)
{
    bool linear = true;
    *n = 0;
    for (size_t g = 0; g < a->corners; g++)
        if (fmb_set_has(a->free, g)) {
            fmb_integers v = a->vector[g];
            a->vector[g] = a->vector[*n];
            a->vector[(*n)++] = v;
        }
    for (size_t i = 0; linear && i < *n; i++) {
        size_t k = 0;
        while (k < *n && !are_opposite(&a->vector[i], &a->vector[k]))
            k++;
        linear = k < *n;
    }
    return linear;
}

/* Does a corner over all variables, then t, satisfy a strict row of the system strictly? */
static bool is_strictly_inside(assembly *a, const fmb_sysrow *row, const fmb_integers *v)
{
    mpz_set_ui(a->t, 0);
    for (size_t k = 0; k < row->nnz; k++) {
        fmb_vec_get(&row->val, k, a->z);
        mpz_addmul(a->t, a->z, v->z[row->var[k]]);
    }
    fmb_vec_get(&row->val, row->nnz, a->z);
    mpz_submul(a->t, a->z, v->z[v->size - 1]);
    return mpz_sgn(a->t) < 0;
}

/* Find the corners strictly inside of each strict row of the system. */
static fmb_status find_strict_insides(assembly *a)
{
    fmb_lattice *l = &a->faces;
    size_t dim = (size_t)a->e->dim, strict = 0;
    for (size_t i = 0; i < a->s->rows; i++)
        strict += fmb_system_row(a->s, i)->rel == FMB_LT;
    l->shows = fmb_mem_zero(a->mem, strict, l->words * sizeof *l->shows);
    if (!l->shows)
        return fmb_mem_status(a->mem);
    l->wanted = strict;
    fmb_status st = FMB_OK;
    for (size_t g = 0; st == FMB_OK && strict > 0 && g < a->corners; g++) {
        fmb_integers v = {0};
        uint64_t *set = l->shows;
        st = gather_corner(a, a->corner[g], NULL, dim + 1, &v);
        for (size_t i = 0; st == FMB_OK && i < a->s->rows; i++) {
            const fmb_sysrow *row = fmb_system_row(a->s, i);
            if (row->rel != FMB_LT)
                continue;
            if (is_strictly_inside(a, row, &v))
                fmb_set_put(set, g);
            set += l->words;
        }
        fmb_integers_clear(&v, a->mem);
        st = st == FMB_OK ? fmb_poll_ask(a->poll) : st;
    }
    return st;
}

/* ---- the claim ------------------------------------------------------------------------------- */

/* Conditions 2 and 3 with this sum of ranks. */
static fmb_status check_faces_of(assembly *a, size_t rank, fmb_lattice_end *end)
{
    return rank > a->width ? FMB_OK
                           : fmb_lattice_check(&a->faces, a->rest, a->width - rank, a->mem, a->poll,
                                               end, a->face);
}

/* Ranks modulo a prime may be too small, which makes the dimension too large: no set is closed of a
 * dimension larger than that of its span (lattice.h), so nothing wrong is accepted; and before a
 * claim is refused, the ranks are computed exactly. */
static fmb_status check_faces(assembly *a, const char **why, bool *on)
{
    static const char *const said[] = {
        [FMB_LATTICE_CLOSED] = NULL,
        [FMB_LATTICE_OPEN] = "the corners do not span all that the rows allow",
        [FMB_LATTICE_UNSHOWN] = "no corners show that a face belongs to the projection",
        [FMB_LATTICE_LARGE] = "there are too many faces to check"};
    fmb_lattice_end end = FMB_LATTICE_OPEN;
    size_t n = 0;
    bool linear = is_free_part_linear(a, &n);
    size_t equations = 0, lines = 0;
    fmb_status st = FMB_OK;
    if (linear)
        st = find_rank_modulo(a, a->form + a->rows, a->equations, &equations);
    if (linear && st == FMB_OK)
        st = find_rank_modulo(a, a->vector, n, &lines);
    if (linear && st == FMB_OK)
        st = check_faces_of(a, equations + lines, &end);
    bool may_be_more = equations < a->equations || lines < n;
    if (linear && st == FMB_OK && end == FMB_LATTICE_OPEN && may_be_more) {
        size_t before = equations + lines;
        st = find_rank(a, a->form + a->rows, a->equations, &equations);
        FMB_THEN(st, find_rank(a, a->vector, n, &lines));
        if (st == FMB_OK && equations + lines > before)
            st = check_faces_of(a, equations + lines, &end);
    }
    *why = said[end];
    for (size_t g = 0; on && st == FMB_OK && g < a->corners; g++)
        on[a->corner[g] - a->e->claim] = end == FMB_LATTICE_UNSHOWN && fmb_set_has(a->face, g);
    return st;
}

static void clear_assembly(assembly *a)
{
    size_t dim = (size_t)a->e->dim, forms = a->rows + a->equations;
    fmb_lattice *l = &a->faces;
    for (size_t i = 0; a->form && i < forms; i++)
        fmb_integers_clear(&a->form[i], a->mem);
    for (size_t g = 0; a->vector && g < a->corners; g++)
        fmb_integers_clear(&a->vector[g], a->mem);
    fmb_mem_put(a->mem, a->form_residue, a->rows, a->width * sizeof *a->form_residue);
    fmb_mem_put(a->mem, a->vector_residue, a->corners, a->width * sizeof *a->vector_residue);
    fmb_mem_put(a->mem, l->zero, l->forms, l->words * sizeof *l->zero);
    fmb_mem_put(a->mem, l->shows, l->wanted, l->words * sizeof *l->shows);
    FMB_ARRAYS_PUT(a->mem, FMB_ARRAY(a->form, forms), FMB_ARRAY(a->vector, a->corners),
                   FMB_ARRAY(a->row, a->e->claims), FMB_ARRAY(a->corner, a->e->claims),
                   FMB_ARRAY(a->kept, dim), FMB_ARRAY(a->column, dim),
                   FMB_ARRAY(l->excludes, l->forms), FMB_ARRAY(a->free, l->words),
                   FMB_ARRAY(a->rest, l->words), FMB_ARRAY(a->face, l->words));
    mpz_clears(a->t, a->z, NULL);
}

fmb_status fmb_complete_check(const fmb_system *s, const fmb_evidence *e, const fmb_claim *q,
                              fmb_mem *mem, const fmb_poll *poll, const char **why, bool *on)
{
    assembly a = {.s = s, .e = e, .mem = mem, .poll = poll};
    mpz_inits(a.t, a.z, NULL);
    fmb_status st = list_kept_variables(&a, q);
    FMB_THEN(st, list_rows_and_corners(&a));
    FMB_THEN(st, write_out_numbers(&a));
    FMB_THEN(st, find_zeros(&a));
    FMB_THEN(st, find_strict_insides(&a));
    FMB_THEN(st, check_faces(&a, why, on));
    clear_assembly(&a);
    return st;
}
