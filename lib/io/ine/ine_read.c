/* ine_read.c: H-representations of cddlib and lrslib: b + a.x >= 0.
 *
 * Rows are delimited by counts of numbers, not by lines. The sizes in the header are only compared
 * with the data: memory grows with the numbers read.
 * Source: K. Fukuda, cddlib reference manual 0.94, section 4; D. Avis, lrslib user's guide 7.
 */
#include "io/core/cursor.h"
#include "io/ine/ine.h"

/* Past white space and comment lines. */
static void skip_star_comments(fmb_cursor *c)
{
    fmb_skip_space(c);
    while (fmb_peek(c) == '*') {
        fmb_next_line(c);
        fmb_skip_space(c);
    }
}

/* ---- header ---------------------------------------------------------------------------------- */

typedef struct shape {
    size_t rows, columns;
    bool open; /* the number of rows is written "*****": any number */
    const char *at;
} shape;

/* "m d type". */
static fmb_status read_matrix_shape(fmb_cursor *c, shape *h)
{
    fmb_skip_space(c);
    h->at = c->at;
    h->open = fmb_peek(c) == '*';
    fmb_status st = FMB_OK;
    if (h->open)
        (void)fmb_scan_word(c);
    else
        st = fmb_scan_count(c, SIZE_MAX / 2, "a number of rows", &h->rows);
    fmb_skip_space(c);
    const char *columns = c->at;
    FMB_THEN(st, fmb_scan_count(c, SIZE_MAX / 2, "a number of columns", &h->columns));
    if (st == FMB_OK && h->columns == 0)
        st = fmb_io_fail(c, columns, "expected at least one column");
    if (st != FMB_OK)
        return st;
    fmb_skip_space(c);
    const char *p = c->at;
    fmb_span type = fmb_scan_word(c);
    if (fmb_span_is_nocase(type, "integer") || fmb_span_is_nocase(type, "rational") ||
        fmb_span_is_nocase(type, "real"))
        return FMB_OK;
    return fmb_io_expected(c, p, "'integer', 'rational' or 'real'");
}

/* Titles and options up to "begin". */
static fmb_status read_lines_before_matrix(fmb_ine *f)
{
    fmb_cursor *c = f->c;
    for (skip_star_comments(c); c->at < c->end; skip_star_comments(c)) {
        const char *line = c->at;
        f->matrix = line;
        if (fmb_span_is_nocase(fmb_scan_word(c), "begin"))
            return FMB_OK;
        c->at = line;
        bool known;
        FMB_TRY(fmb_ine_option(f, &known));
        if (!known) /* a title */
            fmb_next_line(c);
    }
    return fmb_io_fail(c, c->at, "expected a line 'begin', found end of file");
}

/* ---- matrix ---------------------------------------------------------------------------------- */

/* A row of generators begins with 1 or 0. */
static fmb_status check_generator(fmb_cursor *c, const char *p, const mpq_t value)
{
    return mpq_sgn(value) == 0 || mpq_cmp_ui(value, 1, 1) == 0
               ? FMB_OK
               : fmb_io_expected(c, p, "1 for a vertex or 0 for a ray");
}

/* Column j of a row into d: b, then a_j: b + a.x >= 0 is -a.x <= b. */
static fmb_status read_matrix_entry(fmb_ine *f, size_t j, mpq_t value, fmb_draft *d)
{
    const char *p = f->c->at;
    FMB_TRY(fmb_ine_number(f->c, value));
    if (j == 0 && f->generators)
        FMB_TRY(check_generator(f->c, p, value));
    if (j > (size_t)fmb_system_dim(f->s))
        FMB_TRY(fmb_system_add_variable(f->s, NULL, NULL));
    if (mpq_sgn(value) == 0)
        return FMB_OK;
    if (j == 0) {
        mpq_set(d->rhs, value);
        return FMB_OK;
    }
    mpq_neg(value, value);
    return fmb_draft_add(d, (int)j - 1, value);
}

static fmb_status read_matrix_row(fmb_ine *f, const shape *h, mpq_t value, fmb_draft *d)
{
    fmb_cursor *c = f->c;
    fmb_draft_reset(d);
    const char *start = c->at;
    for (size_t j = 0; j < h->columns; j++) {
        skip_star_comments(c);
        if (!fmb_starts_number(fmb_peek(c)))
            return fmb_io_expected(c, c->at, "number %zu of the %zu of row %zu", j + 1, h->columns,
                                   fmb_system_rows(f->s) + 1);
        FMB_TRY(read_matrix_entry(f, j, value, d));
    }
    return fmb_draft_append(c, start, d, FMB_LE, f->s);
}

static fmb_status read_matrix_rows(fmb_ine *f, const shape *h)
{
    fmb_cursor *c = f->c;
    fmb_status st = FMB_OK;
    fmb_draft d;
    mpq_t value;
    fmb_draft_init(&d, c->mem);
    mpq_init(value);
    for (size_t i = 0; st == FMB_OK && (h->open || i < h->rows); i++) {
        skip_star_comments(c);
        if (h->open && !fmb_starts_number(fmb_peek(c)))
            break;
        st = read_matrix_row(f, h, value, &d);
    }
    mpq_clear(value);
    fmb_draft_clear(&d);
    if (st == FMB_OK && fmb_system_rows(f->s) == 0)
        st = fmb_io_declare(c, h->at, h->columns - 1, f->s);
    return st;
}

/* cddlib and lrslib read as many rows as the header says and ignore the rest: so surplus whole rows
 * are ignored with a warning. */
static fmb_status skip_surplus_rows(fmb_cursor *c, const shape *h)
{
    size_t n = 0;
    fmb_status st = FMB_OK;
    mpq_t value;
    skip_star_comments(c);
    const char *first = c->at;
    mpq_init(value);
    for (; st == FMB_OK && fmb_starts_number(fmb_peek(c)); skip_star_comments(c), n++)
        st = fmb_ine_number(c, value);
    mpq_clear(value);
    if (st == FMB_OK && n % h->columns != 0)
        return fmb_io_expected(c, first, "'end' after %zu rows", h->rows);
    if (st == FMB_OK && n > 0)
        fmb_io_warn(c, first, "ignored: %zu rows more than the %zu of the header", n / h->columns,
                    h->rows);
    return st;
}

static fmb_status read_ine_matrix(fmb_ine *f)
{
    fmb_cursor *c = f->c;
    shape h = {0};
    FMB_TRY(read_matrix_shape(c, &h));
    FMB_TRY(read_matrix_rows(f, &h));
    FMB_TRY(skip_surplus_rows(c, &h));
    const char *p = c->at;
    if (!fmb_span_is_nocase(fmb_scan_word(c), "end"))
        return fmb_io_expected(c, p, "'end' after %zu rows", fmb_system_rows(f->s));
    fmb_next_line(c);
    return FMB_OK;
}

/* ---- the rest -------------------------------------------------------------------------------- */

static fmb_status read_lines_after_matrix(fmb_ine *f)
{
    fmb_cursor *c = f->c;
    for (skip_star_comments(c); c->at < c->end; skip_star_comments(c)) {
        char found[FMB_QUOTE];
        const char *line = c->at;
        if (fmb_span_is_nocase(fmb_scan_word(c), "begin"))
            return fmb_io_fail(c, line, "expected one matrix, found a second 'begin'");
        c->at = line;
        bool known;
        FMB_TRY(fmb_ine_option(f, &known));
        if (known)
            continue;
        fmb_io_warn(c, line, "ignored: unknown option %s", fmb_quote(c, line, found));
        fmb_ine_skip_arguments(c);
    }
    return FMB_OK;
}

fmb_status fmb_ine_read(fmb_ine *f)
{
    fmb_status st = read_lines_before_matrix(f);
    FMB_THEN(st, read_ine_matrix(f));
    FMB_THEN(st, read_lines_after_matrix(f));
    FMB_THEN(st, fmb_ine_take_names(f));
    FMB_THEN(st, fmb_ine_finish(f));
    fmb_ine_clear(f);
    return st;
}

fmb_status fmb_read_ine(fmb_cursor *c, fmb_system *s)
{
    return fmb_ine_read(&(fmb_ine){.c = c, .s = s});
}
