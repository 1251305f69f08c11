/* wrong.c: see wrong.h. Rows are removed one by one, as long as the answer stays wrong. */
#include "study/grid/wrong.h"

#include <fmb/session.h>
#include <stdlib.h>

typedef struct hunt {
    const study_case *c;
    study_reference reference;
    study_engine engine;
    study_names names;
    fmb_solver *editor; /* whose loaded system loses a row */
} hunt;

/* Time limit of the reference for one question [s]. */
static const double REFERENCE_SECONDS = 20;

static fmb_status goes_wrong(hunt *h, fmb_system *s, bool *wrong)
{
    study_case c = {.s = s, .keep = h->c->keep, .kept = h->c->kept};
    study_run run = {.outcome = STUDY_NOT_RUN};
    fmb_status st = study_reference_verdict(&h->reference, s, &c.truth);
    if (st == FMB_OK)
        st = study_reference_projection(&h->reference, s, c.keep, c.kept, &c.projection);
    if (st == FMB_OK)
        st = study_case_count(&h->reference, &h->engine, &c, &run);
    if (st == FMB_OK && run.outcome != STUDY_WRONG)
        st = study_engine_time(&h->engine, s, NULL, 0, c.truth, &run);
    *wrong = run.outcome == STUDY_WRONG || run.solved == STUDY_WRONG;
    free(c.projection);
    return st;
}

static fmb_status copy_without(hunt *h, const fmb_system *s, size_t row, fmb_system **out)
{
    fmb_status st = fmb_solver_load(h->editor, s);
    if (st == FMB_OK)
        st = fmb_solver_remove(h->editor, row);
    return st == FMB_OK ? fmb_system_copy(fmb_solver_system(h->editor), out) : st;
}

/* Remove the last row of *s without which the answer is still wrong, if there is one. */
static fmb_status drop_row_of(hunt *h, fmb_system **s, bool *dropped)
{
    fmb_status st = FMB_OK;
    *dropped = false;
    for (size_t i = fmb_system_rows(*s); st == FMB_OK && !*dropped && i-- > 0;) {
        fmb_system *less = NULL;
        st = copy_without(h, *s, i, &less);
        if (st == FMB_OK)
            st = goes_wrong(h, less, dropped);
        fmb_system_free(*dropped ? *s : less);
        if (*dropped)
            *s = less;
    }
    return st;
}

static fmb_status shrink(hunt *h, fmb_system **out)
{
    fmb_system *s = NULL;
    bool wrong = false;
    fmb_status st = fmb_system_copy(h->c->s, &s);
    if (st == FMB_OK)
        st = goes_wrong(h, s, &wrong);
    for (bool smaller = wrong; st == FMB_OK && smaller;)
        st = drop_row_of(h, &s, &smaller);
    if (st == FMB_OK && wrong)
        *out = s;
    else
        fmb_system_free(s);
    return st;
}

fmb_status study_smallest_wrong(const study_case *c, const study_way *way,
                                const study_limits *limits, fmb_system **out)
{
    hunt h = {.c = c};
    *out = NULL;
    fmb_status st = study_reference_open(&h.reference, REFERENCE_SECONDS);
    if (st == FMB_OK)
        st = study_engine_open(&h.engine, way, limits, &h.names);
    if (st == FMB_OK)
        st = fmb_solver_new(NULL, NULL, &h.editor);
    if (st == FMB_OK)
        st = shrink(&h, out);
    fmb_solver_free(h.editor);
    study_engine_close(&h.engine);
    study_reference_close(&h.reference);
    return st;
}
