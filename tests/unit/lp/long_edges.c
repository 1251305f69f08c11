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

typedef struct chain {
    fmb_options o;
    fmb_mem mem;
    fmb_run run;
    atomic_int cancel;
    fmb_program p;
    fmb_scaled_program f;
    fmb_simplex_state state;
} chain;

static void open_chain(chain *c, fmb_inverse_kind kind)
{
    *c = (chain){.o.size = sizeof c->o};
    fmb_mem_init(&c->mem, NULL, 0);
    fmb_run_begin(&c->run, &c->mem, &c->o, &c->cancel, (fmb_sink){0}, "test");
    fmb_program_init(&c->p, &c->mem, LINKS);
    append_chain(&c->p);
    cr_assert_eq(fmb_scaled_program_init(&c->f, &c->run, &c->p), FMB_OK);
    cr_assert_eq(fmb_simplex_state_init(&c->state, &c->f, kind), FMB_OK);
}

static void close_chain(chain *c)
{
    fmb_simplex_state_clear(&c->state);
    fmb_scaled_program_clear(&c->f);
    fmb_program_clear(&c->p);
    cr_assert_eq(c->mem.used, 0);
}

static bool is_member(const chain *c, size_t i)
{
    bool found = false;
    for (size_t r = 0; r < LINKS; r++)
        found = found || c->state.basis.member[r] == i;
    return found;
}

/* From x_0 = 1 and all of the chain, where the primal method begins. */
Test(long_edges, stop_where_the_slowest_row_does)
{
    chain c;
    fmb_simplex_end end;
    size_t odd;
    open_chain(&c, FMB_INVERSE_FACTORS);
    cr_assert_eq(fmb_simplex_state_place(&c.state, (size_t[LINKS]){1, 2, 3, 4, 5, 6, 7}), FMB_OK);
    c.state.cost[0] = 1;
    c.state.most_steps = 1;
    cr_assert_eq(fmb_primal_simplex(&c.state, &end, &odd), FMB_OK);
    cr_assert_eq(end, FMB_SIMPLEX_DONE);
    cr_assert(is_member(&c, 0));
    close_chain(&c);
}

/* Row 2 has its largest coefficient where a unit vector is. */
Test(bases, keep_unit_vectors_when_recomputed)
{
    for (int kind = FMB_INVERSE_FACTORS; kind <= FMB_INVERSE_EXPLICIT; kind++) {
        chain c;
        size_t member[LINKS] = {2};
        open_chain(&c, (fmb_inverse_kind)kind);
        for (size_t r = 1; r < LINKS; r++)
            member[r] = FMB_UNIT + (r == 1 ? 0 : r);
        cr_assert_eq(fmb_simplex_state_place(&c.state, member), FMB_OK);
        for (size_t r = 0; r < LINKS; r++)
            cr_assert(is_member(&c, member[r]), "%d %zu", kind, r);
        close_chain(&c);
    }
}
