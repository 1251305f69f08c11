/* ine_names.c: names of variables and labels of rows, in comments that cddlib and lrslib skip:
 *
 *   * x2 is "milk"
 *   * row 3 is "cap"
 *
 * They are before `begin`, one per line, and count only with the quotes: other comments are for
 * people. An impossible one (no such row, a name that is taken) is ignored with a warning.
 */
#include "io/core/cursor.h"
#include "io/core/number.h"
#include "io/ine/ine.h"
#include "system/system_private.h"

/* The line at c, up to its quotes. */
static bool accept_subject_of_comment(fmb_cursor *c, bool *row, size_t *index)
{
    fmb_skip_blanks(c);
    if (!fmb_accept(c, "*"))
        return false;
    fmb_skip_blanks(c);
    *row = fmb_accept(c, "row ");
    if ((!*row && !fmb_accept(c, "x")) || !fmb_is_digit(fmb_peek(c)) ||
        fmb_scan_count(c, SIZE_MAX / 2, "", index) != FMB_OK)
        return false;
    fmb_skip_blanks(c);
    if (!fmb_accept(c, "is"))
        return false;
    fmb_skip_blanks(c);
    return fmb_peek(c) == '"';
}

/* The quoted text at c, which ends its line, as a string; NULL with a warning if it is none, or
 * with an error in *st. */
static const char *read_rest_of_comment(fmb_cursor *c, fmb_room *room, fmb_status *st)
{
    const char *start = c->at;
    fmb_span text;
    *st = fmb_scan_quoted(c, room, &text);
    if (*st == FMB_OK)
        *st = FMB_RESERVE(c->mem, &room->p, &room->capacity, text.n + 1);
    fmb_skip_blanks(c);
    if (*st == FMB_OK && (fmb_peek(c) == '\n' || fmb_peek(c) < 0)) {
        room->p[text.n] = '\0';
        return room->p;
    }
    if (*st == FMB_OK || *st == FMB_ERR_PARSE)
        fmb_io_warn(c, start, "ignored: a comment with a name, which does not end with its quotes");
    *st = *st == FMB_ERR_PARSE ? FMB_OK : *st;
    return NULL;
}

/* Comments of rows become labels; quote[j] gets the place of the name of variable j. */
static fmb_status read_comments(fmb_ine *f, const char **quote, fmb_room *room, bool *any)
{
    fmb_cursor *c = f->c;
    fmb_status st = FMB_OK;
    for (c->at = c->begin; st == FMB_OK && c->at < f->matrix; fmb_next_line(c)) {
        const char *line = c->at;
        bool row;
        size_t index;
        if (!accept_subject_of_comment(c, &row, &index))
            continue;
        size_t most = row ? f->s->rows : (size_t)fmb_system_dim(f->s);
        if (index < 1 || index > most) {
            fmb_io_warn(c, line, "ignored: a name for %s %zu of %zu", row ? "row" : "variable",
                        index, most);
        } else if (!row) {
            quote[index - 1] = c->at;
            *any = true;
        } else {
            const char *label = read_rest_of_comment(c, room, &st);
            if (label)
                st = fmb_system_set_label(f->s, index - 1, label);
        }
    }
    return st;
}

/* Name all variables anew, as a name may be the default name of another variable. */
static fmb_status name_variables(fmb_ine *f, const char *const *quote, int dim, fmb_room *room)
{
    fmb_system *s = f->s;
    fmb_status st = FMB_OK;
    fmb_names before = s->names;
    s->names = (fmb_names){0};
    for (int j = 0; st == FMB_OK && j < dim; j++) {
        const char *name = NULL;
        f->c->at = quote[j];
        if (quote[j])
            name = read_rest_of_comment(f->c, room, &st);
        if (st == FMB_OK && name && (!*name || fmb_system_find(s, name) >= 0)) {
            fmb_io_warn(f->c, quote[j], "ignored: the name of x%d, which is %s", j + 1,
                        *name ? "taken" : "empty");
            name = NULL;
        }
        FMB_THEN(st, fmb_system_add_variable(s, name, NULL));
    }
    fmb_names_clear(&before, &s->mem);
    return st;
}

fmb_status fmb_ine_take_names(fmb_ine *f)
{
    fmb_mem *mem = f->c->mem;
    fmb_room room = {0};
    bool any = false;
    int dim = fmb_system_dim(f->s);
    const char **quote;
    FMB_TRY(FMB_GET_ZERO(mem, quote, (size_t)dim + 1));
    fmb_status st = read_comments(f, quote, &room, &any);
    if (st == FMB_OK && any)
        st = name_variables(f, quote, dim, &room);
    fmb_mem_put(mem, room.p, room.capacity, 1);
    fmb_mem_put(mem, quote, (size_t)dim + 1, sizeof *quote);
    return st;
}
