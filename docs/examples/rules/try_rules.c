/* try_rules.c: ask whether a system is feasible with the help of a rule, and let the checker judge
 * the answer. First the honest rule, then the same one with a lie in its table. */
#include <fmb/fmb.h>
#include <stdio.h>
#include <stdlib.h>

#include "same_rows.h"

static void need(fmb_status st)
{
    if (st != FMB_OK) {
        fprintf(stderr, "%s\n", fmb_status_text(st));
        exit(1);
    }
}

/* Eight rows a.x <= b without a solution: the first seven force x4 = 0, the last wants x4 >= 1. */
static fmb_system *build(void)
{
    static const int64_t row[][5] = {{1, 1, -1, -1, 0}, {-1, -1, -1, -1, 0}, {0, 1, 0, 0, 0},
                                     {-1, 0, 1, 0, 0},  {1, 1, 0, 1, 0},     {1, -1, 0, 1, 0},
                                     {-1, 0, 0, -1, 0}, {0, 0, 0, -1, -1}};
    fmb_system *s;
    need(fmb_system_new(4, NULL, &s));
    for (int i = 0; i < 8; i++)
        need(fmb_system_add_int(s, row[i], FMB_LE, row[i][4]));
    return s;
}

static void judge(const fmb_solver *v, const fmb_system *s)
{
    fmb_evidence *evidence;
    fmb_judgement j = {.size = sizeof j};
    need(fmb_solver_evidence(v, &evidence));
    need(fmb_check(s, evidence, &j));
    if (j.accepted)
        puts("accepted");
    else
        printf("rejected, %s\n", j.reason);
    fmb_evidence_free(evidence);
}

/* Kohler's rule counts on every row that it has not dropped itself. */
static void try(const fmb_rule *rule, fmb_rebase rebase)
{
    fmb_options o = {.size = sizeof o};
    o.method = FMB_METHOD_FM;
    o.order = FMB_ORDER_GIVEN;
    o.rules = "kohler";
    o.rebase = rebase;
    fmb_system *s = build();
    fmb_solver *v;
    fmb_result r = {.size = sizeof r};
    need(fmb_solver_new(&o, NULL, &v));
    need(fmb_solver_add_rule(v, rule));
    fmb_status st = fmb_solve(v, s, &r);
    if (st == FMB_OK) {
        printf("%s: %s: ", rule->name, fmb_verdict_text(r.verdict));
        judge(v, s);
    } else {
        printf("%s: %s\n", rule->name, fmb_solver_trouble(v));
    }
    fmb_solver_free(v);
    fmb_system_free(s);
}

int main(void)
{
    fmb_rule liar = same_rows;
    liar.name = "liar";
    liar.flags = 0; /* "I drop nothing that a rule of histories would miss" */
    try(&same_rows, FMB_REBASE_ALWAYS);
    try(&same_rows, FMB_REBASE_NEVER);
    try(&liar, FMB_REBASE_NEVER);
    return 0;
}
