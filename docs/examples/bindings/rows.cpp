// rows.cpp: rows.c in C++20: c++ -std=c++20 rows.cpp -o rows $(pkg-config --cflags --libs fmb).
#include <fmb/fmb.h>

#include "ring.h"

template <class T, void (*release)(T *)> struct Owned { // neither copied nor moved
    T *p = nullptr;
    Owned &operator=(Owned &&) = delete;
    ~Owned() { release(p); }
    operator T *() const { return p; }
};

int main(int argc, char **argv)
{
    Owned<fmb_system, fmb_system_free> s, image;
    Owned<fmb_solver, fmb_solver_free> v;
    Owned<fmb_matrix, fmb_matrix_free> m;
    fmb_result r{};
    r.size = sizeof r;
    double x[DIM];
    size_t n = 0;
    make_ring(argc, argv);
    bool failed = fmb_system_new(DIM, nullptr, &s.p) || fmb_solver_new(nullptr, nullptr, &v.p) ||
                  fmb_system_add_rows(s, ROWS, start, var, coef, nullptr, b) ||
                  fmb_project(v, s, kept, 3, &image.p, nullptr) || fmb_system_matrix(image, &m.p) ||
                  fmb_solve(v, s, &r) ||
                  (r.verdict == FMB_FEASIBLE ? fmb_solver_point(v, x) : fmb_solver_conflict(v, &n));
    if (failed)
        fprintf(stderr, "failed: %s%s\n", fmb_system_trouble(s), fmb_solver_trouble(v));
    else if (r.verdict == FMB_FEASIBLE)
        printf("feasible: %g %g ... %g\n", x[0], x[1], x[DIM - 1]);
    else
        printf("infeasible: %zu rows, up to row %zu\n", n, fmb_solver_conflict_row(v, n - 1));
    for (size_t i = 0; !failed && i < m.p->rows; i++) {
        for (size_t k = m.p->start[i]; k < m.p->start[i + 1]; k++)
            printf("%+g %s ", m.p->coef[k], fmb_system_name(image, m.p->var[k]));
        printf("%s %g\n", fmb_rel_text(m.p->rel[i]), m.p->b[i]);
    }
    return failed;
}
