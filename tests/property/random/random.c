/* random.c: random systems of every family, every way to solve, against the ground truth.
 *
 *   random [--count=N] [--first=I] [--processes=P]
 *
 * System i is made from seed i alone. It is asked everything with the default options, everything
 * under a few other combinations of method, arithmetic, order and rules (which take turns), and the
 * properties that must not change an answer. All under limits of rows and bytes: only the default
 * options must decide everything. Exit 1 on any disagreement, which is printed with its
 * seed and a shrunken system.
 */
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "options.h"
#include "question.h"

enum { OTHERS = 4, MOST_SOLVERS = 512, GIVE_UP = 10 };

typedef struct team {
    fmb_solver *v[MOST_SOLVERS]; /* one for each combination of options, made when first needed */
} team;

/* Without rules elimination can grow beyond any memory: such ways to solve may give up. */
static fmb_options limited(int i)
{
    fmb_options o = options_at(i);
    o.max_rows = 2000;
    o.max_bytes = (size_t)64 << 20;
    return o;
}

static fmb_solver *solver(team *t, int i)
{
    fmb_options o = limited(i);
    if (!t->v[i])
        must(fmb_solver_new(&o, NULL, &t->v[i]));
    return t->v[i];
}

/* Mostly small; one in eight of 5 or 6 variables. */
static support_shape shape_of(uint64_t i)
{
    static const int bits[] = {0, 0, 0, 31, 53, 63, 200};
    support_rng g = {i * 7919 + 1};
    support_shape s = {.bits = bits[support_next(&g) % 7]};
    s.dim = support_chance(&g, 88) ? support_between(&g, 1, 4) : support_between(&g, 5, 6);
    s.rows = support_between(&g, 1, s.dim > 4 ? 9 : s.dim == 4 ? 9 : 8);
    return s;
}

static bool ask(const question *q, agree *g, fmb_solver *v, const truth *t, const support_case *c,
                uint64_t *failures)
{
    if (question_holds(q, g, v, t))
        return true;
    ++*failures;
    question_report(q, g, c);
    return false;
}

static bool job(void *self, uint64_t i, agree *g, uint64_t *failures)
{
    team *crew = self;
    support_shape shape = shape_of(i);
    support_case c = support_make((support_family)(i % SUPPORT_FAMILIES), i, &shape);
    truth t;
    truth_init(&t, c.s, g->max_rows);
    if (c.verdict != FMB_UNKNOWN && t.verdict != FMB_UNKNOWN && c.verdict != t.verdict) {
        fprintf(stderr, "seed %llu: the ground truth differs from what was planted\n",
                (unsigned long long)i);
        ++*failures;
    }
    question q = {.choice = i * 0x9e3779b97f4a7c15u >> 7};
    for (int k = 0; k <= OTHERS; k++) {
        int way = k == 0 ? 0 : (int)((i * OTHERS + (uint64_t)k) % (uint64_t)options_count());
        q.options = limited(way);
        uint64_t undecided = g->undecided;
        for (int kind = ASK_SOLVE; kind < ASK_SHUFFLED; kind++) {
            q.kind = (question_kind)kind;
            ask(&q, g, solver(crew, way), &t, &c, failures);
        }
        if (k == 0 && g->undecided != undecided) {
            fprintf(stderr, "seed %llu: undecided with the default options\n",
                    (unsigned long long)i);
            ++*failures;
        }
    }
    q.kind = (question_kind)(ASK_SHUFFLED + i / SUPPORT_FAMILIES % (ASK_KINDS - ASK_SHUFFLED));
    int way = (int)(i % (uint64_t)options_count());
    q.options = limited(way);
    ask(&q, g, solver(crew, way), &t, &c, failures);
    truth_clear(&t);
    support_case_clear(&c);
    return *failures < GIVE_UP;
}

int main(int argc, char **argv)
{
    static team crew;
    uint64_t count = 2000, first = 0, processes = 2;
    for (int i = 1; i < argc; i++)
        if (!crew_number(argv[i], "--count=", &count) &&
            !crew_number(argv[i], "--first=", &first) &&
            !crew_number(argv[i], "--processes=", &processes)) {
            fprintf(stderr, "usage: random [--count=N] [--first=I] [--processes=P]\n");
            return 64;
        }
    crew_sum sum;
    bool good = crew_run(job, &crew, first, count, (int)processes, 600, &sum);
    printf("%llu systems, %llu questions, %llu disagreements; parts too large for the ground "
           "truth: %llu, undecided: %llu%s\n",
           (unsigned long long)sum.jobs, (unsigned long long)sum.questions,
           (unsigned long long)sum.failures, (unsigned long long)sum.unjudged,
           (unsigned long long)sum.undecided, good ? "" : "; a process died");
    return good && sum.failures == 0 ? 0 : 1;
}
