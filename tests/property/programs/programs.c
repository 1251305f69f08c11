/* programs.c: small linear programs of every family (bench/study/program): verdicts, boxes, optima
 * and irredundant rows against the ground truth where that can reach, and against what was planted;
 * the same system in other scales has the same answers. Every proof is checked.
 *
 *   programs [--count=N] [--first=I] [--processes=P]
 *
 * Program i is made from seed i alone. Exit 1 on any disagreement, which is printed with its seed,
 * family and system.
 */

#include "crew.h"
#include "study/program/program.h"
#include "study/program/random.h"

enum { GIVE_UP = 10 };

/* The default, and exact simplex alone. */
static fmb_solver *solver_of(fmb_method method)
{
    static fmb_solver *v[FMB_METHOD_LP + 1];
    fmb_options o = {.size = sizeof o};
    o.method = method;
    o.evidence = FMB_EVIDENCE_ALL;
    if (!v[method])
        must(fmb_solver_new(&o, NULL, &v[method]));
    return v[method];
}

/* Every other time round within reach of the ground truth. */
static study_program_plan plan_of(uint64_t i, bool *tiny)
{
    uint64_t families = (uint64_t)study_program_families();
    study_program_plan plan = {.family = (int)(i % families), .seed = i};
    study_random g = {i};
    *tiny = i / families % 2 == 0;
    plan.variables =
        (int)(*tiny ? study_random_between(&g, 1, 4) : study_random_between(&g, 5, 14));
    plan.rows = (int)(*tiny ? study_random_between(&g, 1, 7) : study_random_between(&g, 4, 36));
    return plan;
}

/* ---- the same in other scales ---------------------------------------------------------------- */

/* q /= 10^power */
static void unscale(mpq_t q, int power)
{
    mpz_t ten;
    mpz_init(ten);
    mpz_ui_pow_ui(ten, 10, (unsigned long)abs(power));
    mpz_ptr to = power < 0 ? mpq_numref(q) : mpq_denref(q);
    mpz_mul(to, to, ten);
    mpq_canonicalize(q);
    mpz_clear(ten);
}

/* The truth about u, x_j = 10^power[j] y_j, from the box of the system in x. */
static void translate_truth(truth *to, const fmb_system *u, const fmb_box *box, const int *power)
{
    int dim = fmb_system_dim(u);
    *to = (truth){.s = u, .verdict = box ? FMB_FEASIBLE : FMB_INFEASIBLE};
    if (!box)
        return;
    to->end = calloc((size_t)dim + 1, sizeof *to->end);
    for (int j = 0; to->end && j < dim; j++)
        for (int side = 0; side < 2; side++) {
            study_textbook_end *e = &to->end[j][side];
            fmb_end end = fmb_box_end(box, j, (fmb_side)side);
            mpq_init(e->value);
            e->kind = end.kind;
            e->attained = end.attained;
            if (fmb_box_end_q(box, j, (fmb_side)side, e->value))
                unscale(e->value, power[j]);
        }
}

static bool agrees_in_other_scales(agree *g, fmb_solver *v, const fmb_system *s, uint64_t seed)
{
    int *power = calloc((size_t)fmb_system_dim(s) + 1, sizeof *power);
    fmb_system *u = NULL;
    fmb_box *box = NULL;
    fmb_result r = {.size = sizeof r};
    truth t;
    must(study_system_rescale(s, 9, seed, power, &u));
    must(fmb_bound(v, s, NULL, 0, &box, &r));
    translate_truth(&t, u, box, power);
    bool good = agree_solve(g, v, &t) && agree_bound(g, v, &t);
    truth_clear(&t);
    fmb_box_free(box);
    fmb_system_free(u);
    free(power);
    return good;
}

/* ---- the objective --------------------------------------------------------------------------- */

/* How far the objective goes; *finite false: for ever, or there is no solution. */
static bool proved_optimum(agree *g, fmb_solver *v, const fmb_system *s, mpq_t value, bool *finite)
{
    fmb_optimum *optimum = NULL;
    fmb_evidence *e = NULL;
    fmb_judgement j = {.size = sizeof j};
    fmb_result r = {.size = sizeof r};
    bool meets = false;
    must(fmb_optimize(v, s, NULL, &optimum, &r));
    must(fmb_solver_evidence(v, &e));
    must(fmb_check(s, e, &j));
    must(fmb_evidence_meets(e, s, FMB_DEMAND_OPTIMUM, NULL, &meets, g->why, sizeof g->why));
    g->questions++;
    *finite = fmb_optimum_value_q(optimum, value);
    bool good = meets && j.accepted && r.stop == FMB_STOP_DONE;
    if (good && *finite && fmb_optimum_end(optimum).kind != FMB_END_FINITE)
        good = false;
    if (meets && !good)
        snprintf(g->why, sizeof g->why, "optimum: %.150s", j.reason);
    fmb_optimum_free(optimum);
    fmb_evidence_free(e);
    return good;
}

/* As it is known, and the same in other scales. */
static bool agrees_on_optimum(agree *g, fmb_solver *v, const study_program *p, uint64_t seed)
{
    fmb_system *u = NULL;
    mpq_t value[2];
    bool finite[2] = {false}, good;
    mpq_inits(value[0], value[1], NULL);
    must(study_system_rescale(p->s, 9, seed, NULL, &u));
    good = proved_optimum(g, v, p->s, value[0], &finite[0]) &&
           proved_optimum(g, v, u, value[1], &finite[1]);
    bool same = finite[0] == finite[1] && (!finite[0] || mpq_equal(value[0], value[1])) &&
                (!p->has_best || (finite[0] && mpq_equal(value[0], p->best)));
    if (good && !same)
        snprintf(g->why, sizeof g->why, "optimum: another one in other scales, or than is known");
    mpq_clears(value[0], value[1], NULL);
    fmb_system_free(u);
    return good && same;
}

/* ---- jobs ------------------------------------------------------------------------------------ */

static bool agrees(agree *g, const study_program *p, const truth *t, uint64_t i)
{
    fmb_solver *v = solver_of(FMB_METHOD_AUTO);
    fmb_verdict planted = p->verdict;
    if (planted != FMB_UNKNOWN && t->verdict != FMB_UNKNOWN && t->verdict != planted) {
        snprintf(g->why, sizeof g->why, "the ground truth differs from what was planted");
        return false;
    }
    return agree_solve(g, v, t) && agree_bound(g, v, t) && agree_reduce(g, v, t, NULL) &&
           agree_bound(g, solver_of(FMB_METHOD_LP), t) && agrees_in_other_scales(g, v, p->s, i) &&
           agrees_on_optimum(g, v, p, i);
}

static bool job(void *self, uint64_t i, agree *g, uint64_t *failures)
{
    (void)self;
    bool tiny;
    study_program_plan plan = plan_of(i, &tiny);
    study_program p;
    truth t;
    must(study_program_draw(&plan, &p));
    if (tiny)
        truth_init(&t, p.s, g->max_rows);
    else
        t = (truth){.s = p.s, .verdict = p.verdict};
    uint64_t undecided = g->undecided;
    bool good = agrees(g, &p, &t, i);
    if (good && g->undecided != undecided) {
        snprintf(g->why, sizeof g->why, "undecided, without any limit");
        good = false;
    }
    if (!good) {
        ++*failures;
        fprintf(stderr, "seed %llu, %s, %d rows, %d variables: %s\n", (unsigned long long)i,
                study_program_name(plan.family), plan.rows, plan.variables, g->why);
        rows_print(p.s, stderr);
    }
    truth_clear(&t);
    study_program_clear(&p);
    return *failures < GIVE_UP;
}

int main(int argc, char **argv)
{
    uint64_t count = 300, first = 0, processes = 2;
    for (int i = 1; i < argc; i++)
        if (!crew_number(argv[i], "--count=", &count) &&
            !crew_number(argv[i], "--first=", &first) &&
            !crew_number(argv[i], "--processes=", &processes)) {
            fprintf(stderr, "usage: programs [--count=N] [--first=I] [--processes=P]\n");
            return 64;
        }
    crew_sum sum;
    bool good = crew_run(job, NULL, first, count, (int)processes, 600, &sum);
    printf("%llu programs, %llu questions, %llu disagreements; parts too large for the ground "
           "truth: %llu%s\n",
           (unsigned long long)sum.jobs, (unsigned long long)sum.questions,
           (unsigned long long)sum.failures, (unsigned long long)sum.unjudged,
           good ? "" : "; a process died");
    return good && sum.failures == 0 ? 0 : 1;
}
