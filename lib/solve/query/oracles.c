/* oracles.c: dense rows and oracles of parts, made on first use; see solver.h. */
#include "solve/query/solver.h"
#include "system/system_private.h"

fmb_status fmb_query_write_rows(fmb_query *q, int part)
{
    return fmb_part_load(&q->parts.part[part], q->s, q->parts.place, &q->run, fmb_query_is_wide(q));
}

static fmb_status load_program(fmb_query *q, const fmb_part *p, fmb_program *out)
{
    fmb_program_init(out, q->run.mem, p->n);
    for (size_t i = 0; i < p->m; i++) {
        const fmb_sysrow *r = fmb_system_row(q->s, p->source[i]);
        FMB_TRY(fmb_program_add(out, r->nnz, r->var, q->parts.place, &r->val, r->rel));
    }
    return FMB_OK;
}

/* The oracle of the loaded system, which is brought up to date on the first call. */
static fmb_status enter_session(fmb_query *q, fmb_oracle **out)
{
    fmb_status st = q->entered ? FMB_OK : fmb_session_enter(q->session, &q->run);
    q->entered = true;
    *out = fmb_session_oracle(q->session);
    return st;
}

fmb_status fmb_query_oracle(fmb_query *q, int part, fmb_oracle **out)
{
    if (q->session)
        return enter_session(q, out);
    if (!q->oracle[part]) {
        fmb_program *program = &q->program[part];
        fmb_status st = load_program(q, &q->parts.part[part], program);
        FMB_THEN(st, fmb_oracle_new(&q->run, program, &q->oracle[part]));
        if (st != FMB_OK && !q->oracle[part])
            fmb_program_clear(program);
        if (st != FMB_OK)
            return st;
    }
    *out = q->oracle[part];
    return FMB_OK;
}

fmb_status fmb_query_feasible_oracle(fmb_query *q, int part, fmb_oracle **out)
{
    bool feasible = true;
    FMB_TRY(fmb_query_oracle(q, part, out));
    if (!fmb_oracle_has_solution(*out))
        FMB_TRY(fmb_oracle_feasible(*out, &feasible));
    return !feasible ? FMB_LIMIT : FMB_OK;
}

fmb_status fmb_query_take_integer_weights(fmb_query *q, const fmb_part *p, fmb_weights *w)
{
    fmb_status st = FMB_OK;
    mpq_t content;
    mpq_init(content);
    for (size_t k = 0; st == FMB_OK && k < w->size; k++) {
        st = fmb_part_content(q->s, p->source[w->index[k]], &q->run, mpq_numref(content));
        mpq_mul(w->value[k], w->value[k], content);
    }
    mpq_clear(content);
    return st;
}

/* Renumber rows of the system as rows of the part, which has them in increasing order. */
static void number_rows_as_part(const fmb_part *p, fmb_weights *w)
{
    for (size_t k = 0; k < w->size; k++) {
        size_t low = 0, high = p->m;
        while (high - low > 1) {
            size_t middle = low + (high - low) / 2;
            *(p->source[middle] <= w->index[k] ? &low : &high) = middle;
        }
        w->index[k] = (uint32_t)low;
    }
}

fmb_status fmb_query_take_oracle_weights(fmb_query *q, const fmb_part *p, fmb_weights *w)
{
    if (q->entered) {
        fmb_session_take_weights(q->session, w);
        number_rows_as_part(p, w);
    }
    return fmb_query_take_integer_weights(q, p, w);
}

void fmb_query_leave_session(fmb_query *q, bool forget)
{
    if (!q->entered)
        return;
    fmb_session_leave(q->session, &q->run);
    if (forget)
        fmb_session_forget(q->session);
    q->entered = false;
}

void fmb_query_close_oracle(fmb_query *q, int part)
{
    if (q->oracle[part]) {
        fmb_oracle_free(q->oracle[part]);
        fmb_program_clear(&q->program[part]);
    }
    q->oracle[part] = NULL;
}

void fmb_query_close_oracles(fmb_query *q)
{
    fmb_query_leave_session(q, true);
    for (int c = 0; q->oracle && c < q->parts.count; c++)
        fmb_query_close_oracle(q, c);
}
