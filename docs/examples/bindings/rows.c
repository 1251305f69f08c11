/* rows.c: 20,000 rows in at once, a point or the rows in conflict, and a projection out again as
 * doubles: cc rows.c -o rows $(pkg-config --cflags --libs fmb). Takes the right side of the last
 * row; below 0 the rows have no common solution. */
#include <fmb/fmb.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROWS = 20000, DIM = 100 };

static void need(fmb_status st, const char *trouble)
{
    if (st == FMB_OK)
        return;
    fprintf(stderr, "%s: %s\n", fmb_status_text(st), trouble);
    exit(EXIT_FAILURE);
}

/* Row i says how far one variable may be beyond another; the last row closes a ring of the first
 * DIM, which say that each variable is at most the next. */
static fmb_system *load_rows(double last)
{
    static size_t start[ROWS + 1];
    static int var[2 * ROWS];
    static double coef[2 * ROWS], b[ROWS];
    fmb_system *s;
    for (int i = 0; i < ROWS; i++) {
        start[i + 1] = 2 * (size_t)i + 2;
        var[2 * i] = i == ROWS - 1 ? DIM - 1 : i % DIM;
        var[2 * i + 1] = i == ROWS - 1 ? 0 : (i % DIM + 1 + i / DIM % (DIM - 1)) % DIM;
        coef[2 * i] = 1;
        coef[2 * i + 1] = -1;
        b[i] = i == ROWS - 1 ? last : i < DIM - 1 ? 0 : DIM + i % 7;
    }
    need(fmb_system_new(DIM, NULL, &s), "");
    need(fmb_system_add_rows(s, ROWS, start, var, coef, NULL, b), fmb_system_trouble(s));
    return s;
}

static void print_answer(fmb_solver *v, fmb_verdict verdict)
{
    double x[DIM];
    size_t n = 0;
    if (verdict == FMB_FEASIBLE) {
        need(fmb_solver_point(v, x), fmb_solver_trouble(v));
        printf("feasible: %g %g ... %g\n", x[0], x[1], x[DIM - 1]);
        return;
    }
    need(fmb_solver_conflict(v, &n), fmb_solver_trouble(v));
    printf("infeasible: %zu rows in conflict\n", n);
    for (size_t k = 0; k < n; k += n - 1)
        printf("%g * row %zu\n", fmb_solver_conflict_multiplier(v, k),
               fmb_solver_conflict_row(v, k));
}

/* x1 + x2 <= 2, x2 <= x3 <= 3 x2, without x2. */
static void project_some(fmb_solver *v)
{
    static const size_t start[] = {0, 2, 4, 6};
    static const int var[] = {0, 1, 1, 2, 1, 2}, keep[] = {0, 2};
    static const double coef[] = {1, 1, 1, -1, -3, 1}, b[] = {2, 0, 0};
    fmb_system *s, *shadow;
    size_t at[8];
    int of[16];
    double out[16], right[8];
    need(fmb_system_new(3, NULL, &s), "");
    need(fmb_system_add_rows(s, 3, start, var, coef, NULL, b), fmb_system_trouble(s));
    need(fmb_project(v, s, keep, 2, &shadow, NULL), fmb_solver_trouble(v));
    size_t rows = fmb_system_rows(shadow);
    need(fmb_system_get_rows(shadow, 0, rows, at, of, out, NULL, right), "");
    for (size_t i = 0; i < rows; i++) {
        for (size_t k = at[i]; k < at[i + 1]; k++)
            printf("%+g %s ", out[k], fmb_system_name(shadow, of[k]));
        printf("<= %g\n", right[i]);
    }
    fmb_system_free(shadow);
    fmb_system_free(s);
}

int main(int argc, char **argv)
{
    fmb_solver *v;
    fmb_result r;
    fmb_system *s = load_rows(argc > 1 ? atof(argv[1]) : 0);
    need(fmb_solver_new(NULL, NULL, &v), "");
    need(fmb_solve(v, s, &r), fmb_solver_trouble(v));
    print_answer(v, r.verdict);
    project_some(v);
    fmb_solver_free(v);
    fmb_system_free(s);
    return EXIT_SUCCESS;
}
