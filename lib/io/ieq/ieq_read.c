/* ieq_read.c: inequality files of PORTA.
 *
 *   DIM = n, then sections, then INEQUALITIES_SECTION with a row a line, "(3) +2x1-1/2x4 <= 1", END
 *
 * Bounds are those of the integer points that PORTA counts, not of the polyhedron: they are
 * ignored with a warning. ELIMINATION_ORDER has a number for each variable, 0 for kept ones.
 * Source: T. Christof, A. Loebel, PORTA 1.4, man page "porta".
 */
#include "io/core/cursor.h"
#include "io/core/io_private.h"

typedef struct ieq {
    fmb_cursor *c;
    fmb_system *s;
    bool has_dim;
    fmb_draft d;
    mpq_t value;
} ieq;

/* ---- rows ------------------------------------------------------------------------------------ */

/* "x7": its variable. */
static fmb_status read_variable_index(ieq *f, int *j)
{
    size_t index = 0;
    const char *p = ++f->c->at;
    FMB_TRY(fmb_scan_count(f->c, SIZE_MAX / 2, "the number of a variable", &index));
    if (index < 1 || index > (size_t)fmb_system_dim(f->s))
        return fmb_io_fail(f->c, p, "expected a variable between 1 and %d", fmb_system_dim(f->s));
    *j = (int)index - 1;
    return FMB_OK;
}

/* Read a number, a variable, or both, into the draft: a constant is moved to the right side. */
static fmb_status read_term_or_constant(ieq *f, bool minus)
{
    fmb_cursor *c = f->c;
    fmb_status st = FMB_OK;
    int j = 0;
    fmb_skip_blanks(c);
    mpq_set_ui(f->value, 1, 1);
    if (fmb_peek(c) != 'x' && fmb_peek(c) != 'X')
        st = fmb_scan_number(c, FMB_NUM_DECIMAL | FMB_NUM_EXPONENT | FMB_NUM_FRACTION,
                             "a number or a variable", f->value);
    if (st == FMB_OK && minus)
        mpq_neg(f->value, f->value);
    fmb_skip_blanks(c);
    if (st == FMB_OK && fmb_peek(c) != 'x' && fmb_peek(c) != 'X') {
        mpq_sub(f->d.rhs, f->d.rhs, f->value);
        return fmb_io_charge(c, c->at, fmb_io_digits(f->d.rhs));
    }
    FMB_THEN(st, read_variable_index(f, &j));
    return st == FMB_OK ? fmb_draft_add(&f->d, j, f->value) : st;
}

/* Read items with signs between them; right: of the right side. */
static fmb_status read_side_of_row(ieq *f, bool right)
{
    fmb_cursor *c = f->c;
    fmb_status st;
    bool minus = false, more;
    fmb_skip_blanks(c);
    minus = fmb_accept(c, "-");
    if (!minus)
        (void)fmb_accept(c, "+");
    do {
        st = read_term_or_constant(f, minus != right);
        fmb_skip_blanks(c);
        minus = st == FMB_OK && fmb_accept(c, "-");
        more = st == FMB_OK && (minus || fmb_accept(c, "+"));
    } while (more);
    return st;
}

static fmb_status read_porta_relation(fmb_cursor *c, fmb_rel *rel)
{
    const char *p = c->at;
    *rel = FMB_GE;
    if (fmb_accept(c, ">=") || fmb_accept(c, "=>"))
        return FMB_OK;
    *rel = FMB_LE;
    if (fmb_accept(c, "<=") || fmb_accept(c, "=<"))
        return FMB_OK;
    *rel = FMB_EQ;
    if (fmb_accept(c, "==") || fmb_accept(c, "="))
        return FMB_OK;
    return fmb_io_expected(c, p, "'+', '-', '<=', '>=' or '=='");
}

static fmb_status read_porta_row(ieq *f)
{
    fmb_cursor *c = f->c;
    const char *start = c->at;
    size_t number;
    fmb_rel rel = FMB_LE;
    fmb_status st = FMB_OK;
    fmb_draft_reset(&f->d);
    if (fmb_accept(c, "(")) {
        fmb_skip_blanks(c);
        st = fmb_scan_count(c, SIZE_MAX / 2, "the number of a row", &number);
        fmb_skip_blanks(c);
        if (st == FMB_OK && !fmb_accept(c, ")"))
            st = fmb_io_fail(c, c->at, "expected ')' after the number of a row");
    }
    FMB_THEN(st, read_side_of_row(f, false));
    FMB_THEN(st, read_porta_relation(c, &rel));
    FMB_THEN(st, read_side_of_row(f, true));
    if (st == FMB_OK && fmb_peek(c) >= 0 && fmb_peek(c) != '\n')
        st = fmb_io_expected(c, c->at, "end of line after a row");
    if (st != FMB_OK)
        return st;
    return fmb_draft_append(c, start, &f->d, rel, f->s);
}

/* ---- sections -------------------------------------------------------------------------------- */

static fmb_status read_dim_section(ieq *f, const char *word)
{
    fmb_cursor *c = f->c;
    size_t n = 0;
    if (f->has_dim)
        return fmb_io_fail(c, word, "expected one DIM line, found another");
    fmb_skip_space(c);
    if (!fmb_accept(c, "="))
        return fmb_io_expected(c, c->at, "'=' after DIM");
    fmb_skip_space(c);
    const char *p = c->at;
    fmb_status st = fmb_scan_count(c, SIZE_MAX / 2, "a number of variables", &n);
    FMB_THEN(st, fmb_io_declare(c, p, n, f->s));
    f->has_dim = true;
    return st;
}

/* A number for each variable. */
static fmb_status read_number_per_variable(ieq *f)
{
    for (int j = 0; j < fmb_system_dim(f->s); j++) {
        fmb_skip_space(f->c);
        FMB_TRY(fmb_scan_number(f->c, FMB_NUM_ALL, "a number for each variable", f->value));
    }
    return FMB_OK;
}

static fmb_status pass_over_valid_point(ieq *f, const char *word)
{
    (void)word;
    return read_number_per_variable(f);
}

static fmb_status ignore_integer_bounds(ieq *f, const char *word)
{
    fmb_io_warn(f->c, word, "ignored: bounds of integer points");
    return read_number_per_variable(f);
}

static fmb_status read_elimination_order(ieq *f, const char *word)
{
    (void)word;
    for (int j = 0; j < fmb_system_dim(f->s); j++) {
        size_t place = 0;
        fmb_skip_space(f->c);
        FMB_TRY(fmb_scan_count(f->c, SIZE_MAX / 2, "a place in the order, or 0, for each variable",
                               &place));
        fmb_system_set_kept(f->s, j, place == 0);
    }
    return FMB_OK;
}

static fmb_status read_inequalities(ieq *f, const char *word)
{
    fmb_cursor *c = f->c;
    (void)word;
    for (fmb_skip_space(c); c->at < c->end; fmb_skip_space(c)) {
        int b = fmb_peek(c);
        if (!fmb_starts_number(b) && b != '(' && b != 'x' && b != 'X')
            break;
        FMB_TRY(read_porta_row(f));
    }
    return FMB_OK;
}

static fmb_status refuse_points_section(ieq *f, const char *word)
{
    return fmb_io_fail(f->c, word, "expected inequalities, found points or rays (a .poi file)");
}

static const struct section {
    const char *word;
    fmb_status (*read)(ieq *f, const char *word);
} sections[] = {
    {"VALID", pass_over_valid_point},
    {"LOWER_BOUNDS", ignore_integer_bounds},
    {"UPPER_BOUNDS", ignore_integer_bounds},
    {"ELIMINATION_ORDER", read_elimination_order},
    {"INEQUALITIES_SECTION", read_inequalities},
    {"CONV_SECTION", refuse_points_section},
    {"CONE_SECTION", refuse_points_section},
};

/* Letters and underscores. */
static fmb_span scan_section_keyword(fmb_cursor *c)
{
    const char *p = c->at;
    while (fmb_peek(c) == '_' || ((fmb_peek(c) | 32) >= 'a' && (fmb_peek(c) | 32) <= 'z'))
        c->at++;
    return (fmb_span){p, (size_t)(c->at - p)};
}

/* One section; *end at the word END. */
static fmb_status read_next_section(ieq *f, bool *end)
{
    fmb_cursor *c = f->c;
    fmb_skip_space(c);
    fmb_span word = scan_section_keyword(c);
    if (fmb_span_is_nocase(word, "DIM"))
        return read_dim_section(f, word.p);
    if (!f->has_dim)
        return fmb_io_expected(c, word.p, "'DIM = n' first");
    *end = fmb_span_is_nocase(word, "END");
    if (*end)
        return FMB_OK;
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        if (fmb_span_is_nocase(word, sections[i].word))
            return sections[i].read(f, word.p);
    return fmb_io_expected(c, word.p, "a row, the name of a section or END");
}

fmb_status fmb_read_ieq(fmb_cursor *c, fmb_system *s)
{
    ieq f = {.c = c, .s = s};
    bool end = false;
    fmb_status st = FMB_OK;
    fmb_draft_init(&f.d, c->mem);
    mpq_init(f.value);
    while (st == FMB_OK && !end)
        st = read_next_section(&f, &end);
    mpq_clear(f.value);
    fmb_draft_clear(&f.d);
    return st;
}
