/* arguments.c: wrong arguments of the functions of systems, evidence and boxes, numbers out of
 * range: a status or 0, never a crash, and a word about it. NULL for each pointer: nulls.c. */
#include <criterion/criterion.h>
#include <math.h>
#include <string.h>

#include <fmb/symmetry.h>

#include "property/random/rows.h"
#include "verbs.h"

/* What the calls are about; nothing here may change. */
typedef struct world {
    fmb_system *s;
    fmb_solver *v;   /* which has answered */
    fmb_evidence *e; /* of a feasible system: one claim */
    fmb_box *box;    /* of its variables */
    mpq_t q;
} world;

static world open_world(void)
{
    world w = {0};
    fmb_result r = {.size = sizeof r};
    mpq_init(w.q);
    must(fmb_system_new(2, NULL, &w.s));
    must(fmb_system_add_int(w.s, (int64_t[]){1, 1}, FMB_LE, 4));
    must(fmb_solver_new(NULL, NULL, &w.v));
    must(fmb_bound(w.v, w.s, NULL, 0, &w.box, &r));
    must(fmb_solve(w.v, w.s, &r));
    must(fmb_solver_evidence(w.v, &w.e));
    return w;
}

static void close_world(world *w)
{
    mpq_clear(w->q);
    fmb_box_free(w->box);
    fmb_evidence_free(w->e);
    fmb_solver_free(w->v);
    fmb_system_free(w->s);
}

/* ---- accessors ------------------------------------------------------------------------------- */

/* Systems: of nothing, or of a row or variable that there is not. */
static void ask_system(fmb_system *s, size_t i, int j)
{
    mpq_t q;
    mpq_init(q);
    mpq_set_ui(q, 5, 1);
    cr_expect_eq(fmb_system_rel(s, i), FMB_LE);
    cr_expect_null(fmb_system_label(s, i));
    cr_expect_null(fmb_system_name(s, j));
    cr_expect_eq(fmb_system_find(s, NULL), -1);
    cr_expect_not(fmb_system_is_kept(s, j));
    fmb_system_set_kept(s, j, true);
    cr_expect_not(fmb_system_asks_projection(s));
    cr_expect_eq(fmb_system_terms(s, i), 0);
    cr_expect_eq(fmb_system_term_q(s, i, 0, q), -1);
    cr_expect_eq(mpq_sgn(q), 0);
    cr_expect_eq(fmb_system_term_q(s, i, 0, NULL), -1);
    mpq_set_ui(q, 5, 1);
    fmb_system_rhs_q(s, i, q);
    cr_expect_eq(mpq_sgn(q), 0);
    fmb_system_rhs_q(s, i, NULL);
    cr_expect_eq(fmb_system_set_label(s, i, "x"), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_set_name(s, j, "x"), FMB_ERR_ARG);
    mpq_clear(q);
}

static void ask_evidence(const fmb_evidence *e, size_t i, int j)
{
    mpq_t q;
    mpq_init(q);
    cr_expect_eq(fmb_evidence_kind(e, i), FMB_CLAIM_NONE);
    cr_expect_eq(fmb_evidence_row(e, i), SIZE_MAX);
    cr_expect_eq(fmb_evidence_var(e, i), -1);
    cr_expect_eq(fmb_evidence_side(e, i), FMB_LOWER);
    cr_expect_eq(fmb_evidence_rel(e, i), FMB_LE);
    cr_expect_eq(fmb_evidence_terms(e, i), 0);
    cr_expect_eq(fmb_evidence_term_q(e, i, 0, q), -1);
    cr_expect_eq(fmb_evidence_multiplier(e, i, SIZE_MAX), 0);
    cr_expect_eq(fmb_evidence_next_row(e, i, 0), SIZE_MAX);
    cr_expect_eq(fmb_evidence_coordinate(e, i, j), 0);
    fmb_evidence_multiplier_q(e, i, 0, q);
    fmb_evidence_coordinate_q(e, i, j, q);
    fmb_evidence_ray_q(e, i, j, q);
    fmb_evidence_value_q(e, i, q);
    cr_expect_eq(mpq_sgn(q), 0);
    fmb_evidence_multiplier_q(e, i, 0, NULL);
    fmb_evidence_value_q(e, i, NULL);
    mpq_clear(q);
}

static void ask_box(const fmb_box *b, int i, fmb_side side)
{
    mpq_t q;
    mpq_init(q);
    cr_expect_eq(fmb_box_end(b, i, side).kind, FMB_END_UNKNOWN);
    cr_expect_not(fmb_box_end_q(b, i, side, q));
    mpq_clear(q);
}

Test(arguments, accessors)
{
    world w = open_world();
    cr_expect_eq(fmb_system_dim(NULL), 0);
    cr_expect_eq(fmb_system_rows(NULL), 0);
    cr_expect_str_eq(fmb_system_trouble(NULL), "");
    ask_system(NULL, 0, 0);
    for (int j = -1; j <= 2; j += 3)
        ask_system(w.s, j < 0 ? SIZE_MAX : 1, j);
    cr_expect_eq(fmb_system_term_q(w.s, 0, 2, w.q), -1);
    cr_expect_eq(fmb_evidence_claims(NULL), 0);
    ask_evidence(NULL, 0, 0);
    ask_evidence(w.e, 1, 0);
    ask_evidence(w.e, SIZE_MAX, -1);
    cr_expect_eq(fmb_evidence_coordinate(w.e, 0, -1), 0);
    cr_expect_eq(fmb_box_size(NULL), 0);
    cr_expect_eq(fmb_box_var(NULL, 0), -1);
    cr_expect_eq(fmb_box_var(w.box, 2), -1);
    ask_box(NULL, 0, FMB_LOWER);
    ask_box(w.box, -1, FMB_LOWER);
    ask_box(w.box, 2, FMB_UPPER);
    ask_box(w.box, 0, (fmb_side)2);
    cr_expect_not(fmb_box_end_q(w.box, 0, FMB_LOWER, NULL));
    cr_expect_not_null(fmb_status_text((fmb_status)-1));
    cr_expect_not_null(fmb_verdict_text((fmb_verdict)77));
    cr_expect_not_null(fmb_stop_text((fmb_stop)77));
    cr_expect_str_eq(fmb_rel_text((fmb_rel)77), "?");
    cr_expect_str_eq(fmb_rel_text(FMB_GE), ">=");
    close_world(&w);
}

/* ---- what is wrong, in words ----------------------------------------------------------------- */

static void expect_trouble(const fmb_system *s, fmb_status st, const char *words)
{
    cr_expect_eq(st, FMB_ERR_ARG, "%s", words);
    cr_expect_not_null(strstr(fmb_system_trouble(s), words), "\"%s\" instead of \"%s\"",
                       fmb_system_trouble(s), words);
}

Test(arguments, trouble)
{
    world w = open_world();
    fmb_system *wide = NULL, *s = w.s;
    int zero = 0, far = 7;
    must(fmb_system_new(3, NULL, &wide));
    cr_expect_str_eq(fmb_system_trouble(s), "");
    expect_trouble(s, fmb_system_add(s, (double[]){1, NAN}, FMB_LE, 0), "coefficient of x2 is nan");
    expect_trouble(s, fmb_system_add(s, (double[]){1, 1}, FMB_LE, INFINITY), "right side is inf");
    expect_trouble(s, fmb_system_add_int(s, (int64_t[]){1, 1}, (fmb_rel)9, 1), "relation 9");
    expect_trouble(s, fmb_system_add_q(s, 1, &far, &w.q, FMB_LE, w.q), "term 0 is of variable 7");
    mpz_set_ui(mpq_denref(w.q), 0);
    expect_trouble(s, fmb_system_add_q(s, 1, &zero, &w.q, FMB_LE, w.q), "x1 has denominator 0");
    expect_trouble(s, fmb_system_add_q(s, 0, NULL, NULL, FMB_LE, w.q),
                   "right side has denominator");
    mpz_set_ui(mpq_denref(w.q), 1);
    expect_trouble(s, fmb_system_join(s, wide, NULL), "over 3 variables to join one over 2");
    expect_trouble(s, fmb_system_join(s, s, (int[]){0, 2}), "variable 1 is to be 2");
    expect_trouble(s, fmb_system_set_name(s, 2, "y"), "variable 2 of a system that has 2");
    expect_trouble(s, fmb_system_set_name(s, 0, "x2"), "\"x2\" is taken");
    expect_trouble(s, fmb_system_set_name(s, 0, ""), "empty");
    expect_trouble(s, fmb_system_add_variable(s, "x1", NULL), "\"x1\" is taken");
    expect_trouble(s, fmb_system_set_label(s, 3, "y"), "row 3 of a system that has 1");
    fmb_system_free(wide);
    close_world(&w);
}

/* The same of lists. */
Test(arguments, trouble_of_lists)
{
    fmb_generators *g = NULL;
    fmb_permutations *p = NULL;
    mpq_t broken[2];
    mpq_inits(broken[0], broken[1], NULL);
    mpz_set_ui(mpq_denref(broken[1]), 0);
    must(fmb_generators_new(2, NULL, &g));
    must(fmb_permutations_new(3, NULL, &p));
    cr_expect_str_eq(fmb_generators_trouble(g), "");
    cr_expect_eq(fmb_generators_add(g, FMB_RAY, (double[]){1, NAN}), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_generators_trouble(g), "x[1] is nan");
    cr_expect_eq(fmb_generators_add(g, (fmb_generator_kind)3, (double[]){1, 1}), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_generators_trouble(g), "kind is 3, which is none");
    cr_expect_eq(fmb_generators_add_q(g, FMB_RAY, broken), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_generators_trouble(g), "x[1] has denominator 0");
    cr_expect_eq(fmb_generators_add(g, FMB_RAY, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_generators_trouble(g), "x is NULL");
    must(fmb_generators_add(g, FMB_RAY, (double[]){1, 1}));
    cr_expect_str_eq(fmb_generators_trouble(g), "");
    cr_expect_str_eq(fmb_generators_trouble(NULL), "");
    cr_expect_eq(fmb_generators_size(g), 1u);
    cr_expect_eq(fmb_permutations_add(p, (int[]){1, 0, 1}), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_permutations_trouble(p), "variables 0 and 2 both go to 1");
    cr_expect_eq(fmb_permutations_add(p, (int[]){1, 3, 1}), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_permutations_trouble(p), "variable 1 goes to 3, but there are 3");
    cr_expect_eq(fmb_permutations_add(p, (int[]){1, -1, 0}), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_permutations_trouble(p), "variable 1 goes to -1, but there are 3");
    cr_expect_eq(fmb_permutations_add(p, NULL), FMB_ERR_ARG);
    cr_expect_str_eq(fmb_permutations_trouble(p), "image is NULL");
    must(fmb_permutations_add(p, (int[]){1, 0, 2}));
    cr_expect_str_eq(fmb_permutations_trouble(p), "");
    cr_expect_str_eq(fmb_permutations_trouble(NULL), "");
    cr_expect_eq(fmb_permutations_size(p), 1u);
    mpz_set_ui(mpq_denref(broken[1]), 1);
    mpq_clears(broken[0], broken[1], NULL);
    fmb_permutations_free(p);
    fmb_generators_free(g);
}

/* Rationals that are not in lowest terms mean what they say. */
Test(arguments, rationals)
{
    static const long given[][2] = {{6, 4}, {-6, -4}, {3, 2}, {-300, -200}};
    for (size_t i = 0; i < sizeof given / sizeof *given; i++) {
        world w = open_world();
        int var[] = {1, 1};
        mpq_t coef[2], got;
        mpq_inits(coef[0], coef[1], got, NULL);
        for (int k = 0; k < 2; k++) {
            mpz_set_si(mpq_numref(coef[k]), given[i][0]);
            mpz_set_si(mpq_denref(coef[k]), given[i][1]);
        }
        must(fmb_system_add_q(w.s, 2, var, coef, FMB_LE, coef[0]));
        cr_expect_eq(fmb_system_term_q(w.s, 1, 0, got), 1);
        cr_expect_eq(mpq_cmp_si(got, 3, 1), 0);
        fmb_system_rhs_q(w.s, 1, got);
        cr_expect_eq(mpq_cmp_si(got, 3, 2), 0);
        cr_expect_eq(mpz_cmp_si(mpq_denref(coef[0]), given[i][1]), 0, "only read");
        mpq_clears(coef[0], coef[1], got, NULL);
        close_world(&w);
    }
}

/* Nobody asks for gigabytes by a number. */
Test(arguments, huge)
{
    fmb_system *s = NULL;
    cr_expect_eq(fmb_system_new(INT32_MAX, NULL, &s), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_new(FMB_DIM_MAX + 1, NULL, &s), FMB_ERR_ARG);
    cr_expect_eq(fmb_system_new(-1, NULL, &s), FMB_ERR_ARG);
    cr_expect_null(s);
    must(fmb_system_new(FMB_DIM_MAX, NULL, &s));
    expect_trouble(s, fmb_system_add_variable(s, "one more", NULL), "more than 1000000 variables");
    fmb_system_free(s);
}

/* ---- numbers in a style of one's own ----------------------------------------------------------
 */

static void put_star(void *self, mpq_srcptr q, FILE *out)
{
    (void)q;
    (*(int *)self)++;
    fputs("*", out);
}

Test(arguments, style)
{
    world w = open_world();
    char *text = NULL;
    size_t size = 0;
    int numbers = 0;
    fmb_evidence *e = NULL;
    must(fmb_system_add_int(w.s, (int64_t[]){-3, 0}, FMB_LE, 1));
    fmb_box_free(w.box);
    must(fmb_bound(w.v, w.s, (int[]){0}, 1, &w.box, NULL));
    must(fmb_solver_evidence(w.v, &e));
    FILE *out = open_memstream(&text, &size);
    for (size_t i = 0; i < fmb_evidence_claims(e); i++)
        must(fmb_evidence_tell_with(e, w.s, i, &(fmb_number_style){put_star, &numbers}, out));
    cr_expect_eq(fmb_evidence_tell_with(e, w.s, 0, &(fmb_number_style){NULL, NULL}, out),
                 FMB_ERR_ARG);
    fclose(out);
    cr_expect(numbers > 0 && strstr(text, "min x1 = *") && !strstr(text, "1/3"), "%s", text);
    free(text);
    fmb_evidence_free(e);
    close_world(&w);
}
