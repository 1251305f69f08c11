/* session.c: systems that change (<fmb/session.h>), against fresh solvers without any history;
 * every answer is proved. */
#include <criterion/criterion.h>
#include <string.h>

#include <fmb/gmp.h>

#include "fresh.h"
#include "property/random/rows.h"
#include "support.h"

/* Random steps, against a fresh solver each. FMB_SESSION_STEPS=10000: the slow suite; other games
 * with another FMB_SESSION_SEED. */
static int read_setting(const char *name, int otherwise)
{
    const char *text = getenv(name);
    return text ? atoi(text) : otherwise;
}

/* ---- at random ------------------------------------------------------------------------------- */

enum { DEEPEST = 12, MOST_ROWS = 40 };

typedef struct play {
    fmb_solver *v;
    support_rng g;
    char *text[DEEPEST]; /* the system as it was when each level was begun */
    int depth;
} play;

static char *print_system(const fmb_system *s)
{
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    rows_print(s, f);
    for (size_t i = 0; i < fmb_system_rows(s); i++)
        fprintf(f, "%s\n", fmb_system_label(s, i) ? fmb_system_label(s, i) : "-");
    fclose(f);
    return text;
}

static void push_level(play *p)
{
    if (p->depth == DEEPEST)
        return;
    p->text[p->depth++] = print_system(fmb_solver_system(p->v));
    must(fmb_solver_push(p->v));
}

static void pop_level(play *p)
{
    if (p->depth == 0) {
        cr_assert_eq(fmb_solver_pop(p->v), FMB_ERR_STATE);
        return;
    }
    must(fmb_solver_pop(p->v));
    char *now = print_system(fmb_solver_system(p->v));
    cr_assert_str_eq(now, p->text[--p->depth]);
    free(now);
    free(p->text[p->depth]);
}

static void draw_rational(support_rng *g, mpq_t q)
{
    int bits = support_chance(g, 5) ? 63 : 0;
    support_integer(g, bits, mpq_numref(q));
    mpz_set_ui(mpq_denref(q), 1);
    if (support_chance(g, 25))
        mpz_set_si(mpq_denref(q), support_between(g, 1, 7));
    mpq_canonicalize(q);
}

/* A few terms, or none; rows to the origin's liking are in the majority. */
static void add_random_row(play *p)
{
    int dim = fmb_system_dim(fmb_solver_system(p->v)), var[4], n = support_between(&p->g, 0, 15);
    mpq_t coef[4], b;
    if (fmb_system_rows(fmb_solver_system(p->v)) >= MOST_ROWS)
        return;
    n = n == 0 ? 0 : 1 + n % 4;
    mpq_init(b);
    draw_rational(&p->g, b);
    if (support_chance(&p->g, 70) || n == 0)
        mpq_abs(b, b);
    for (int k = 0; k < n; k++) {
        mpq_init(coef[k]);
        draw_rational(&p->g, coef[k]);
        var[k] = support_between(&p->g, 0, dim - 1);
    }
    fmb_rel rel = support_chance(&p->g, 70) ? FMB_LE : support_chance(&p->g, 70) ? FMB_LT : FMB_EQ;
    must(fmb_solver_add_q(p->v, (size_t)n, var, coef, rel, b));
    for (int k = 0; k < n; k++)
        mpq_clear(coef[k]);
    mpq_clear(b);
}

static void change_random_row(play *p)
{
    size_t rows = fmb_system_rows(fmb_solver_system(p->v));
    mpq_t b;
    if (rows == 0) {
        cr_assert_eq(fmb_solver_remove(p->v, 0), FMB_ERR_ARG);
        return;
    }
    size_t i = (size_t)support_between(&p->g, 0, (int)rows - 1);
    if (support_chance(&p->g, 50)) {
        must(fmb_solver_remove(p->v, i));
        return;
    }
    mpq_init(b);
    draw_rational(&p->g, b);
    must(fmb_solver_set_right_q(p->v, i, b));
    mpq_clear(b);
}

static void take_random_step(play *p)
{
    int what = support_between(&p->g, 0, 99);
    if (what < 20)
        push_level(p);
    else if (what < 40)
        pop_level(p);
    else if (what < 70)
        add_random_row(p);
    else
        change_random_row(p);
}

static void play_at_random(uint64_t seed, int dim, int steps)
{
    play p = {.v = open_solver(NULL), .g = {seed}};
    fmb_system *s = NULL;
    int feasible = 0, asked = 0;
    must(fmb_system_new(dim, NULL, &s));
    must(fmb_solver_load(p.v, s));
    fmb_system_free(s);
    for (int k = 0; k < steps; k++) {
        take_random_step(&p);
        if (!support_chance(&p.g, 60))
            continue;
        feasible += expect_as_fresh(p.v, support_chance(&p.g, 20) ? ALL_QUESTIONS : VERDICT) ==
                    FMB_FEASIBLE;
        asked++;
    }
    while (p.depth > 0)
        pop_level(&p);
    cr_assert(steps < 100 || (feasible > asked / 20 && feasible < asked - asked / 20),
              "%d of %d feasible", feasible, asked);
    fmb_solver_free(p.v);
}

Test(session, at_random)
{
    static const int DIM[] = {1, 2, 3, 5, 8, 12, 20};
    int n = (int)(sizeof DIM / sizeof *DIM), seed = read_setting("FMB_SESSION_SEED", 0);
    for (int k = 0; k < n; k++)
        play_at_random((uint64_t)(seed + k), DIM[k], read_setting("FMB_SESSION_STEPS", 500) / n);
}
