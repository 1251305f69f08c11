/* exhaustive.c: all systems of 2 variables and at most 4 rows over {-1, 0, 1}, <= and <.
 *
 *   exhaustive [--ways=N] [--every=K] [--processes=P]
 *
 * Each, or each K-th, is asked for its verdict and its box, under the default options and N - 1
 * other ways to solve, which take turns; each answer is compared with the ground truth, and its
 * evidence checked.
 */
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "options.h"
#include "question.h"

typedef struct plan {
    fmb_system *all[SUPPORT_TINY_COUNT];
    fmb_solver *v[512];
    uint64_t ways, every;
} plan;

static fmb_solver *solver(plan *p, int i)
{
    fmb_options o = options_at(i);
    if (!p->v[i])
        must(fmb_solver_new(&o, NULL, &p->v[i]));
    return p->v[i];
}

static bool job(void *self, uint64_t nth, agree *g, uint64_t *failures)
{
    plan *p = self;
    uint64_t i = nth * p->every;
    support_case c = {.s = p->all[i], .seed = i};
    truth t;
    truth_init(&t, c.s, g->max_rows);
    for (uint64_t k = 0; k < p->ways; k++) {
        int way = k == 0 ? 0 : (int)((i * p->ways + k) % (uint64_t)options_count());
        question q = {.options = options_at(way), .choice = i};
        for (int kind = ASK_SOLVE; kind < ASK_SHUFFLED; kind++) {
            q.kind = (question_kind)kind;
            if (!question_holds(&q, g, solver(p, way), &t)) {
                ++*failures;
                question_report(&q, g, &c);
            }
        }
    }
    truth_clear(&t);
    return *failures < 10;
}

int main(int argc, char **argv)
{
    static plan p;
    support_tiny at = {0};
    uint64_t processes = 2, n = 0;
    p.ways = 2;
    p.every = 1;
    for (int i = 1; i < argc; i++)
        if (!crew_number(argv[i], "--ways=", &p.ways) &&
            !crew_number(argv[i], "--every=", &p.every) &&
            !crew_number(argv[i], "--processes=", &processes)) {
            fprintf(stderr, "usage: exhaustive [--ways=N] [--every=K] [--processes=P]\n");
            return 64;
        }
    for (fmb_system *s; (s = support_tiny_next(&at)) != NULL; n++)
        if (n < SUPPORT_TINY_COUNT)
            p.all[n] = s;
    crew_sum sum;
    p.every += p.every == 0;
    uint64_t jobs = (n + p.every - 1) / p.every;
    bool good = n == SUPPORT_TINY_COUNT && crew_run(job, &p, 0, jobs, (int)processes, 1000, &sum);
    printf("%llu systems of %llu, %llu questions, %llu disagreements, %llu unjudged\n",
           (unsigned long long)(good ? sum.jobs : 0), (unsigned long long)n,
           (unsigned long long)sum.questions, (unsigned long long)sum.failures,
           (unsigned long long)sum.unjudged);
    for (uint64_t i = 0; i < SUPPORT_TINY_COUNT; i++)
        fmb_system_free(p.all[i]);
    for (int i = 0; i < 512; i++)
        fmb_solver_free(p.v[i]);
    return good && sum.failures == 0 && sum.unjudged == 0 ? 0 : 1;
}
