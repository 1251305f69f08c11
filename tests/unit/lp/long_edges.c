/* long_edges.c: along an edge of a chain of columns, each 64 times the one before, the last moves
 * 10^10 times as fast as the first, which must still stop at its bound. */
#include <criterion/criterion.h>

#include "lp/simplex/simplex_methods.h"
#include "support/support.h"

enum { LINKS = 7, BOUND = 5 };

static void append(fmb_program *p, size_t first, int64_t a, int64_t b, fmb_rel rel, int64_t right)
{
    int64_t s[LINKS + 1] = {0};
    fmb_vec v = {.s = s};
    s[first] = a;
    s[LINKS] = right;
    if (b != 0)
        s[first + 1] = b;
    fmb_vec_measure(&v, LINKS + 1);
    cr_assert_eq(fmb_program_add_dense(p, &v, rel), FMB_OK);
}

/* 1 <= x_0 <= BOUND, x_{k+1} = 64 x_k, and the last is far from its bound. */
static void append_chain(fmb_program *p)
{
    append(p, 0, 1, 0, FMB_LE, BOUND);
    append(p, 0, -1, 0, FMB_LE, -1);
    for (size_t k = 0; k + 1 < LINKS; k++)
        append(p, k, -64, 1, FMB_EQ, 0);
    append(p, LINKS - 1, 1, 0, FMB_LE, 100000000000000);
}

/* From x_0 = 1 and all of the chain, where the primal method begins. */
Test(long_edges, stop_where_the_slowest_row_does)
{
    fmb_options o = {.size = sizeof o};
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel = 0;
    fmb_program p;
    fmb_scaled_program f;
    fmb_simplex_state state;
    fmb_simplex_end end;
    size_t odd, at_bound = 0;
    fmb_mem_init(&mem, NULL, 0);
    fmb_run_begin(&run, &mem, &o, &cancel, (fmb_sink){0}, "test");
    fmb_program_init(&p, &mem, LINKS);
    append_chain(&p);
    cr_assert_eq(fmb_scaled_program_init(&f, &run, &p), FMB_OK);
    cr_assert_eq(fmb_simplex_state_init(&state, &f, FMB_INVERSE_FACTORS), FMB_OK);
    cr_assert_eq(fmb_simplex_state_place(&state, (size_t[LINKS]){1, 2, 3, 4, 5, 6, 7}), FMB_OK);
    state.cost[0] = 1;
    state.most_steps = 1;
    cr_assert_eq(fmb_primal_simplex(&state, &end, &odd), FMB_OK);
    cr_assert_eq(end, FMB_SIMPLEX_DONE);
    for (size_t r = 0; r < LINKS; r++)
        at_bound += state.basis.member[r] == 0;
    cr_assert_eq(at_bound, 1);
    fmb_simplex_state_clear(&state);
    fmb_scaled_program_clear(&f);
    fmb_program_clear(&p);
    cr_assert_eq(mem.used, 0);
}
