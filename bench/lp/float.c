/* float.c: a linear program by GLPK alone, as its own command solves it: times and results.
 *
 *   bench-lp-float FILE.mps...
 *
 * A line of JSON a file: CPU time to read it, to find out whether it has a solution (without its
 * objective), and to solve it, with status and value. Integers are taken for reals; an objective to
 * maximize is negated, as all values are minima. See tests/regress/cases/programs.py.
 */
#include <glpk.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "../machine.h"

/* Free format first, then fixed columns. */
static glp_prob *read_program(const char *path, double *seconds)
{
    for (int format = GLP_MPS_FILE, n = 0; n < 2; n++, format = GLP_MPS_DECK) {
        glp_prob *p = glp_create_prob();
        double begin = thread_seconds();
        int failed = glp_read_mps(p, format, NULL, path);
        *seconds = thread_seconds() - begin;
        if (!failed)
            return p;
        glp_delete_prob(p);
    }
    return NULL;
}

static const char *status_word(int failed, int status)
{
    return failed == GLP_ENOPFS || status == GLP_NOFEAS  ? "infeasible"
           : failed == GLP_ENODFS || status == GLP_UNBND ? "unbounded"
           : failed == 0 && status == GLP_OPT            ? "optimal"
           : failed == 0 && status == GLP_FEAS           ? "feasible"
                                                         : "unknown";
}

/* As glpsol does: scaled, from an advanced basis, with its presolver. [s] */
static double solve_program(glp_prob *p, const char **status)
{
    glp_smcp how;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.presolve = GLP_ON;
    double begin = thread_seconds();
    glp_scale_prob(p, GLP_SF_AUTO);
    glp_adv_basis(p, 0);
    int failed = glp_simplex(p, &how);
    double took = thread_seconds() - begin;
    *status = status_word(failed, glp_get_status(p));
    return took;
}

static bool solve_file(const char *path)
{
    const char *verdict, *status;
    double reading, deciding, solving, sign = 1;
    glp_prob *p = read_program(path, &reading);
    if (!p)
        return false;
    glp_prob *bare = glp_create_prob();
    glp_copy_prob(bare, p, GLP_OFF);
    for (int j = 0; j <= glp_get_num_cols(bare); j++)
        glp_set_obj_coef(bare, j, 0);
    deciding = solve_program(bare, &verdict);
    if (glp_get_obj_dir(p) == GLP_MAX)
        sign = -1;
    solving = solve_program(p, &status);
    printf("{\"file\": \"%s\", \"rows\": %d, \"columns\": %d, \"read\": %.6f, \"verdict\": \"%s\", "
           "\"decide\": %.6f, \"status\": \"%s\", \"solve\": %.6f, \"value\": %.12g}\n",
           path, glp_get_num_rows(p), glp_get_num_cols(p), reading, verdict, deciding, status,
           solving, sign * glp_get_obj_val(p));
    glp_delete_prob(bare);
    glp_delete_prob(p);
    return true;
}

int main(int argc, char **argv)
{
    bool good = argc > 1;
    glp_term_out(GLP_OFF);
    for (int i = 1; i < argc; i++)
        if (!solve_file(argv[i])) {
            fprintf(stderr, "%s: cannot be read\n", argv[i]);
            good = false;
        }
    glp_free_env();
    return good ? 0 : 66;
}
