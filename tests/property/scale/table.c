/* table.c: see table.h. */
#include "property/scale/table.h"

#include <stdlib.h>

void law_table_open(law_table *t, int width)
{
    *t = (law_table){.width = width};
}

static mpq_t *row_of(const law_table *t, size_t i)
{
    return t->number + i * (size_t)t->width;
}

void law_table_close(law_table *t)
{
    for (size_t k = 0; k < t->size * (size_t)t->width; k++)
        mpq_clear(t->number[k]);
    free(t->number);
    free(t->kind);
}

mpq_t *law_table_append(law_table *t, int kind)
{
    size_t width = (size_t)t->width, i = t->size++;
    t->number = realloc(t->number, t->size * width * sizeof *t->number);
    t->kind = realloc(t->kind, t->size * sizeof *t->kind);
    if (!t->number || !t->kind)
        abort();
    t->kind[i] = kind;
    for (size_t j = 0; j < width; j++)
        mpq_init(row_of(t, i)[j]);
    return row_of(t, i);
}

/* ---- the normal form ------------------------------------------------------------------------- */

static int find_first(const law_table *t, size_t i)
{
    int j = 0;
    while (j < t->width && mpq_sgn(row_of(t, i)[j]) == 0)
        j++;
    return j;
}

/* Divide row i by entry j, or by its absolute value. */
static void divide_by_entry(law_table *t, size_t i, int j, bool absolute)
{
    mpq_t by;
    mpq_init(by);
    mpq_set(by, row_of(t, i)[j]);
    if (absolute)
        mpq_abs(by, by);
    for (int k = 0; k < t->width; k++)
        mpq_div(row_of(t, i)[k], row_of(t, i)[k], by);
    mpq_clear(by);
}

/* Row i less so many times row r that its entry j, which is 1 in row r, becomes 0. */
static void cancel_entry(law_table *t, size_t i, size_t r, int j)
{
    mpq_t by, part;
    mpq_inits(by, part, NULL);
    mpq_set(by, row_of(t, i)[j]);
    for (int k = 0; k < t->width; k++) {
        mpq_mul(part, by, row_of(t, r)[k]);
        mpq_sub(row_of(t, i)[k], row_of(t, i)[k], part);
    }
    mpq_clears(by, part, NULL);
}

/* Gauss and Jordan: unique for a span, and for each row beside it, up to the factor. */
static void make_normal(law_table *t)
{
    for (size_t r = 0; r < t->size; r++) {
        int pivot = t->kind[r] == LAW_SPANS ? find_first(t, r) : t->width;
        if (pivot == t->width)
            continue;
        divide_by_entry(t, r, pivot, false);
        for (size_t i = 0; i < t->size; i++)
            if (i != r)
                cancel_entry(t, i, r, pivot);
    }
    for (size_t i = 0; i < t->size; i++) {
        int first = find_first(t, i);
        if (t->kind[i] != LAW_SPANS && first < t->width)
            divide_by_entry(t, i, first, true);
    }
}

/* Nothing but 0 spans nothing. */
static bool is_idle(const law_table *t, size_t i)
{
    return t->kind[i] == LAW_SPANS && find_first(t, i) == t->width;
}

static bool has_row(const law_table *t, const law_table *of, size_t i)
{
    for (size_t k = 0; k < t->size; k++) {
        int j = 0;
        while (j < t->width && mpq_equal(row_of(t, k)[j], row_of(of, i)[j]))
            j++;
        if (j == t->width && t->kind[k] == of->kind[i])
            return true;
    }
    return false;
}

static bool has_all_rows(const law_table *t, const law_table *of)
{
    for (size_t i = 0; i < of->size; i++)
        if (!is_idle(of, i) && !has_row(t, of, i))
            return false;
    return true;
}

bool law_same_tables(law_table *a, law_table *b)
{
    make_normal(a);
    make_normal(b);
    return a->width == b->width && has_all_rows(a, b) && has_all_rows(b, a);
}
