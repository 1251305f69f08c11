/* ask.c: the questions of a script as systems: the reading (reading.h) executes the commands in
 * force that it has not executed yet; assumptions, or a term of get-value, are added and undone.
 */
#include "io/smt2/script/script_private.h"
#include "system/system_private.h"

/* The command that a question adds to those in force (at NULL: none), and its reader. */
typedef struct script_extra {
    const fmb_script_command *at;
    const char *from; /* where reading starts */
    fmb_smt_command *run;
} script_extra;

/* Set the marks of the levels that open at command k. */
static void mark_levels(fmb_script *s, size_t k)
{
    while (s->marked < s->levels && s->level[s->marked].at == k)
        s->level[s->marked++].mark = fmb_smt_reading_mark(&s->reading);
}

/* Execute all commands in force that were not executed yet. A warning is given once. */
static fmb_status catch_up(fmb_script *s)
{
    fmb_status st = FMB_OK;
    for (; st == FMB_OK && s->read < s->at; s->read++) {
        const fmb_script_command *k = &s->command[s->read];
        mark_levels(s, s->read);
        s->reading.c.how = s->read < s->heard ? &s->reading.silent : &s->how;
        s->reading.c.at = k->text.p + 1;
        size_t tolds = s->reading.facts.tolds;
        if (k->counts)
            st = fmb_smt_run(&s->reading.r, k->text.p, fmb_smt_run_command);
        if (s->reading.facts.tolds > tolds && s->told <= s->read)
            s->told = s->read + 1;
    }
    s->heard = s->read > s->heard ? s->read : s->heard;
    return st;
}

/* One reading up to the question. */
static fmb_status read_up_to(fmb_script *s, const script_extra *extra, fmb_smt_mark *before)
{
    FMB_TRY(s->reading.s ? FMB_OK : fmb_smt_reading_begin(&s->reading));
    FMB_TRY(catch_up(s));
    *before = fmb_smt_reading_mark(&s->reading);
    if (!extra->at)
        return FMB_OK;
    s->reading.c.at = extra->from;
    return fmb_smt_run(&s->reading.r, extra->at->text.p, extra->run);
}

/* Prepare another reading with the facts of this one, including those that the question itself gave
 * after the mark. */
static fmb_status read_again(fmb_script *s, const fmb_smt_mark *before)
{
    bool own = s->knew == SIZE_MAX || s->reading.facts.tolds > before->tolds;
    s->read = s->marked = 0;
    s->knew = own ? SIZE_MAX : s->told;
    return fmb_smt_reading_begin(&s->reading);
}

/* Hand out the system that was read; without rows it gets one that always holds; the value of a
 * term becomes the objective. */
static fmb_status hand_out_system(fmb_script *s, bool term, fmb_system **out)
{
    fmb_smt_reading *g = &s->reading;
    fmb_system *q = NULL;
    fmb_status st = fmb_system_copy_to(g->s, s->how.mem, &q);
    if (st == FMB_OK && fmb_system_rows(q) == 0 && fmb_system_dim(q) == 0)
        st = fmb_system_add_terms_int(q, 0, NULL, NULL, FMB_LE, 0);
    if (st == FMB_OK && term)
        st = fmb_draft_set_objective(&g->c, g->c.at, &g->r.forms.row, FMB_SENSE_MIN, q);
    if (st == FMB_OK)
        *out = q;
    else
        fmb_system_free(q);
    return st;
}

static fmb_status ask_reading(fmb_script *s, const script_extra *extra, bool term, fmb_system **out,
                              fmb_where *where)
{
    bool again = false;
    fmb_smt_mark before = {0};
    fmb_status st;
    do {
        st = again ? read_again(s, &before) : FMB_OK;
        FMB_THEN(st, read_up_to(s, extra, &before));
        st = fmb_smt_end_reading(&s->reading.c, &s->reading.facts, st, &again);
    } while (again);
    FMB_THEN(st, hand_out_system(s, term, out));
    if (st == FMB_ERR_PARSE && where)
        *where = s->reading.at;
    if (st != FMB_OK || s->knew > s->at)
        fmb_script_drop_reading(s);
    else
        fmb_smt_reading_return(&s->reading, &before);
    return st;
}

/* Assert the formulas of a list. */
static fmb_status run_assumptions(fmb_smt *r, const char *open)
{
    (void)open;
    for (;;) {
        const char *before = r->c->at;
        fmb_smt_token t;
        fmb_smt_value v;
        FMB_TRY(fmb_smt_next(r->c, &t));
        if (t.kind == FMB_SMT_CLOSE)
            return FMB_OK;
        r->c->at = before;
        FMB_TRY(fmb_smt_term(r, &v));
        FMB_TRY(fmb_smt_check_kind(r, &v, true));
        FMB_TRY(fmb_form_assert(&r->forms, v.id, r->s));
    }
}

fmb_status fmb_script_question(fmb_script *s, fmb_system **out, fmb_where *where)
{
    if (!s || !out)
        return fmb_io_refuse_argument(where, s ? "out is NULL" : "s is NULL");
    const fmb_script_command *k = s->asked == SIZE_MAX ? NULL : &s->command[s->asked];
    script_extra extra = {.run = run_assumptions};
    if (k && k->inner > 0) {
        extra.at = k;
        extra.from = k->text.p + k->inner + 1;
    }
    return ask_reading(s, &extra, false, out, where);
}

size_t fmb_script_tokens(const fmb_script *s)
{
    return s->scanned + s->reading.c.tokens;
}

fmb_status fmb_script_whole(fmb_script *s, fmb_system **out, fmb_where *where)
{
    if (!s)
        return fmb_io_refuse_argument(where, "s is NULL");
    return fmb_system_parse(s->text, s->size, &s->how, out, where);
}

/* The i-th item of the list behind get-value; n 0: there is none. */
static fmb_span find_value_term(fmb_script *s, size_t i)
{
    fmb_where at;
    fmb_smt_token t;
    const fmb_script_command *k = s->at > 0 ? &s->command[s->at - 1] : NULL;
    if (!k || fmb_script_kind_of(k) != FMB_SCRIPT_VALUE)
        return (fmb_span){NULL, 0};
    if (s->term.command != s->at || s->term.i > i)
        s->term.i = 0, s->term.at = k->text.p + k->inner + 1;
    s->term.command = s->at;
    fmb_cursor c = fmb_io_cursor(s->text, s->size, &s->how, &s->mem, &at);
    c.at = s->term.at;
    for (; fmb_smt_next(&c, &t) == FMB_OK; s->term.i++, s->term.at = c.at) {
        if (t.kind == FMB_SMT_CLOSE || t.kind == FMB_SMT_END)
            break;
        if (t.kind == FMB_SMT_OPEN && fmb_smt_leave(&c, t.at) != FMB_OK)
            break;
        if (s->term.i == i) {
            s->scanned += c.tokens;
            return (fmb_span){t.at, (size_t)(c.at - t.at)};
        }
    }
    s->scanned += c.tokens;
    return (fmb_span){NULL, 0};
}

/* Read a term, whose value is left in the draft of a row. */
static fmb_status run_value_term(fmb_smt *r, const char *open)
{
    fmb_smt_value v;
    FMB_TRY(fmb_smt_term(r, &v));
    FMB_TRY(fmb_smt_check_kind(r, &v, false));
    return fmb_lin_expand(&r->lin, open, v.id, &r->forms.row);
}

fmb_status fmb_script_term(fmb_script *s, size_t i, const char **text, size_t *size,
                           fmb_system **out, fmb_where *where)
{
    if (!s || !text || !size || !out)
        return fmb_io_refuse_argument(where, "an argument is NULL");
    fmb_span term = find_value_term(s, i);
    if (term.n == 0) {
        *text = NULL;
        *size = 0;
        return FMB_OK;
    }
    const fmb_script_command *k = &s->command[s->at - 1];
    script_extra extra = {k, term.p, run_value_term};
    FMB_TRY(ask_reading(s, &extra, true, out, where));
    *text = term.p;
    *size = term.n;
    return FMB_OK;
}
