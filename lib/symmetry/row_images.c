/* row_images.c: see row_images.h. */
#include "symmetry/row_images.h"

#include "base/arrays.h"
#include "num/rationals.h"

/* ---- modulo equalities ----------------------------------------------------------------------- */

/* x -= x_pivot times the equality. */
static void subtract_equality(fmb_row_images *t, size_t e)
{
    mpq_t *from = t->equality[e];
    mpq_t factor;
    if (mpq_sgn(t->x[t->pivot[e]]) == 0)
        return;
    mpq_init(factor);
    mpq_set(factor, t->x[t->pivot[e]]);
    for (size_t j = 0; j <= t->dim; j++) {
        if (mpq_sgn(from[j]) == 0)
            continue;
        mpq_mul(t->q, factor, from[j]);
        mpq_sub(t->x[j], t->x[j], t->q);
    }
    mpq_clear(factor);
}

/* x[dim + 1] = the permuted row without the pivot variables of equalities. */
static void scatter_and_reduce(fmb_row_images *t)
{
    for (size_t j = 0; j <= t->dim; j++)
        mpq_set_ui(t->x[j], 0, 1);
    for (size_t k = 0; k < t->moved.size; k++)
        mpq_set_z(t->x[t->moved.var[k]], t->z[k]);
    mpq_set_z(t->x[t->dim], t->z[t->moved.size]);
    for (size_t e = 0; e < t->equalities; e++)
        subtract_equality(t, e);
}

/* Write x as integers to t->z and t->moved.var. */
static void gather_reduced_row(fmb_row_images *t)
{
    mpz_ptr common = mpq_denref(t->q);
    size_t n = 0;
    mpz_set_ui(common, 1);
    for (size_t j = 0; j <= t->dim; j++)
        mpz_lcm(common, common, mpq_denref(t->x[j]));
    for (size_t j = 0; j <= t->dim; j++) {
        if (mpq_sgn(t->x[j]) == 0 && j < t->dim)
            continue;
        mpz_divexact(t->z[n], common, mpq_denref(t->x[j]));
        mpz_mul(t->z[n], t->z[n], mpq_numref(t->x[j]));
        if (j < t->dim)
            t->moved.var[n++] = (int)j;
    }
    t->moved.size = n;
    mpz_set_ui(common, 1);
}

/* Make x, reduced, an equality of the echelon form unless it is 0. */
static fmb_status append_equality(fmb_row_images *t)
{
    size_t pivot = 0;
    while (pivot < t->dim && mpq_sgn(t->x[pivot]) == 0)
        pivot++;
    if (pivot == t->dim)
        return FMB_OK;
    mpq_t *e;
    FMB_TRY(fmb_rationals_new(&e, t->dim + 1, t->mem));
    for (size_t j = 0; j <= t->dim; j++)
        mpq_div(e[j], t->x[j], t->x[pivot]);
    for (size_t k = 0; k < t->equalities; k++) { /* each is reduced by the new one */
        mpq_t *x = t->equality[k];
        mpq_set(t->q, x[pivot]);
        for (size_t j = 0; mpq_sgn(t->q) != 0 && j <= t->dim; j++) {
            mpq_mul(t->x[j], t->q, e[j]);
            mpq_sub(x[j], x[j], t->x[j]);
        }
    }
    t->pivot[t->equalities] = (int)pivot;
    t->equality[t->equalities++] = e;
    return FMB_OK;
}

/* ---- one row, permuted ----------------------------------------------------------------------- */

/* Sort the terms of the row by their new variables. Rows are short, or nearly sorted: insertion
 * sort. */
static void sort_moved_terms(fmb_row_images *t, const fmb_sysrow *r, const int *image)
{
    int *to = t->moved.var;
    t->moved.size = r->nnz;
    for (size_t k = 0; k < r->nnz; k++) {
        int var = image ? image[r->var[k]] : r->var[k];
        size_t at = k;
        for (; at > 0 && to[at - 1] > var; at--) {
            to[at] = to[at - 1];
            mpz_swap(t->z[at], t->z[at - 1]);
        }
        to[at] = var;
        fmb_vec_get(&r->val, k, t->z[at]);
    }
    fmb_vec_get(&r->val, r->nnz, t->z[r->nnz]);
}

static uint64_t hash_of_moved_row(const fmb_row_images *t, fmb_rel rel)
{
    uint64_t h = fmb_vec_hash(&t->moved.v, t->moved.size + 1) + (uint64_t)rel;
    for (size_t k = 0; k < t->moved.size; k++)
        h = (h ^ (uint64_t)t->moved.var[k]) * UINT64_C(0x9E3779B97F4A7C15);
    return h;
}

/* t->moved = row i permuted. The caller must call fmb_vec_clear on t->moved.v. */
static fmb_status move_row_by_image(fmb_row_images *t, size_t i, const int *image)
{
    const fmb_sysrow *r = fmb_system_row(t->s, i);
    sort_moved_terms(t, r, image);
    if (r->rel != FMB_EQ && t->equalities > 0) {
        scatter_and_reduce(t);
        gather_reduced_row(t);
    }
    size_t n = t->moved.size + 1;
    if (r->rel == FMB_EQ && mpz_sgn(t->z[0]) < 0)
        for (size_t k = 0; k < n; k++)
            mpz_neg(t->z[k], t->z[k]);
    FMB_TRY(fmb_vec_set_z(&t->moved.v, n, t->z, t->mem));
    FMB_TRY(fmb_vec_reduce(&t->moved.v, n, &t->num));
    t->moved.hash = hash_of_moved_row(t, r->rel);
    return FMB_OK;
}

/* Is the permuted row, with that relation, equal to row i of the table? */
static bool is_moved_row(const fmb_row_images *t, fmb_rel rel, size_t i)
{
    const fmb_row_image *a = &t->moved, *b = &t->row[i];
    if (a->hash != b->hash || a->size != b->size || fmb_system_row(t->s, i)->rel != rel)
        return false;
    for (size_t k = 0; k < a->size; k++)
        if (a->var[k] != b->var[k])
            return false;
    return fmb_vec_equal(&a->v, &b->v, a->size + 1);
}

/* The slot of a row equal to the permuted one, or the free slot for it. */
static size_t find_slot_of_moved_row(const fmb_row_images *t, fmb_rel rel)
{
    size_t at = (size_t)t->moved.hash & (t->slots - 1);
    while (t->slot[at] != SIZE_MAX && !is_moved_row(t, rel, t->slot[at]))
        at = (at + 1) & (t->slots - 1);
    return at;
}

/* Is the permuted equality a combination of the others? */
static bool does_moved_equality_follow(fmb_row_images *t)
{
    scatter_and_reduce(t);
    for (size_t j = 0; j <= t->dim; j++)
        if (mpq_sgn(t->x[j]) != 0)
            return false;
    return true;
}

fmb_status fmb_row_images_find(fmb_row_images *t, size_t i, const int *image, size_t *found)
{
    fmb_rel rel = fmb_system_row(t->s, i)->rel;
    fmb_status st = move_row_by_image(t, i, image);
    if (st == FMB_OK)
        *found = t->slot[find_slot_of_moved_row(t, rel)];
    if (st == FMB_OK && *found == SIZE_MAX && rel == FMB_EQ && does_moved_equality_follow(t))
        *found = i;
    fmb_vec_clear(&t->moved.v, t->moved.size + 1, t->mem);
    return st;
}

fmb_status fmb_row_images_check(fmb_row_images *t, const int *image, size_t *without)
{
    size_t found = 0;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && found != SIZE_MAX && i < fmb_system_rows(t->s); i++) {
        st = fmb_row_images_find(t, i, image, &found);
        *without = i;
    }
    if (found != SIZE_MAX)
        *without = SIZE_MAX;
    return st;
}

/* ---- the table ------------------------------------------------------------------------------- */

/* Enter row i unless an equal row is there. */
static fmb_status enter_row(fmb_row_images *t, size_t i)
{
    fmb_row_image *r = &t->row[i];
    fmb_status st = move_row_by_image(t, i, NULL);
    size_t n = t->moved.size;
    *r = (fmb_row_image){.size = n, .hash = t->moved.hash};
    r->var = st == FMB_OK ? fmb_mem_get(t->mem, n, sizeof *r->var) : NULL;
    r->v.s = st == FMB_OK ? fmb_mem_get(t->mem, n + 1, sizeof *r->v.s) : NULL;
    FMB_THEN(st, r->var && r->v.s ? fmb_vec_copy(&r->v, &t->moved.v, n + 1, t->mem)
                                  : fmb_mem_status(t->mem));
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        r->var[k] = t->moved.var[k];
    if (st == FMB_OK) {
        size_t at = find_slot_of_moved_row(t, fmb_system_row(t->s, i)->rel);
        t->slot[at] = t->slot[at] == SIZE_MAX ? i : t->slot[at];
    }
    fmb_vec_clear(&t->moved.v, n + 1, t->mem);
    return st;
}

static fmb_status open_equalities(fmb_row_images *t)
{
    size_t m = fmb_system_rows(t->s);
    for (size_t i = 0; i < m; i++)
        t->room += fmb_system_row(t->s, i)->rel == FMB_EQ;
    if (t->room == 0)
        return FMB_OK;
    FMB_TRY(fmb_rationals_new(&t->x, t->dim + 1, t->mem));
    FMB_TRY(
        FMB_ARRAYS(t->mem, true, FMB_ARRAY(t->equality, t->room), FMB_ARRAY(t->pivot, t->room)));
    for (size_t i = 0; i < m; i++) {
        const fmb_sysrow *r = fmb_system_row(t->s, i);
        if (r->rel != FMB_EQ)
            continue;
        sort_moved_terms(t, r, NULL);
        scatter_and_reduce(t);
        FMB_TRY(append_equality(t));
    }
    return FMB_OK;
}

static fmb_status open_row_images(fmb_row_images *t)
{
    size_t m = fmb_system_rows(t->s);
    FMB_TRY(FMB_ARRAYS(t->mem, true, FMB_ARRAY_ZERO(t->row, m), FMB_ARRAY(t->slot, t->slots),
                       FMB_ARRAY(t->moved.var, t->dim), FMB_ARRAY(t->moved.v.s, t->dim + 1)));
    for (size_t k = 0; k < t->slots; k++)
        t->slot[k] = SIZE_MAX;
    t->z = fmb_vec_block(t->dim + 1, t->mem);
    return t->z ? FMB_OK : fmb_mem_status(t->mem);
}

fmb_status fmb_row_images_init(fmb_row_images *t, const fmb_system *s, fmb_mem *mem)
{
    *t = (fmb_row_images){.s = s, .mem = mem, .dim = (size_t)fmb_system_dim(s), .slots = 2};
    while (t->slots < 2 * fmb_system_rows(s))
        t->slots *= 2;
    mpq_init(t->q);
    fmb_status st = open_row_images(t);
    fmb_status opened = fmb_num_init(&t->num, mem, t->dim + 1, false);
    st = st == FMB_OK ? opened : st;
    FMB_THEN(st, open_equalities(t));
    for (size_t i = 0; st == FMB_OK && i < fmb_system_rows(s); i++)
        st = enter_row(t, i);
    return st;
}

static void close_equalities(fmb_row_images *t)
{
    for (size_t e = 0; e < t->equalities; e++)
        fmb_rationals_free(t->equality[e], t->dim + 1, t->mem);
    fmb_mem_put(t->mem, t->equality, t->room, sizeof *t->equality);
    fmb_mem_put(t->mem, t->pivot, t->room, sizeof *t->pivot);
    fmb_rationals_free(t->x, t->dim + 1, t->mem);
}

void fmb_row_images_clear(fmb_row_images *t)
{
    size_t m = fmb_system_rows(t->s);
    for (size_t i = 0; t->row && i < m; i++) {
        fmb_row_image *r = &t->row[i];
        fmb_vec_clear(&r->v, r->size + 1, t->mem);
        fmb_mem_put(t->mem, r->v.s, r->size + 1, sizeof *r->v.s);
        fmb_mem_put(t->mem, r->var, r->size, sizeof *r->var);
    }
    close_equalities(t);
    mpq_clear(t->q);
    fmb_vec_block_free(t->z, t->dim + 1, t->mem);
    FMB_ARRAYS_PUT(t->mem, FMB_ARRAY(t->moved.v.s, t->dim + 1), FMB_ARRAY(t->moved.var, t->dim),
                   FMB_ARRAY(t->slot, t->slots), FMB_ARRAY(t->row, m));
    fmb_num_clear(&t->num);
}

/* ---- classes --------------------------------------------------------------------------------- */

static size_t first_of_class(size_t *class_of, size_t i)
{
    while (class_of[i] != i)
        i = class_of[i] = class_of[class_of[i]];
    return i;
}

static fmb_status join_row_with_image(fmb_row_images *t, size_t i, const int *image,
                                      size_t *class_of)
{
    size_t j;
    FMB_TRY(fmb_row_images_find(t, i, image, &j));
    if (j == SIZE_MAX)
        return FMB_OK;
    size_t a = first_of_class(class_of, i), b = first_of_class(class_of, j);
    class_of[a > b ? a : b] = a > b ? b : a;
    return FMB_OK;
}

fmb_status fmb_row_images_classes(fmb_row_images *t, const int *image, size_t *class_of)
{
    size_t m = fmb_system_rows(t->s);
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i < m; i++)
        st = join_row_with_image(t, i, image, class_of);
    for (size_t i = 0; i < m; i++)
        class_of[i] = first_of_class(class_of, i);
    return st;
}
