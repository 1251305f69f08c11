/* ine_options.c: the lines around the matrix of a cddlib/lrslib file; see ine.h.
 *
 * Options that change the set of solutions or name variables are applied. Commands to those
 * programs (redund, verbose, ...) do not describe the system and are skipped. lrslib's
 * `nonnegative`, which cddlib does not know, is ignored with a warning: both read the matrix alike.
 */
#include "io/core/cursor.h"
#include "io/ine/ine.h"
#include "system/system_private.h"

static bool is_at_end_of_line(fmb_cursor *c)
{
    fmb_skip_blanks(c);
    return fmb_peek(c) == '\n' || fmb_peek(c) < 0;
}

fmb_status fmb_ine_number(fmb_cursor *c, mpq_t out)
{
    const char *p = c->at;
    FMB_TRY(fmb_scan_number(c, FMB_NUM_ALL, "a number", out));
    return fmb_scan_word(c).n > 0 ? fmb_io_expected(c, p, "a number") : FMB_OK;
}

void fmb_ine_skip_arguments(fmb_cursor *c)
{
    for (;;) {
        fmb_next_line(c);
        const char *line = c->at;
        fmb_skip_blanks(c);
        int b = fmb_peek(c);
        c->at = line;
        if (!fmb_starts_number(b))
            return;
    }
}

/* "k i1 ... ik" and the end of the line. */
static fmb_status read_counted_list(fmb_cursor *c, fmb_ine_list *list, const char *what)
{
    size_t k;
    fmb_skip_blanks(c);
    fmb_status st = fmb_scan_count(c, SIZE_MAX / 2, "a count", &k);
    for (size_t i = 0; st == FMB_OK && i < k; i++) {
        st = FMB_RESERVE(c->mem, &list->item, &list->capacity, list->size + 1);
        if (st != FMB_OK)
            break;
        fmb_skip_space(c);
        fmb_ine_item *item = &list->item[list->size];
        item->at = c->at;
        st = fmb_scan_count(c, SIZE_MAX / 2, what, &item->index);
        list->size += st == FMB_OK;
    }
    if (st == FMB_OK && !is_at_end_of_line(c))
        st = fmb_io_expected(c, c->at, "end of line after a list of %zu", k);
    fmb_next_line(c);
    return st;
}

/* ---- options --------------------------------------------------------------------------------- */

static fmb_status take_row_list(fmb_ine *f, const char *line, int strict)
{
    (void)line;
    return read_counted_list(f->c, strict ? &f->strict : &f->linear, "a row number");
}

static fmb_status take_variable_list(fmb_ine *f, const char *line, int keep)
{
    if (f->asked)
        return fmb_io_fail(f->c, line, "expected one 'project' or 'eliminate' line, found another");
    f->asked = line;
    f->marks_keep = keep;
    return read_counted_list(f->c, &f->marks, "the number of a variable");
}

static fmb_status ignore_nonnegative(fmb_ine *f, const char *line, int unused)
{
    (void)unused;
    fmb_io_warn(f->c, line, "ignored: 'nonnegative'; only the rows of the matrix count");
    fmb_next_line(f->c);
    return FMB_OK;
}

/* Note the objective; its numbers are read once their count is known. */
static fmb_status take_ine_objective(fmb_ine *f, const char *line, int sense)
{
    if (f->objective)
        return fmb_io_fail(f->c, line, "expected one objective, found another");
    f->objective = f->c->at;
    f->sense = (fmb_sense)sense;
    fmb_ine_skip_arguments(f->c);
    return FMB_OK;
}

static fmb_status take_representation(fmb_ine *f, const char *line, int generators)
{
    if (f->generators != (bool)generators)
        return fmb_io_fail(
            f->c, line,
            generators ? "expected an H-representation, found vertices and rays (V-representation)"
                       : "expected a V-representation, found an H-representation");
    fmb_ine_skip_arguments(f->c);
    return FMB_OK;
}

static const struct option {
    const char *word;
    fmb_status (*take)(fmb_ine *f, const char *line, int which); /* c is past the word */
    int which;
} options[] = {
    {"H-representation", take_representation, false},
    {"V-representation", take_representation, true},
    {"linearity", take_row_list, false},
    {"equality", take_row_list, false},
    {"partial_enum", take_row_list, false},
    {"partial_enumeration", take_row_list, false},
    {"strict_inequality", take_row_list, true},
    {"project", take_variable_list, true},
    {"eliminate", take_variable_list, false},
    {"nonnegative", ignore_nonnegative, 0},
    {"maximize", take_ine_objective, FMB_SENSE_MAX},
    {"minimize", take_ine_objective, FMB_SENSE_MIN},
};

/* Commands to those programs. */
static const char *const commands[] = {
    "adjacency",   "allbases",  "cache",     "debug",           "digits",     "estimates",
    "geometric",   "hull",      "incidence", "lexmax",          "lexmin",     "lponly",
    "maxdepth",    "maxoutput", "mindepth",  "printcobasis",    "printslack", "redund",
    "redund_list", "restart",   "seed",      "startingcobasis", "testlin",    "threads",
    "truncate",    "verbose",   "volume"};

fmb_status fmb_ine_option(fmb_ine *f, bool *known)
{
    const char *line = f->c->at;
    fmb_span word = fmb_scan_word(f->c);
    *known = true;
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        if (fmb_span_is_nocase(word, options[i].word))
            return options[i].take(f, line, options[i].which);
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (fmb_span_is_nocase(word, commands[i])) {
            fmb_ine_skip_arguments(f->c);
            return FMB_OK;
        }
    f->c->at = line;
    *known = false;
    return FMB_OK;
}

/* ---- carrying them out ----------------------------------------------------------------------- */

static fmb_status set_relation_of_rows(fmb_ine *f, const fmb_ine_list *list, fmb_rel rel)
{
    for (size_t k = 0; k < list->size; k++) {
        size_t i = list->item[k].index;
        if (i < 1 || i > f->s->rows)
            return fmb_io_fail(f->c, list->item[k].at, "expected a row number between 1 and %zu",
                               f->s->rows);
        fmb_sysrow *r = &f->s->row[i - 1];
        if (f->generators && rel == FMB_EQ && fmb_vec_sgn(&r->val, r->nnz) != 0)
            return fmb_io_fail(f->c, list->item[k].at,
                               "expected a row that begins with 0, as it is a line, found row %zu",
                               i);
        if (r->rel != FMB_LE && r->rel != rel)
            return fmb_io_fail(f->c, list->item[k].at,
                               "expected row %zu to be strict or a linearity, not both", i);
        r->rel = rel;
    }
    return FMB_OK;
}

static fmb_status set_listed_marks(fmb_ine *f)
{
    int dim = fmb_system_dim(f->s);
    for (int j = 0; f->asked && j < dim; j++)
        fmb_system_set_kept(f->s, j, !f->marks_keep);
    for (size_t k = 0; k < f->marks.size; k++) {
        size_t j = f->marks.item[k].index;
        if (j < 1 || j > (size_t)dim)
            return fmb_io_fail(f->c, f->marks.item[k].at, "expected a variable between 1 and %d",
                               dim);
        fmb_system_set_kept(f->s, (int)j - 1, f->marks_keep);
    }
    return FMB_OK;
}

/* The constant, then a coefficient for each variable, on one line or several. */
static fmb_status read_objective_numbers(fmb_ine *f, fmb_draft *d)
{
    fmb_cursor *c = f->c;
    int dim = fmb_system_dim(f->s);
    fmb_status st = FMB_OK;
    mpq_t value;
    mpq_init(value);
    for (int j = -1; st == FMB_OK && j < dim; j++) {
        fmb_skip_space(c);
        st =
            fmb_starts_number(fmb_peek(c))
                ? fmb_ine_number(c, value)
                : fmb_io_expected(c, c->at, "number %d of the %d of the objective", j + 2, dim + 1);
        if (st == FMB_OK && j >= 0)
            st = fmb_draft_add(d, j, value);
        else if (st == FMB_OK)
            mpq_set(d->rhs, value);
    }
    mpq_clear(value);
    fmb_skip_space(c);
    return st == FMB_OK && fmb_starts_number(fmb_peek(c))
               ? fmb_io_expected(c, c->at, "an objective of %d numbers", dim + 1)
               : st;
}

static fmb_status set_ine_objective(fmb_ine *f)
{
    fmb_draft d;
    if (!f->objective)
        return FMB_OK;
    fmb_draft_init(&d, f->c->mem);
    f->c->at = f->objective;
    fmb_status st = read_objective_numbers(f, &d);
    mpq_neg(d.rhs, d.rhs);
    FMB_THEN(st, fmb_draft_set_objective(f->c, f->objective, &d, f->sense, f->s));
    fmb_draft_clear(&d);
    return st;
}

fmb_status fmb_ine_finish(fmb_ine *f)
{
    FMB_TRY(set_relation_of_rows(f, &f->linear, FMB_EQ));
    FMB_TRY(set_relation_of_rows(f, &f->strict, FMB_LT));
    FMB_TRY(set_listed_marks(f));
    return set_ine_objective(f);
}

void fmb_ine_clear(fmb_ine *f)
{
    fmb_ine_list *const lists[] = {&f->linear, &f->strict, &f->marks};
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
        fmb_mem_put(f->c->mem, lists[k]->item, lists[k]->capacity, sizeof *lists[k]->item);
}
