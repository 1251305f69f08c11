// rows.cpp: rows.c in C++20: c++ -std=c++20 rows.cpp -o rows $(pkg-config --cflags --libs fmb).
#include <fmb/fmb.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

struct Free {
    void operator()(fmb_system *s) const { fmb_system_free(s); }
    void operator()(fmb_solver *v) const { fmb_solver_free(v); }
};
using System = std::unique_ptr<fmb_system, Free>;
using Solver = std::unique_ptr<fmb_solver, Free>;

static void need(fmb_status st, const char *trouble = "")
{
    if (st != FMB_OK)
        throw std::runtime_error(std::string(fmb_status_text(st)) + ": " + trouble);
}

// Rows in compressed form (CSR), all of them <=.
struct Rows {
    std::vector<std::size_t> start{0};
    std::vector<int> var;
    std::vector<double> coef, right;

    Rows &add(std::initializer_list<std::pair<int, double>> terms, double b)
    {
        for (auto [j, a] : terms) {
            var.push_back(j);
            coef.push_back(a);
        }
        start.push_back(var.size());
        right.push_back(b);
        return *this;
    }
    System load(int dim) const
    {
        fmb_system *s = nullptr;
        need(fmb_system_new(dim, nullptr, &s));
        System out(s);
        need(fmb_system_add_rows(s, right.size(), start.data(), var.data(), coef.data(), nullptr,
                                 right.data()),
             fmb_system_trouble(s));
        return out;
    }
};

static void print_answer(fmb_solver *v, fmb_verdict verdict, int dim)
{
    std::size_t n = 0;
    if (verdict == FMB_FEASIBLE) {
        std::vector<double> x(static_cast<std::size_t>(dim));
        need(fmb_solver_point(v, x.data()), fmb_solver_trouble(v));
        std::printf("feasible: %g %g ... %g\n", x[0], x[1], x.back());
        return;
    }
    need(fmb_solver_conflict(v, &n), fmb_solver_trouble(v));
    std::printf("infeasible: %zu rows in conflict\n", n);
    for (std::size_t k = 0; k < n; k += n - 1)
        std::printf("%g * row %zu\n", fmb_solver_conflict_multiplier(v, k),
                    fmb_solver_conflict_row(v, k));
}

static void print_rows(const fmb_system *s)
{
    std::size_t rows = fmb_system_rows(s), terms = fmb_system_nonzeros(s);
    std::vector<std::size_t> start(rows + 1);
    std::vector<int> var(terms);
    std::vector<double> coef(terms), right(rows);
    need(fmb_system_get_rows(s, 0, rows, start.data(), var.data(), coef.data(), nullptr,
                             right.data()));
    for (std::size_t i = 0; i < rows; i++) {
        for (std::size_t k = start[i]; k < start[i + 1]; k++)
            std::printf("%+g %s ", coef[k], fmb_system_name(s, var[k]));
        std::printf("<= %g\n", right[i]);
    }
}

int main(int argc, char **argv)
try {
    constexpr int rows = 20000, dim = 100;
    const double last = argc > 1 ? std::atof(argv[1]) : 0;
    Rows ring, some;
    for (int i = 0; i < rows - 1; i++)
        ring.add({{i % dim, 1}, {(i % dim + 1 + i / dim % (dim - 1)) % dim, -1}},
                 i < dim - 1 ? 0 : dim + i % 7);
    System s = ring.add({{dim - 1, 1}, {0, -1}}, last).load(dim);
    fmb_solver *v = nullptr;
    need(fmb_solver_new(nullptr, nullptr, &v));
    Solver solver(v);
    fmb_result r;
    need(fmb_solve(v, s.get(), &r), fmb_solver_trouble(v));
    print_answer(v, r.verdict, dim);

    // x1 + x2 <= 2, x2 <= x3 <= 3 x2, without x2.
    some.add({{0, 1}, {1, 1}}, 2).add({{1, 1}, {2, -1}}, 0).add({{1, -3}, {2, 1}}, 0);
    const int keep[] = {0, 2};
    fmb_system *shadow = nullptr;
    need(fmb_project(v, some.load(3).get(), keep, 2, &shadow, nullptr), fmb_solver_trouble(v));
    print_rows(System(shadow).get());
    return EXIT_SUCCESS;
} catch (const std::exception &e) {
    std::fprintf(stderr, "%s\n", e.what());
    return EXIT_FAILURE;
}
