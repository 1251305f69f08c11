// rows.cpp: rows.c in C++20: c++ -std=c++20 rows.cpp -o rows $(pkg-config --cflags --libs fmb).
#include <fmb/fmb.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

template <class T, void (*release)(T *)> struct Owned {
    T *p = nullptr;
    Owned() = default;
    Owned(const Owned &) = delete;
    ~Owned() { release(p); }
    operator T *() const { return p; }
    T *operator->() const { return p; }
};

int main(int argc, char **argv)
{
    constexpr int rows = 20000, dim = 100, keep[] = {0, dim / 2, dim - 1};
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
    Owned<fmb_system, fmb_system_free> s, image;
    Owned<fmb_solver, fmb_solver_free> v;
    Owned<fmb_matrix, fmb_matrix_free> m;
    fmb_result r{};
    r.size = sizeof r;
    std::size_t n = 0;
    if (fmb_system_new(dim, nullptr, &s.p) || fmb_solver_new(nullptr, nullptr, &v.p) ||
        fmb_system_add_rows(s, rows, start.data(), var.data(), coef.data(), nullptr, b.data()) ||
        fmb_project(v, s, keep, 3, &image.p, nullptr) || fmb_system_matrix(image, &m.p) ||
        fmb_solve(v, s, &r) ||
        (r.verdict == FMB_FEASIBLE ? fmb_solver_point(v, x.data()) : fmb_solver_conflict(v, &n))) {
        std::fprintf(stderr, "failed: %s%s\n", fmb_system_trouble(s), fmb_solver_trouble(v));
        return EXIT_FAILURE;
    }
    if (r.verdict == FMB_FEASIBLE)
        std::printf("feasible: %g %g ... %g\n", x[0], x[1], x.back());
    else
        std::printf("infeasible: %zu rows, up to row %zu\n", n, fmb_solver_conflict_row(v, n - 1));
    for (std::size_t i = 0; i < m->rows; i++) {
        for (std::size_t k = m->start[i]; k < m->start[i + 1]; k++)
            std::printf("%+g %s ", m->coef[k], fmb_system_name(image, m->var[k]));
        std::printf("%s %g\n", fmb_rel_text(m->rel[i]), m->b[i]);
    }
}
