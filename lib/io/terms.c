/* terms.c: a row whose numbers are given as texts. */
#include "io/terms.h"

#include <string.h>

#include "io/core/io_private.h"
#include "system/system_private.h"

/* The state of reading the numbers of a row, with one budget for all. */
typedef struct row_of_text {
    char wrong[FMB_IO_WRONG_SIZE]; /* which number, and what was expected */
    fmb_mem mem;
    fmb_where where;
    fmb_cursor c;
    fmb_draft draft;
} row_of_text;

static fmb_status read_whole_number(fmb_cursor *c, mpq_t out)
{
    FMB_TRY(fmb_io_check(c));
    FMB_TRY(fmb_scan_number(c, FMB_NUM_ALL, "a number", out));
    return c->at < c->end ? fmb_io_expected(c, c->at, "the end of the number") : FMB_OK;
}

/* Read the number that is the whole text; name identifies it in messages. */
static fmb_status read_number_of_row(row_of_text *r, const char *text, const char *name, mpq_t out)
{
    static const fmb_reader plain;
    size_t left = r->c.budget, size = strlen(text);
    r->c = fmb_io_cursor(text, size, &plain, &r->mem, &r->where);
    r->c.budget = left;
    fmb_status st = read_whole_number(&r->c, out);
    if (st == FMB_ERR_PARSE)
        snprintf(r->wrong, sizeof r->wrong, "%s: %.110s", name, r->where.text);
    return st;
}

static fmb_status read_coefficient(row_of_text *r, size_t k, const char *text, mpq_t out)
{
    char name[48];
    snprintf(name, sizeof name, "coefficient of term %zu", k);
    return read_number_of_row(r, text, name, out);
}

static fmb_status read_terms(row_of_text *r, size_t n, const int *var, const char *const *coef)
{
    for (size_t k = 0; k < n; k++) {
        mpq_ptr slot;
        FMB_TRY(fmb_draft_term(&r->draft, var[k], &slot));
        FMB_TRY(read_coefficient(r, k, coef[k], slot));
    }
    return FMB_OK;
}

/* Write which required pointer is NULL; "" if none is. */
static void check_row_of_text(size_t n, const int *var, const char *const *coef, const char *b,
                              char wrong[FMB_IO_WRONG_SIZE])
{
    *wrong = '\0';
    if (n > 0 && (!var || !coef))
        snprintf(wrong, FMB_IO_WRONG_SIZE, "%s NULL", coef ? "variables are" : "coefficients are");
    else if (!b)
        snprintf(wrong, FMB_IO_WRONG_SIZE, "right side is NULL");
    for (size_t k = 0; !*wrong && k < n; k++)
        if (!coef[k])
            snprintf(wrong, FMB_IO_WRONG_SIZE, "coefficient of term %zu is NULL", k);
}

/* The budget that one text of all these numbers would have. */
static size_t row_budget(size_t n, const char *const *coef, const char *b)
{
    size_t size = strlen(b);
    for (size_t k = 0; k < n; k++)
        size += strlen(coef[k]);
    return fmb_io_budget(size);
}

fmb_status fmb_system_add_terms_text(fmb_system *s, size_t n, const int *var,
                                     const char *const *coef, fmb_rel rel, const char *b)
{
    row_of_text r = {.wrong = ""};
    if (!s)
        return FMB_ERR_ARG;
    check_row_of_text(n, var, coef, b, r.wrong);
    if (*r.wrong)
        return fmb_system_refuse(s, "%s", r.wrong);
    r.c.budget = row_budget(n, coef, b);
    fmb_mem_init(&r.mem, &s->mem.alloc, 0);
    fmb_draft_init(&r.draft, &r.mem);
    fmb_status st = read_terms(&r, n, var, coef);
    FMB_THEN(st, read_number_of_row(&r, b, "right side", r.draft.rhs));
    if (st == FMB_ERR_PARSE)
        (void)fmb_system_refuse(s, "%s", r.wrong);
    if (st == FMB_OK) {
        st = fmb_draft_append(&r.c, r.c.begin, &r.draft, rel, s);
        if (st == FMB_ERR_PARSE)
            (void)fmb_system_refuse(s, "the row: %.120s", r.where.text);
    }
    fmb_draft_clear(&r.draft);
    return st;
}

fmb_status fmb_io_row_numbers(size_t n, const int *var, const char *const *coef, const char *b,
                              const fmb_mem *mem, mpq_t *q, char wrong[FMB_IO_WRONG_SIZE])
{
    row_of_text r = {.wrong = ""};
    fmb_status st = FMB_OK;
    fmb_mem_init(&r.mem, &mem->alloc, 0);
    check_row_of_text(n, var, coef, b, r.wrong);
    if (*r.wrong)
        st = FMB_ERR_ARG;
    else
        r.c.budget = row_budget(n, coef, b);
    for (size_t k = 0; st == FMB_OK && k < n; k++)
        st = read_coefficient(&r, k, coef[k], q[k]);
    FMB_THEN(st, read_number_of_row(&r, b, "right side", q[n]));
    memcpy(wrong, r.wrong, sizeof r.wrong);
    return st;
}
