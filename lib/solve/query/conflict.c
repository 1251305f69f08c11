/* conflict.c: irreducible conflicts.
 *
 * A conflict found by an oracle belongs to a basis: its multipliers are, up to scaling, the only
 * linear relation among its rows, so no proper subset is a conflict (Gleeson and Ryan 1990:
 * irreducible infeasible subsystems are the supports of vertices of the alternative system). A
 * conflict found by elimination may have more rows: then the oracle solves these rows alone.
 */
#include "solve/query/solver.h"
#include "system/system_private.h"

static fmb_status load_rows_of_conflict(const fmb_query *q, const fmb_part *p, const fmb_weights *w,
                                        fmb_program *out)
{
    for (size_t k = 0; k < w->size; k++) {
        const fmb_sysrow *r = fmb_system_row(q->s, p->source[w->index[k]]);
        FMB_TRY(fmb_program_add(out, r->nnz, r->var, q->parts.place, &r->val, r->rel));
    }
    return FMB_OK;
}

/* Take the conflict of o, with its rows numbered as in the part. */
static fmb_status take_conflict(fmb_query *q, const fmb_part *p, fmb_oracle *o, fmb_weights *w)
{
    fmb_weights less = {0};
    fmb_status st = fmb_oracle_conflict(o, &less);
    for (size_t k = 0; st == FMB_OK && k < less.size; k++)
        less.index[k] = w->index[less.index[k]];
    FMB_THEN(st, fmb_query_take_integer_weights(q, p, &less));
    if (st == FMB_OK) {
        fmb_weights all = *w;
        *w = less;
        less = all;
    }
    fmb_weights_clear(&less, q->run.mem);
    return st;
}

fmb_status fmb_query_minimize_conflict(fmb_query *q, const fmb_part *p, fmb_weights *w)
{
    fmb_program rows;
    fmb_oracle *o = NULL;
    bool feasible = true;
    if (w->size <= 2)
        return FMB_OK;
    fmb_program_init(&rows, q->run.mem, p->n);
    fmb_status st = load_rows_of_conflict(q, p, w, &rows);
    FMB_THEN(st, fmb_oracle_new(&q->run, &rows, &o));
    FMB_THEN(st, fmb_oracle_feasible(o, &feasible));
    if (st == FMB_OK && !feasible)
        st = take_conflict(q, p, o, w);
    fmb_oracle_free(o);
    fmb_program_clear(&rows);
    return st == FMB_LIMIT ? FMB_OK : st;
}
