// rows.cpp: rows.c in C++20: c++ -std=c++20 rows.cpp -o rows $(pkg-config --cflags --libs fmb).
#include <fmb/fmb.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

template <auto free> using By = decltype([](auto *p) { free(p); });

static void need(fmb_status st, const char *trouble = "")
{
    if (st != FMB_OK) {
        std::fprintf(stderr, "%s: %s\n", fmb_status_text(st), trouble);
        std::exit(EXIT_FAILURE);
    }
}

int main(int argc, char **argv)
{
    constexpr int rows = 20000, dim = 100;
    const int keep[] = {0, dim / 2, dim - 1};
    std::vector<std::size_t> start{0};
    std::vector<int> var;
    std::vector<double> coef, b, x(dim);
    for (int i = 0; i < rows; i++) { // a variable is at most b beyond the next in the ring
        var.insert(var.end(), {i % dim, (i + 1) % dim});
        coef.insert(coef.end(), {1, -1});
        b.push_back(i < dim - 1 ? 0 : i);
        start.push_back(var.size());
    }
    b.back() = argc > 1 ? std::atof(argv[1]) : 5;
    std::size_t n;
    fmb_system *s, *image;
    fmb_solver *v;
    fmb_matrix *m;
    fmb_result r{};
    r.size = sizeof r;
    need(fmb_system_new(dim, nullptr, &s));
    std::unique_ptr<fmb_system, By<fmb_system_free>> own_s(s);
    need(fmb_system_add_rows(s, rows, start.data(), var.data(), coef.data(), nullptr, b.data()),
         fmb_system_trouble(s));
    need(fmb_solver_new(nullptr, nullptr, &v));
    std::unique_ptr<fmb_solver, By<fmb_solver_free>> own_v(v);
    need(fmb_solve(v, s, &r), fmb_solver_trouble(v));
    if (r.verdict == FMB_FEASIBLE) {
        need(fmb_solver_point(v, x.data()), fmb_solver_trouble(v));
        std::printf("feasible: %g %g ... %g\n", x[0], x[1], x.back());
    } else {
        need(fmb_solver_conflict(v, &n), fmb_solver_trouble(v));
        std::printf("infeasible: %zu rows, up to row %zu\n", n, fmb_solver_conflict_row(v, n - 1));
    }
    need(fmb_project(v, s, keep, 3, &image, nullptr), fmb_solver_trouble(v));
    std::unique_ptr<fmb_system, By<fmb_system_free>> own_image(image);
    need(fmb_system_matrix(image, &m));
    std::unique_ptr<fmb_matrix, By<fmb_matrix_free>> own_m(m);
    for (std::size_t i = 0; i < m->rows; i++) {
        for (std::size_t k = m->start[i]; k < m->start[i + 1]; k++)
            std::printf("%+g %s ", m->coef[k], fmb_system_name(image, m->var[k]));
        std::printf("%s %g\n", fmb_rel_text(m->rel[i]), m->b[i]);
    }
}
