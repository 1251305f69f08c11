/* ine_options.c: the lines around the matrix of a cddlib/lrslib file; see ine.h.
 *
 * What changes the set of solutions or names variables is obeyed. Commands to those programs
 * (redund, verbose, ...) say nothing about the system and are passed over. Ignored with a warning:
 * an objective, and lrslib's `nonnegative`, which cddlib does not know: the rows of the matrix are
 * what both read.
 */
#include "io/ine.h"
#include "system/system.h"

static bool at_line_end(fmb_cursor *c)
{
    fmb_skip_blanks(c);
    return fmb_peek(c) == '\n' || fmb_peek(c) < 0;
}

void fmb_ine_skip_arguments(fmb_cursor *c)
{
    for (;;) {
        fmb_next_line(c);
        const char *line = c->at;
        fmb_skip_blanks(c);
        int b = fmb_peek(c);
        c->at = line;
        if (!((b >= '0' && b <= '9') || b == '+' || b == '-' || b == '.'))
            return;
    }
}

/* "k i1 ... ik" and the end of the line. */
static fmb_status take_list(fmb_cursor *c, fmb_ine_list *list, const char *what)
{
    size_t k;
    char found[FMB_QUOTE];
    fmb_skip_blanks(c);
    fmb_status st = fmb_scan_count(c, SIZE_MAX / 2, "a count", &k);
    for (size_t i = 0; st == FMB_OK && i < k; i++) {
        st = fmb_mem_reserve(c->mem, (void **)&list->item, &list->capacity, list->size + 1,
                             sizeof *list->item);
        if (st != FMB_OK)
            break;
        fmb_skip_space(c);
        fmb_ine_item *item = &list->item[list->size];
        item->at = c->at;
        st = fmb_scan_count(c, SIZE_MAX / 2, what, &item->index);
        list->size += st == FMB_OK;
    }
    if (st == FMB_OK && !at_line_end(c))
        st = fmb_io_fail(c, c->at, "expected end of line after a list of %zu, found %s", k,
                         fmb_quote(c, c->at, found));
    fmb_next_line(c);
    return st;
}

/* ---- options --------------------------------------------------------------------------------- */

static fmb_status take_linear(fmb_ine *f, const char *line)
{
    (void)line;
    return take_list(f->c, &f->linear, "a row number");
}

static fmb_status take_strict(fmb_ine *f, const char *line)
{
    (void)line;
    return take_list(f->c, &f->strict, "a row number");
}

static fmb_status take_marks(fmb_ine *f, const char *line, bool keep)
{
    if (f->asked)
        return fmb_io_fail(f->c, line, "expected one 'project' or 'eliminate' line, found another");
    f->asked = line;
    f->marks_keep = keep;
    return take_list(f->c, &f->marks, "the number of a variable");
}

static fmb_status take_project(fmb_ine *f, const char *line)
{
    return take_marks(f, line, true);
}

static fmb_status take_eliminate(fmb_ine *f, const char *line)
{
    return take_marks(f, line, false);
}

static fmb_status take_nonnegative(fmb_ine *f, const char *line)
{
    fmb_io_warn(f->c, line, "ignored: 'nonnegative'; only the rows of the matrix count");
    fmb_next_line(f->c);
    return FMB_OK;
}

static fmb_status take_objective(fmb_ine *f, const char *line)
{
    fmb_io_warn(f->c, line, "ignored: an objective");
    fmb_ine_skip_arguments(f->c);
    return FMB_OK;
}

static fmb_status take_v(fmb_ine *f, const char *line)
{
    return fmb_io_fail(f->c, line,
                       "expected an H-representation, found vertices and rays (V-representation)");
}

static fmb_status pass_over(fmb_ine *f, const char *line)
{
    (void)line;
    fmb_ine_skip_arguments(f->c);
    return FMB_OK;
}

static const struct option {
    const char *word;
    fmb_status (*take)(fmb_ine *f, const char *line); /* c is past the word */
} options[] = {
    {"H-representation", pass_over},
    {"V-representation", take_v},
    {"linearity", take_linear},
    {"equality", take_linear},
    {"partial_enum", take_linear},
    {"partial_enumeration", take_linear},
    {"strict_inequality", take_strict},
    {"project", take_project},
    {"eliminate", take_eliminate},
    {"nonnegative", take_nonnegative},
    {"maximize", take_objective},
    {"minimize", take_objective},
    {"adjacency", pass_over},
    {"allbases", pass_over},
    {"cache", pass_over},
    {"debug", pass_over},
    {"digits", pass_over},
    {"estimates", pass_over},
    {"geometric", pass_over},
    {"hull", pass_over},
    {"incidence", pass_over},
    {"lexmax", pass_over},
    {"lexmin", pass_over},
    {"lponly", pass_over},
    {"maxdepth", pass_over},
    {"maxoutput", pass_over},
    {"mindepth", pass_over},
    {"printcobasis", pass_over},
    {"printslack", pass_over},
    {"redund", pass_over},
    {"redund_list", pass_over},
    {"restart", pass_over},
    {"seed", pass_over},
    {"startingcobasis", pass_over},
    {"testlin", pass_over},
    {"threads", pass_over},
    {"truncate", pass_over},
    {"verbose", pass_over},
    {"volume", pass_over},
};

fmb_status fmb_ine_option(fmb_ine *f, bool *known)
{
    const char *line = f->c->at;
    fmb_span word = fmb_scan_word(f->c);
    for (size_t i = 0; i < sizeof options / sizeof *options; i++) {
        if (fmb_span_is_nocase(word, options[i].word)) {
            *known = true;
            return options[i].take(f, line);
        }
    }
    f->c->at = line;
    *known = false;
    return FMB_OK;
}

/* ---- carrying them out ----------------------------------------------------------------------- */

static fmb_status set_relation(fmb_ine *f, const fmb_ine_list *list, fmb_rel rel)
{
    for (size_t k = 0; k < list->size; k++) {
        size_t i = list->item[k].index;
        if (i < 1 || i > f->s->rows)
            return fmb_io_fail(f->c, list->item[k].at, "expected a row number between 1 and %zu",
                               f->s->rows);
        fmb_sysrow *r = &f->s->row[i - 1];
        if (r->rel != FMB_LE && r->rel != rel)
            return fmb_io_fail(f->c, list->item[k].at,
                               "expected row %zu to be strict or a linearity, not both", i);
        r->rel = rel;
    }
    return FMB_OK;
}

static fmb_status set_marks(fmb_ine *f)
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

fmb_status fmb_ine_finish(fmb_ine *f)
{
    fmb_status st = set_relation(f, &f->linear, FMB_EQ);
    if (st == FMB_OK)
        st = set_relation(f, &f->strict, FMB_LT);
    if (st == FMB_OK)
        st = set_marks(f);
    return st;
}

void fmb_ine_clear(fmb_ine *f)
{
    fmb_ine_list *const lists[] = {&f->linear, &f->strict, &f->marks};
    for (size_t k = 0; k < sizeof lists / sizeof *lists; k++)
        fmb_mem_put(f->c->mem, lists[k]->item, lists[k]->capacity, sizeof *lists[k]->item);
}
