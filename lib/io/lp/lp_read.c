/* lp_read.c: linear programs as CPLEX LP files have them.
 *
 *   objective:  ("minimize" | "maximize") [label:] [sum]
 *   rows:       "subject to" {[label:] row}     row: sum REL sum | end REL sum [REL end]
 *   others:     "bounds" {row of one variable | name "free"}, "general" {name}, "binary" {name},
 *               in any order; "end"
 *
 * A row may be broken into lines anywhere, with one exception: after `sum REL sum`, a new line
 * begins a new row, else `x <= 3` and `y >= 1` below it would be one. Variables have the lower
 * bound 0, binary ones the upper bound 1 unless bounds differ; the last of several bounds counts.
 *
 * Sources: as in token.h.
 */
#include "io/lp/token.h"
#include "io/program/program_draft.h"

typedef struct lp_reader {
    fmb_program_draft program;
    fmb_cursor *c;
    fmb_lp_token next;
    mpq_t value;   /* of the next token, if it is a number */
    fmb_draft row; /* the one that is being read */
    const char *at;
    fmb_program_end end[2]; /* of the row */
    mpq_t scratch;
    int infinite; /* the sum last read: -1, 1, or 0 for a finite one */
} lp_reader;

/* Read the next token. A keyword inside a line that is the name of a variable is a name. */
static fmb_status next_lp_token(lp_reader *r)
{
    fmb_lp_token *t = &r->next;
    int j = -1;
    FMB_TRY(fmb_lp_scan(r->c, t, r->value));
    if (t->kind == FMB_LP_KEYWORD && !t->starts_line)
        FMB_TRY(fmb_span_find(r->c, t->text, r->program.s, &j));
    if (j >= 0) {
        t->kind = FMB_LP_NAME;
        r->c->at = t->text.p + t->text.n;
    }
    return FMB_OK;
}

static fmb_status fail_lp(lp_reader *r, const char *what)
{
    const char *p = r->next.text.p;
    return fmb_io_expected(r->c, p, "%s", what);
}

static bool is_infinity(const fmb_lp_token *t)
{
    return t->kind == FMB_LP_NAME && !t->is_label &&
           (fmb_span_is_nocase(t->text, "inf") || fmb_span_is_nocase(t->text, "infinity"));
}

/* ---- sums ------------------------------------------------------------------------------------ */

/* The extent of a sum: over all lines, to the end of its line, over numbers only. */
typedef enum lp_reach { LP_ALL_LINES, LP_ONE_LINE, LP_NUMBERS } lp_reach;

static bool has_variable_next(const lp_reader *r, lp_reach reach, bool inside)
{
    return r->next.kind == FMB_LP_NAME && !r->next.is_label && !is_infinity(&r->next) &&
           reach != LP_NUMBERS && !(inside && reach == LP_ONE_LINE && r->next.starts_line);
}

/* Read [number] [name] into the row: a constant is moved to the right side. */
static fmb_status read_lp_term(lp_reader *r, bool minus, lp_reach reach)
{
    const char *at = r->next.text.p;
    fmb_status st = FMB_OK;
    int j = 0;
    bool number = r->next.kind == FMB_LP_NUMBER;
    if (!number && !has_variable_next(r, reach, false))
        return fail_lp(r, reach == LP_NUMBERS ? "a number or infinity" : "a number or a variable");
    mpq_set_si(r->scratch, 1, 1);
    if (number) {
        mpq_set(r->scratch, r->value);
        st = next_lp_token(r);
    }
    if (minus)
        mpq_neg(r->scratch, r->scratch);
    if (st == FMB_OK && !has_variable_next(r, reach, number)) {
        mpq_sub(r->row.rhs, r->row.rhs, r->scratch);
        return fmb_io_charge(r->c, at, fmb_io_digits(r->row.rhs));
    }
    FMB_THEN(st, fmb_program_variable(&r->program, r->next.text, &j));
    FMB_THEN(st, fmb_draft_add(&r->row, j, r->scratch));
    return st == FMB_OK ? next_lp_token(r) : st;
}

/* Read a sum, times -1 if minus, into the row; or an infinity alone. */
static fmb_status read_lp_sum(lp_reader *r, bool minus, lp_reach reach)
{
    fmb_status st = FMB_OK;
    r->infinite = 0;
    for (bool first = true;; first = false) {
        bool negative = minus;
        for (; st == FMB_OK && r->next.kind == FMB_LP_SIGN; st = next_lp_token(r))
            negative = negative != r->next.minus;
        if (st == FMB_OK && first && is_infinity(&r->next)) {
            r->infinite = negative == minus ? 1 : -1;
            return next_lp_token(r);
        }
        FMB_THEN(st, read_lp_term(r, negative, reach));
        if (st != FMB_OK || r->next.kind != FMB_LP_SIGN ||
            (reach != LP_ALL_LINES && r->next.starts_line))
            return st;
    }
}

/* ---- rows ------------------------------------------------------------------------------------ */

static fmb_status read_lp_relation(lp_reader *r, int *relation)
{
    *relation = r->next.relation;
    return r->next.kind == FMB_LP_RELATION ? next_lp_token(r)
                                           : fail_lp(r, "an operator, or one of <=, = and >=");
}

/* terms REL value, infinite as r says: an end of the row, or both. */
static fmb_status set_lp_ends(lp_reader *r, int relation, mpq_srcptr value)
{
    if (r->infinite != 0 && r->infinite != -relation)
        return fmb_io_fail(r->c, r->at, "expected a finite side: nothing satisfies this");
    for (int e = 0; e < 2; e++) {
        if (relation == (e == FMB_PROGRAM_LOW ? -1 : 1))
            continue;
        r->end[e].at = r->at;
        r->end[e].finite =
            r->infinite == 0 &&
            (relation == 0 || !fmb_program_is_infinite(&r->program, r->at, value, e));
        mpq_set(r->end[e].value, value);
    }
    return FMB_OK;
}

/* After a first end, which is minus the current right side of the row, read REL sum [REL end]. */
static fmb_status read_lp_range(lp_reader *r, lp_reach reach)
{
    int relation = 0, second = 0, infinite = r->infinite;
    mpq_t first;
    mpq_init(first);
    mpq_neg(first, r->row.rhs);
    fmb_draft_reset(&r->row);
    fmb_status st = read_lp_relation(r, &relation);
    FMB_THEN(st, read_lp_sum(r, false, reach));
    if (st == FMB_OK && r->infinite != 0)
        st = fail_lp(r, "a finite sum between the ends");
    mpq_add(first, first, r->row.rhs);
    r->infinite = infinite;
    FMB_THEN(st, set_lp_ends(r, -relation, first));
    mpq_clear(first);
    if (st != FMB_OK || r->next.kind != FMB_LP_RELATION)
        return st;
    if (relation == 0 || r->next.relation != relation)
        return fail_lp(r, "the same relation, <= or >=, twice");
    st = read_lp_relation(r, &second);
    FMB_THEN(st, read_lp_sum(r, true, LP_NUMBERS));
    return st == FMB_OK ? set_lp_ends(r, second, r->row.rhs) : st;
}

/* Read sum REL sum, or end REL sum [REL end], or among bounds `name free`. reach: the extent of a
 * sum on the left; on the right it is one step less. */
static fmb_status read_lp_sides(lp_reader *r, lp_reach reach)
{
    int relation = 0;
    fmb_status st = read_lp_sum(r, false, reach);
    if (st != FMB_OK || r->row.n == 0)
        return st == FMB_OK ? read_lp_range(r, reach) : st;
    if (reach == LP_ONE_LINE && r->next.kind == FMB_LP_NAME &&
        fmb_span_is_nocase(r->next.text, "free")) {
        r->end[0].at = r->end[1].at = r->at;
        return next_lp_token(r);
    }
    st = read_lp_relation(r, &relation);
    FMB_THEN(st, read_lp_sum(r, true, reach + 1));
    return st == FMB_OK ? set_lp_ends(r, relation, r->row.rhs) : st;
}

static void begin_lp_row(lp_reader *r)
{
    fmb_draft_reset(&r->row);
    r->at = r->next.text.p;
    for (int e = 0; e < 2; e++) {
        r->end[e].at = NULL;
        r->end[e].finite = false;
    }
}

static fmb_status read_lp_label(lp_reader *r, fmb_span *label)
{
    *label = (fmb_span){r->next.text.p, 0};
    if (!r->next.is_label)
        return FMB_OK;
    *label = r->next.text;
    FMB_TRY(next_lp_token(r));
    return next_lp_token(r);
}

/* keyword: "minimize" or one of its like. */
static fmb_status read_lp_objective(lp_reader *r, fmb_span keyword)
{
    fmb_span label;
    bool max = fmb_span_is_nocase((fmb_span){keyword.p, 3}, "max");
    begin_lp_row(r);
    FMB_TRY(read_lp_label(r, &label));
    if (r->next.kind != FMB_LP_KEYWORD)
        FMB_TRY(read_lp_sum(r, false, LP_ALL_LINES));
    if (r->infinite != 0)
        return fmb_io_fail(r->c, r->at, "expected a finite objective");
    return fmb_draft_set_objective(r->c, r->at, &r->row, max ? FMB_SENSE_MAX : FMB_SENSE_MIN,
                                   r->program.s);
}

static fmb_status read_lp_row(lp_reader *r)
{
    fmb_span label;
    size_t i;
    begin_lp_row(r);
    FMB_TRY(read_lp_label(r, &label));
    if (label.n > 0)
        FMB_TRY(fmb_program_row(&r->program, label, true, &i));
    FMB_TRY(read_lp_sides(r, LP_ALL_LINES));
    return fmb_program_append(&r->program, r->at, &r->row,
                              r->end[0].finite ? r->end[0].value : NULL,
                              r->end[1].finite ? r->end[1].value : NULL, label);
}

/* ---- other sections -------------------------------------------------------------------------- */

static fmb_status read_lp_name(lp_reader *r, int *j)
{
    if (!has_variable_next(r, LP_ALL_LINES, false))
        return fail_lp(r, "a variable");
    FMB_TRY(fmb_program_variable(&r->program, r->next.text, j));
    return next_lp_token(r);
}

static fmb_status read_lp_integer(lp_reader *r)
{
    int j = 0;
    FMB_TRY(read_lp_name(r, &j));
    return fmb_system_set_integer(r->program.s, j, true);
}

/* A binary variable has the upper bound 1 unless the text gives one, perhaps later. */
static fmb_status read_lp_binary(lp_reader *r)
{
    int j = 0;
    FMB_TRY(read_lp_name(r, &j));
    mpq_set_ui(r->scratch, 1, 1);
    if (!r->program.end[j][FMB_PROGRAM_HIGH].at)
        fmb_program_bound(&r->program, j, FMB_PROGRAM_HIGH, NULL, r->scratch);
    return fmb_system_set_integer(r->program.s, j, true);
}

static fmb_status read_lp_bound(lp_reader *r)
{
    begin_lp_row(r);
    FMB_TRY(read_lp_sides(r, LP_ONE_LINE));
    if (r->row.n != 1 || mpq_cmp_ui(r->row.coef[0], 1, 1) != 0)
        return fmb_io_fail(r->c, r->at, "expected a bound of one variable");
    for (int e = 0; e < 2; e++)
        if (r->end[e].at)
            fmb_program_bound(&r->program, r->row.var[0], e, r->at,
                              r->end[e].finite ? r->end[e].value : NULL);
    return FMB_OK;
}

/* Read one section, from after its keyword to the next keyword. */
static fmb_status read_lp_section(lp_reader *r, fmb_lp_section section)
{
    static fmb_status (*const items[])(lp_reader *) = {[FMB_LP_ROWS] = read_lp_row,
                                                       [FMB_LP_BOUNDS] = read_lp_bound,
                                                       [FMB_LP_GENERAL] = read_lp_integer,
                                                       [FMB_LP_BINARY] = read_lp_binary};
    FMB_TRY(next_lp_token(r));
    while (r->next.kind != FMB_LP_KEYWORD && r->next.kind != FMB_LP_EOF)
        FMB_TRY(items[section](r));
    return FMB_OK;
}

static bool is_lp_keyword(const lp_reader *r, fmb_lp_section first, fmb_lp_section last)
{
    return r->next.kind == FMB_LP_KEYWORD && r->next.section >= first && r->next.section <= last;
}

static fmb_status read_lp_sections(lp_reader *r)
{
    FMB_TRY(next_lp_token(r));
    fmb_span keyword = r->next.text;
    if (!is_lp_keyword(r, FMB_LP_OBJECTIVE, FMB_LP_OBJECTIVE))
        return fail_lp(r, "'minimize' or 'maximize'");
    FMB_TRY(next_lp_token(r));
    FMB_TRY(read_lp_objective(r, keyword));
    if (!is_lp_keyword(r, FMB_LP_ROWS, FMB_LP_ROWS))
        return fail_lp(r, "an operator or 'subject to'");
    while (is_lp_keyword(r, FMB_LP_ROWS, FMB_LP_BINARY))
        FMB_TRY(read_lp_section(r, r->next.section));
    if (r->next.kind == FMB_LP_EOF)
        fmb_io_warn(r->c, r->next.text.p, "'end' is missing: the file may have been cut short");
    else if (r->next.section != FMB_LP_END)
        return fail_lp(r, "rows, bounds, general, binary or end: no other section can be read");
    else
        FMB_TRY(next_lp_token(r));
    return r->next.kind != FMB_LP_EOF ? fail_lp(r, "nothing behind 'end'") : FMB_OK;
}

fmb_status fmb_read_lp(fmb_cursor *c, fmb_system *s)
{
    lp_reader r = {.c = c};
    fmb_program_open(&r.program, c, s);
    fmb_draft_init(&r.row, c->mem);
    mpq_inits(r.value, r.scratch, r.end[0].value, r.end[1].value, (mpq_ptr)NULL);
    fmb_status st = read_lp_sections(&r);
    FMB_THEN(st, fmb_program_finish(&r.program));
    mpq_clears(r.value, r.scratch, r.end[0].value, r.end[1].value, (mpq_ptr)NULL);
    fmb_draft_clear(&r.row);
    fmb_program_close(&r.program);
    return st;
}
