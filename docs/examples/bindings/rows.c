/* rows.c: 20,000 rows in at once, a point or the rows in conflict, and a projection out as doubles:
 * cc rows.c -o rows $(pkg-config --cflags --libs fmb). Takes the right side of the last row. */
#include <fmb/fmb.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROWS = 20000, DIM = 100 };

static void need(fmb_status st, const char *trouble)
{
    if (st != FMB_OK) {
        fprintf(stderr, "%s: %s\n", fmb_status_text(st), trouble);
        exit(EXIT_FAILURE);
    }
}

int main(int argc, char **argv)
{
    static size_t start[ROWS + 1], n;
    static int var[2 * ROWS], keep[] = {0, DIM / 2, DIM - 1};
    static double coef[2 * ROWS], b[ROWS], x[DIM];
    fmb_system *s, *image;
    fmb_solver *v;
    fmb_result r = {.size = sizeof r};
    fmb_matrix *m;
    for (int i = 0; i < ROWS; i++) { /* a variable is at most b beyond the next in the ring */
        start[i + 1] = 2 * (size_t)i + 2;
        var[2 * i] = i % DIM;
        var[2 * i + 1] = (i + 1) % DIM;
        coef[2 * i] = 1;
        coef[2 * i + 1] = -1;
        b[i] = i < DIM - 1 ? 0 : i < ROWS - 1 ? i : argc > 1 ? atof(argv[1]) : 5;
    }
    need(fmb_system_new(DIM, NULL, &s), "");
    need(fmb_system_add_rows(s, ROWS, start, var, coef, NULL, b), fmb_system_trouble(s));
    need(fmb_solver_new(NULL, NULL, &v), "");
    need(fmb_solve(v, s, &r), fmb_solver_trouble(v));
    if (r.verdict == FMB_FEASIBLE) {
        need(fmb_solver_point(v, x), fmb_solver_trouble(v));
        printf("feasible: %g %g ... %g\n", x[0], x[1], x[DIM - 1]);
    } else {
        need(fmb_solver_conflict(v, &n), fmb_solver_trouble(v));
        printf("infeasible: %zu rows, up to row %zu\n", n, fmb_solver_conflict_row(v, n - 1));
    }
    need(fmb_project(v, s, keep, 3, &image, NULL), fmb_solver_trouble(v));
    need(fmb_system_matrix(image, &m), "");
    for (size_t i = 0; i < m->rows; i++) {
        for (size_t k = m->start[i]; k < m->start[i + 1]; k++)
            printf("%+g %s ", m->coef[k], fmb_system_name(image, m->var[k]));
        printf("%s %g\n", fmb_rel_text(m->rel[i]), m->b[i]);
    }
    fmb_matrix_free(m);
    fmb_system_free(image);
    fmb_solver_free(v);
    fmb_system_free(s);
}
