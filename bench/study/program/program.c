/* program.c: the table of families, and how a program is drawn. See program.h. */
#include "study/program/program.h"

#include <stdlib.h>
#include <string.h>

#include "study/program/writer.h"

static const struct {
    const char *name, *about;
    study_family *write;
    int rows, variables; /* the usual size; rows 0: they follow from the variables */
    fmb_verdict verdict;
} FAMILY[] = {
    {"sparse-origin", "8 terms a row, the origin is a solution", study_sparse_origin, 400, 100,
     FMB_FEASIBLE},
    {"sparse-point", "8 terms a row around a planted point", study_sparse_point, 400, 100,
     FMB_FEASIBLE},
    {"sparse-conflict", "8 terms a row, some of them in conflict", study_sparse_conflict, 400, 100,
     FMB_INFEASIBLE},
    {"dense-origin", "all terms, the origin is a solution", study_dense_origin, 80, 40,
     FMB_FEASIBLE},
    {"dense-point", "all terms around a planted point", study_dense_point, 80, 40, FMB_FEASIBLE},
    {"dense-conflict", "all terms, some rows in conflict", study_dense_conflict, 80, 40,
     FMB_INFEASIBLE},
    {"degenerate", "all rows through one point, which is the only one or not", study_degenerate,
     120, 30, FMB_FEASIBLE},
    {"strict", "8 terms, a third of the rows strict, around a point", study_strict, 200, 50,
     FMB_FEASIBLE},
    {"strict-cycle", "x1 < x2 < ... < xn < x1 among other rows", study_strict_cycle, 100, 50,
     FMB_INFEASIBLE},
    {"equalities", "half as many equalities as variables, around a point", study_equalities, 150,
     100, FMB_FEASIBLE},
    {"unbounded", "8 terms, a ray is planted and the goal goes along it", study_unbounded, 200, 100,
     FMB_FEASIBLE},
    {"ball", "rows around a ball, near it", study_ball, 500, 5, FMB_FEASIBLE},
    {"sphere", "rows that touch a ball, up to rounding", study_sphere, 1000, 3, FMB_FEASIBLE},
    {"klee-minty", "the cube on which the simplex visits all vertices", study_klee_minty, 0, 20,
     FMB_FEASIBLE},
    {"beale", "Beale's example, on which pivots cycle", study_beale, 0, 4, FMB_FEASIBLE},
    {"kuhn", "Kuhn's example, on which pivots cycle", study_kuhn, 0, 4, FMB_FEASIBLE},
    {"cube", "the unit cube, and a row through its last vertex", study_cube, 0, 20, FMB_FEASIBLE},
    {"chain", "x_i in terms of x_i+1, inequalities", study_chain, 0, 100, FMB_FEASIBLE},
    {"chain-equal", "the same with equalities: numbers grow", study_chain_equal, 0, 100,
     FMB_FEASIBLE},
    {"assignment", "k x k assignment polytope, k^2 variables", study_assignment, 0, 100,
     FMB_FEASIBLE},
    {"transport", "k sources, 2k sinks, as many variables as fit; degenerate", study_transport, 0,
     128, FMB_FEASIBLE},
    {"staircase", "production and stock over periods of 8 variables", study_staircase, 0, 160,
     FMB_FEASIBLE},
};

enum { FAMILIES = sizeof FAMILY / sizeof *FAMILY, MOST = 100000 };

int study_program_families(void)
{
    return FAMILIES;
}

const char *study_program_name(int family)
{
    return FAMILY[family].name;
}

const char *study_program_about(int family)
{
    return FAMILY[family].about;
}

/* A number 1 ... MOST at *at, which goes on behind it. */
static bool read_size(const char **at, int *out)
{
    char *end;
    long n = strtol(*at, &end, 10);
    bool good = end != *at && n >= 1 && n <= MOST;
    *at = end;
    *out = (int)n;
    return good;
}

bool study_program_plan_parse(const char *text, study_program_plan *out, const char **bad)
{
    size_t n = strcspn(text, ":");
    int k = 0;
    while (k < FAMILIES && (strncmp(text, FAMILY[k].name, n) != 0 || FAMILY[k].name[n] != '\0'))
        k++;
    *bad = "there is no such family";
    if (k == FAMILIES)
        return false;
    out->family = k;
    out->rows = FAMILY[k].rows;
    out->variables = FAMILY[k].variables;
    if (text[n] == '\0')
        return true;
    const char *at = text + n + 1;
    bool good = true;
    *bad = FAMILY[k].rows ? "a size is written ROWSxVARIABLES" : "a size is a number of variables";
    if (FAMILY[k].rows) {
        good = read_size(&at, &out->rows) && *at == 'x';
        at += good;
    }
    return good && read_size(&at, &out->variables) && *at == '\0';
}

void study_program_plan_text(const study_program_plan *plan, char *out, size_t size)
{
    const char *name = FAMILY[plan->family].name;
    if (FAMILY[plan->family].rows)
        snprintf(out, size, "%s:%dx%d", name, plan->rows, plan->variables);
    else
        snprintf(out, size, "%s:%d", name, plan->variables);
}

fmb_status study_program_draw(const study_program_plan *plan, study_program *out)
{
    study_program p = {.verdict = FAMILY[plan->family].verdict};
    study_writer w = {.rows = plan->rows, .variables = plan->variables, .to = &p};
    w.g.state = plan->seed * FAMILIES + (uint64_t)plan->family;
    mpq_init(p.best);
    mpq_init(w.right);
    FAMILY[plan->family].write(&w);
    if (w.st == FMB_OK)
        w.st =
            fmb_system_set_objective(p.s, &(fmb_objective){.sense = FMB_SENSE_MAX, .coef = w.goal});
    for (size_t k = 0; k < w.capacity; k++)
        mpq_clear(w.coef[k]);
    mpq_clear(w.right);
    free(w.var);
    free(w.goal);
    free(w.coef);
    if (w.st == FMB_OK)
        *out = p;
    else
        study_program_clear(&p);
    return w.st;
}

void study_program_clear(study_program *p)
{
    fmb_system_free(p->s);
    mpq_clear(p->best);
}
