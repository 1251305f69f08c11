/* rows.c: 20,000 rows in at once, a point or the rows in conflict, a projection out as doubles:
 * cc rows.c -o rows $(pkg-config --cflags --libs fmb). Takes the right side of the last row. */
#include <fmb/fmb.h>

#include "ring.h"

int main(int argc, char **argv)
{
    fmb_system *s = NULL, *image = NULL;
    fmb_solver *v = NULL;
    fmb_matrix *m = NULL;
    fmb_result r = {.size = sizeof r};
    double x[DIM];
    size_t n = 0;
    make_ring(argc, argv);
    bool failed = fmb_system_new(DIM, NULL, &s) || fmb_solver_new(NULL, NULL, &v) ||
                  fmb_system_add_rows(s, ROWS, start, var, coef, NULL, b) ||
                  fmb_project(v, s, kept, 3, &image, NULL) || fmb_system_matrix(image, &m) ||
                  fmb_solve(v, s, &r) ||
                  (r.verdict == FMB_FEASIBLE ? fmb_solver_point(v, x) : fmb_solver_conflict(v, &n));
    if (failed)
        fprintf(stderr, "failed: %s%s\n", fmb_system_trouble(s), fmb_solver_trouble(v));
    else if (r.verdict == FMB_FEASIBLE)
        printf("feasible: %g %g ... %g\n", x[0], x[1], x[DIM - 1]);
    else
        printf("infeasible: %zu rows, up to row %zu\n", n, fmb_solver_conflict_row(v, n - 1));
    for (size_t i = 0; !failed && i < m->rows; i++) {
        for (size_t k = m->start[i]; k < m->start[i + 1]; k++)
            printf("%+g %s ", m->coef[k], fmb_system_name(image, m->var[k]));
        printf("%s %g\n", fmb_rel_text(m->rel[i]), m->b[i]);
    }
    fmb_matrix_free(m);
    fmb_system_free(image);
    fmb_solver_free(v);
    fmb_system_free(s);
    return failed;
}
