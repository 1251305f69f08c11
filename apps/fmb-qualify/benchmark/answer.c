/* answer.c: see answer.h. */
#include "fmb-qualify/benchmark/answer.h"

#include <stdlib.h>

#include "common/message.h"

static void note_rows(const fmb_system *p, qualify_answer *out)
{
    for (size_t i = 0; i < fmb_system_rows(p); i++) {
        fmb_rel rel = fmb_system_rel(p, i);
        out->equations += rel == FMB_EQ;
        out->inequalities += rel != FMB_EQ;
        out->strict += rel == FMB_LT;
    }
}

static void note_digest(const fmb_system *projection, qualify_answer *out)
{
    char *text;
    size_t size;
    FILE *f = app_need(open_memstream(&text, &size));
    if (projection && fmb_system_write(projection, FMB_FORMAT_INE, f) != FMB_OK)
        app_need(NULL);
    if (!projection)
        fprintf(f, "%s\n", fmb_verdict_text(out->verdict));
    fclose(f);
    qualify_sha256(app_need(text), size, out->digest);
    free(text);
}

/* Does the checker accept what v has just found? *accepted is set. */
static fmb_status check(const fmb_solver *v, const fmb_system *s, bool *accepted)
{
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_status st = fmb_solver_evidence(v, &e);
    if (st == FMB_OK)
        st = fmb_check(s, e, &j);
    fmb_evidence_free(e);
    *accepted = j.accepted && fmb_solver_trouble(v)[0] == '\0';
    return st;
}

static fmb_status ask(fmb_solver *v, const study_projection *p, fmb_system **projection,
                      fmb_result *r)
{
    if (p->keep == 0)
        return fmb_solve(v, p->s, r);
    int *keep = app_need(malloc((size_t)p->keep * sizeof *keep));
    for (int j = 0; j < p->keep; j++)
        keep[j] = j;
    fmb_status st = fmb_project(v, p->s, keep, p->keep, projection, r);
    free(keep);
    return st;
}

int qualify_answer_find(fmb_solver *v, const char *name, const study_projection *p,
                        qualify_answer *out)
{
    fmb_result r = {.size = sizeof r};
    fmb_system *projection = NULL;
    bool accepted = false;
    fmb_status st = ask(v, p, &projection, &r);
    if (st == FMB_OK && r.stop == FMB_STOP_DONE)
        st = check(v, p->s, &accepted);
    *out = (qualify_answer){.verdict = r.verdict};
    if (st == FMB_OK && accepted) {
        if (projection)
            note_rows(projection, out);
        note_digest(projection, out);
    }
    fmb_system_free(projection);
    if (st != FMB_OK)
        return app_status_error(st);
    if (r.stop != FMB_STOP_DONE)
        return APP_UNDECIDED;
    return accepted ? APP_YES : app_error(APP_INTERNAL, "%s: the answer is not proved", name);
}
