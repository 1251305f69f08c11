/* program_draft.c: see program_draft.h. */
#include "io/program/program_draft.h"

#include <string.h>

void fmb_program_open(fmb_program_draft *p, fmb_cursor *c, fmb_system *s)
{
    *p = (fmb_program_draft){.c = c, .s = s};
    mpq_inits(p->huge[0], p->huge[1], (mpq_ptr)NULL);
    mpz_ui_pow_ui(mpq_numref(p->huge[1]), 10, 30);
    mpq_neg(p->huge[0], p->huge[1]);
}

void fmb_program_close(fmb_program_draft *p)
{
    for (size_t j = 0; j < p->ends; j++)
        mpq_clears(p->end[j][0].value, p->end[j][1].value, (mpq_ptr)NULL);
    mpq_clears(p->huge[0], p->huge[1], (mpq_ptr)NULL);
    fmb_names_clear(&p->rows, p->c->mem);
    fmb_mem_put(p->c->mem, p->end, p->capacity, sizeof *p->end);
    fmb_mem_put(p->c->mem, p->name, p->name_capacity, 1);
}

fmb_status fmb_program_variable(fmb_program_draft *p, fmb_span name, int *j)
{
    FMB_TRY(FMB_RESERVE(p->c->mem, &p->end, &p->capacity, p->ends + 1));
    FMB_TRY(fmb_span_variable(p->c, name, p->s, j));
    if (*j < (int)p->ends)
        return FMB_OK;
    fmb_program_end *end = p->end[p->ends++];
    end[FMB_PROGRAM_LOW] = (fmb_program_end){.finite = true};
    end[FMB_PROGRAM_HIGH] = (fmb_program_end){.finite = false};
    mpq_inits(end[0].value, end[1].value, (mpq_ptr)NULL);
    return FMB_OK;
}

fmb_status fmb_program_row(fmb_program_draft *p, fmb_span name, bool new, size_t *i)
{
    FMB_TRY(FMB_RESERVE(p->c->mem, &p->name, &p->name_capacity, name.n + 1));
    memcpy(p->name, name.p, name.n);
    p->name[name.n] = '\0';
    int known = fmb_names_find(&p->rows, p->name);
    if (new != (known < 0))
        return fmb_io_expected(p->c, name.p, "%s of a row", new ? "a new name" : "the name");
    *i = new ? p->rows.size : (size_t)known;
    return new ? fmb_names_add(&p->rows, p->name, p->c->mem) : FMB_OK;
}

bool fmb_program_is_infinite(fmb_program_draft *p, const char *at, mpq_srcptr q, int end)
{
    int size = mpq_cmp(q, p->huge[end]);
    bool infinite = end == FMB_PROGRAM_LOW ? size <= 0 : size >= 0;
    if (infinite && !p->warned_infinite)
        fmb_io_warn(p->c, at, "bounds of 1e30 and more are read as infinite");
    p->warned_infinite = p->warned_infinite || infinite;
    return infinite;
}

void fmb_program_bound(fmb_program_draft *p, int j, int end, const char *at, mpq_srcptr q)
{
    fmb_program_end *e = &p->end[j][end];
    e->at = at;
    e->finite = q != NULL;
    if (q)
        mpq_set(e->value, q);
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* terms REL value */
static fmb_status append_program_end(fmb_program_draft *p, const char *at, fmb_draft *terms,
                                     fmb_rel rel, mpq_srcptr value, fmb_span label)
{
    mpq_set(terms->rhs, value);
    FMB_TRY(fmb_draft_append(p->c, at, terms, rel, p->s));
    return label.n > 0 ? fmb_span_label(p->c, label, p->s, fmb_system_rows(p->s) - 1) : FMB_OK;
}

fmb_status fmb_program_append(fmb_program_draft *p, const char *at, fmb_draft *terms,
                              mpq_srcptr low, mpq_srcptr high, fmb_span label)
{
    bool equal = low && high && mpq_equal(low, high);
    if (low && !equal)
        FMB_TRY(append_program_end(p, at, terms, FMB_GE, low, label));
    if (high)
        FMB_TRY(append_program_end(p, at, terms, equal ? FMB_EQ : FMB_LE, high, label));
    return FMB_OK;
}

fmb_status fmb_program_finish(fmb_program_draft *p)
{
    fmb_status st = FMB_OK;
    fmb_draft one;
    fmb_draft_init(&one, p->c->mem);
    for (size_t j = 0; st == FMB_OK && j < p->ends; j++) {
        const fmb_program_end *low = &p->end[j][FMB_PROGRAM_LOW], *high = low + 1;
        mpq_ptr slot;
        if (high->at && !low->at && high->finite && mpq_sgn(high->value) < 0)
            fmb_io_warn(p->c, high->at, "a negative upper bound; the lower bound stays 0");
        fmb_draft_reset(&one);
        st = fmb_draft_term(&one, (int)j, &slot);
        if (st != FMB_OK)
            break;
        mpq_set_ui(slot, 1, 1);
        st = fmb_program_append(p, high->at ? high->at : p->c->begin, &one,
                                low->finite ? low->value : NULL, high->finite ? high->value : NULL,
                                (fmb_span){NULL, 0});
    }
    fmb_draft_clear(&one);
    return st;
}
