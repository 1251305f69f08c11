/* question.c: see question.h. */
#include <stdlib.h>

#include "options.h"
#include "question.h"

int question_keep(uint64_t choice, int dim, int *keep)
{
    int n = 0;
    for (int j = 0; j < dim; j++)
        if (choice >> j & 1)
            keep[n++] = j;
    return n;
}

/* The same choice whenever the same number of variables is left. */
static int choose(void *self, const fmb_view *w, const int *col, size_t n)
{
    const question *q = self;
    support_rng g = {q->order + n};
    (void)w;
    return col[support_next(&g) % n];
}

fmb_solver *question_solver(question *q)
{
    fmb_solver *v = NULL;
    must(fmb_solver_new(&q->options, NULL, &v));
    if (q->order != 0)
        fmb_solver_set_chooser(v, (fmb_chooser){choose, q});
    return v;
}

bool question_holds(const question *q, agree *g, fmb_solver *v, const truth *t)
{
    int keep[64], n = question_keep(q->choice, fmb_system_dim(t->s), keep);
    switch (q->kind) {
    case ASK_SOLVE:
        return agree_solve(g, v, t);
    case ASK_BOUND:
        return agree_bound(g, v, t);
    case ASK_PROJECT:
        return agree_project(g, v, t, keep, n, NULL);
    case ASK_REDUCE:
        return agree_reduce(g, v, t, NULL);
    case ASK_OPTIMIZE:
        return agree_optimize(g, v, t, q->choice);
    case ASK_END:
        return agree_end(g, v, t, (int)(q->choice % (uint64_t)fmb_system_dim(t->s)));
    default:
        return property_holds(q, g, v, t);
    }
}

void question_text(const question *q, char *out, size_t size)
{
    static const char *const kind[] = {"solve",    "bound",    "project", "reduce",
                                       "optimize", "shuffled", "scaled",  "renamed",
                                       "padded",   "twice",    "end"};
    char options[200];
    options_text(&q->options, options, sizeof options);
    snprintf(out, size, "%s, %s, choice %llu, order %llu", kind[q->kind], options,
             (unsigned long long)q->choice, (unsigned long long)q->order);
}

bool question_fails(void *self, const fmb_system *s)
{
    question *q = self;
    agree g = {.max_rows = 2000};
    fmb_solver *v = question_solver(q);
    truth t;
    truth_init(&t, s, g.max_rows);
    bool good = question_holds(q, &g, v, &t);
    truth_clear(&t);
    fmb_solver_free(v);
    return !good;
}

void question_report(const question *q, agree *g, const support_case *c)
{
    char text[320];
    question again = *q;
    question_text(q, text, sizeof text);
    fprintf(stderr, "\ndisagreement: %s\n  %s\n", text, g->why);
    if (question_fails(&again, c->s))
        support_report(c, question_fails, &again);
    else
        fprintf(stderr, "  only with what the solver did before; seed %llu\n",
                (unsigned long long)c->seed);
}
