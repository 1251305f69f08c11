/* text_objective.c: objectives of the .fmb format: the labels that announce them, and a single form
 * as a text.
 */
#include "io/text/text.h"
#include "system/system_private.h"

fmb_sense fmb_text_sense(fmb_span label)
{
    static const char *const words[] = {"max", "maximize", "maximise",
                                        "min", "minimize", "minimise"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (fmb_span_is_nocase(label, words[i]))
            return i < 3 ? FMB_SENSE_MAX : FMB_SENSE_MIN;
    return FMB_SENSE_NONE;
}

/* Read a form that is the whole text. */
static fmb_status read_form_alone(fmb_text *t, fmb_sense sense)
{
    fmb_cursor *c = t->c;
    fmb_status st = fmb_io_check(c);
    FMB_THEN(st, fmb_text_expression(t, &t->left));
    fmb_skip_blanks(c);
    if (st == FMB_OK && c->at < c->end)
        st = fmb_io_expected(c, c->at, "an operator or the end of the form");
    mpq_neg(t->left.rhs, t->left.rhs);
    return st == FMB_OK ? fmb_draft_set_objective(c, c->begin, &t->left, sense, t->s) : st;
}

fmb_status fmb_system_parse_objective(fmb_system *s, fmb_sense sense, const char *text, size_t size,
                                      fmb_where *where)
{
    fmb_mem mem;
    fmb_where at = {0};
    if (!s || !text || (sense != FMB_SENSE_MAX && sense != FMB_SENSE_MIN))
        return fmb_io_refuse_argument(where, !s      ? "s is NULL"
                                             : !text ? "text is NULL"
                                                     : "sense is neither MAX nor MIN");
    const fmb_reader plain = {.size = sizeof plain, .mem = &s->mem.alloc};
    fmb_mem_init(&mem, plain.mem, 0);
    fmb_cursor c = fmb_io_cursor(text, size, &plain, &mem, &at);
    fmb_text t = {.c = &c, .s = s, .declared = true, .alone = true};
    fmb_draft_init(&t.left, &mem);
    fmb_status st = read_form_alone(&t, sense);
    fmb_draft_clear(&t.left);
    fmb_mem_put(&mem, t.name.p, t.name.capacity, 1);
    if (st == FMB_ERR_PARSE && where)
        *where = at;
    return st;
}
