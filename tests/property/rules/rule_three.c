/* rule_three.c: every set of the six rules on every system of 3 variables and 4 rows over {-1, 0,
 * 1} (three.h), against the ground truth.
 *
 *   rule-three [--every=K] [--processes=P] [--expect=wrong]
 *
 * Of each K-th system the verdict is asked under all 64 sets of rules, by elimination alone, with
 * its evidence checked; order, arithmetic, presolve and re-basing are drawn from the system's
 * number and the set. --expect=wrong: exit 0 only if an answer is wrong.
 */
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "mixes.h"
#include "question.h"
#include "three.h"
#include "way.h"

typedef struct task {
    three *all;
    bool expects_wrong;
} task;

static bool ask(question *q, agree *g, const truth *t, bool quiet)
{
    fmb_solver *v = NULL;
    support_case c = {.s = (fmb_system *)t->s};
    must(fmb_solver_new(&q->options, NULL, &v));
    bool good = question_holds(q, g, v, t);
    fmb_solver_free(v);
    if (!good && !quiet)
        question_report(q, g, &c);
    return good;
}

static bool one_system(void *self, uint64_t i, agree *g, uint64_t *failures)
{
    const task *job = self;
    support_rng rng = {i};
    fmb_system *s = three_system(job->all[i]);
    truth t = {.s = s};
    must(study_textbook_solve(s, 0, &t.verdict));
    for (unsigned mix = 0; mix < MIX_SUBSETS; mix++) {
        question q = {.kind = ASK_SOLVE, .options = way_at(&rng, mix)};
        *failures += !ask(&q, g, &t, job->expects_wrong);
    }
    fmb_system_free(s);
    return job->expects_wrong || *failures < 10;
}

/* Job i is system i * every. */
typedef struct thinned {
    task task;
    uint64_t every;
} thinned;

static bool thin(void *self, uint64_t i, agree *g, uint64_t *failures)
{
    thinned *t = self;
    return one_system(&t->task, i * t->every, g, failures);
}

int main(int argc, char **argv)
{
    thinned t = {.every = 1};
    int processes = 2;
    for (int i = 1; i < argc; i++)
        if (strncmp(argv[i], "--every=", 8) == 0)
            t.every = strtoull(argv[i] + 8, NULL, 10);
        else if (strncmp(argv[i], "--processes=", 12) == 0)
            processes = atoi(argv[i] + 12);
        else if (strcmp(argv[i], "--expect=wrong") == 0)
            t.task.expects_wrong = true;
    if (t.every == 0)
        t.every = 1;
    size_t count;
    t.task.all = three_all(&count);
    crew_sum sum;
    bool good = crew_run(thin, &t, 0, (count + t.every - 1) / t.every, processes, 0, &sum);
    printf("%llu of %zu systems, %d sets of rules, %llu questions, %llu wrong, undecided: %llu%s\n",
           (unsigned long long)sum.jobs, count, MIX_SUBSETS, (unsigned long long)sum.questions,
           (unsigned long long)sum.failures, (unsigned long long)sum.undecided,
           good ? "" : "; a process died");
    free(t.task.all);
    return good && sum.undecided == 0 && (sum.failures > 0) == t.task.expects_wrong ? 0 : 1;
}
