/* group.c: generators, each of which is checked; see group.h. */
#include "symmetry/group.h"

#include <string.h>

void fmb_group_init(fmb_group *g, fmb_mem *mem, size_t n, size_t m)
{
    *g = (fmb_group){.mem = mem, .n = n, .m = m};
}

void fmb_group_clear(fmb_group *g)
{
    if (!g->mem)
        return;
    for (size_t k = 0; k < g->size; k++)
        fmb_mem_put(g->mem, g->image[k], g->n + g->m, sizeof **g->image);
    fmb_mem_put(g->mem, g->image, g->capacity, sizeof *g->image);
    *g = (fmb_group){0};
}

/* ---- is it a symmetry ------------------------------------------------------------------------ */

/* Is image[n] a permutation of n numbers? met[n] is scratch. */
static bool is_permutation(const uint32_t *image, size_t n, bool *met)
{
    memset(met, 0, n * sizeof *met);
    for (size_t j = 0; j < n; j++) {
        if (image[j] >= n || met[image[j]])
            return false;
        met[image[j]] = true;
    }
    return true;
}

/* The term of a row in that column; the size of the row if there is none. */
static size_t find_term(const fmb_program_row *r, int column)
{
    size_t low = 0, high = r->size;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (r->column[middle] < column)
            low = middle + 1;
        else
            high = middle;
    }
    return low < r->size && r->column[low] == column ? low : r->size;
}

static bool are_entries_equal(const fmb_vec *a, size_t i, const fmb_vec *b, size_t j)
{
    if (!a->z && !b->z)
        return a->s[i] == b->s[j];
    if (a->z && b->z)
        return mpz_cmp(a->z[i], b->z[j]) == 0;
    return a->z ? fmb_integer_compare_i64(a->z[i], b->s[j]) == 0
                : fmb_integer_compare_i64(b->z[j], a->s[i]) == 0;
}

/* Is row a, with its columns permuted, row b? */
static bool is_row_taken_to(const fmb_program_row *a, const fmb_program_row *b,
                            const uint32_t *column)
{
    if (a->size != b->size || a->rel != b->rel || a->off != b->off ||
        !are_entries_equal(a->value, a->size, b->value, b->size))
        return false;
    for (size_t k = 0; k < a->size; k++) {
        size_t t = find_term(b, (int)column[a->column[k]]);
        if (t == b->size || !are_entries_equal(a->value, k, b->value, t))
            return false;
    }
    return true;
}

static bool moves_kept_columns_alone(const bool *keeps, const uint32_t *image, size_t n)
{
    bool moves = false;
    for (size_t j = 0; j < n; j++) {
        if (keeps[j] != keeps[image[j]])
            return false;
        moves |= keeps[j] && image[j] != j;
    }
    return moves;
}

static bool is_symmetry(const fmb_group *g, const fmb_program *p, const bool *keeps,
                        const uint32_t *image, bool *met)
{
    if (!is_permutation(image, g->n, met) || !is_permutation(image + g->n, g->m, met) ||
        !moves_kept_columns_alone(keeps, image, g->n))
        return false;
    for (size_t i = 0; i < g->m; i++)
        if (!is_row_taken_to(&p->row[i], &p->row[image[g->n + i]], image))
            return false;
    return true;
}

/* ---- generators ------------------------------------------------------------------------------ */

static fmb_status append_generator(fmb_group *g, const uint32_t *image)
{
    size_t length = g->n + g->m;
    FMB_TRY(FMB_RESERVE(g->mem, &g->image, &g->capacity, g->size + 1));
    uint32_t *copy;
    FMB_TRY(FMB_GET(g->mem, copy, length));
    memcpy(copy, image, length * sizeof *copy);
    g->image[g->size++] = copy;
    return FMB_OK;
}

fmb_status fmb_group_add(fmb_group *g, const fmb_program *p, const bool *keeps,
                         const uint32_t *image, bool *fits)
{
    size_t most = g->n > g->m ? g->n : g->m;
    bool *met;
    FMB_TRY(FMB_GET(g->mem, met, most));
    *fits = is_symmetry(g, p, keeps, image, met);
    fmb_mem_put(g->mem, met, most, sizeof *met);
    return *fits ? append_generator(g, image) : FMB_OK;
}
