/* rule_mixes.c: every rule, pair and triple of rules on random systems, against the ground truth.
 *
 *   rule-mixes [--count=N] [--first=I] [--processes=P] [--each=K]
 *              [--mixes=all|rebased|others] [--expect=wrong]
 *
 * System i is made from seed i alone (make.h). Its verdict comes from the ground truth, or, where
 * that grows too large, from a proof of the exact simplex that the checker has accepted.
 * Elimination is then asked for the verdict under K of the mixes (all 41 unless K is given), which
 * take turns, so that N systems ask each mix K N / 41 times; options are random (way.h), and so is,
 * in one case of four, the order of elimination. Every SHADOWS-th system is also asked for a
 * projection on random variables and the box of one variable, under one mix, half of the time with
 * the rule "lp" beside it. Every answer is compared with the truth and its evidence checked.
 *
 * --mixes=rebased asks only of mixes that are right because the engine re-bases, others only of the
 * rest. --expect=wrong is for engines with a fault built in: verdicts only, and exit 0 only if one
 * is wrong.
 */
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "make.h"
#include "mixes.h"
#include "question.h"
#include "way.h"

enum { SHADOWS = 7, GIVE_UP = 10, EXACT_ROWS = 150 };

typedef struct task {
    unsigned mix[MIX_SMALL];
    uint64_t mixes, each; /* in all; asked of each system */
    bool expects_wrong;
} task;

/* What the oracle says, if it proves it. */
static fmb_verdict proved_verdict(const fmb_system *s, agree *g)
{
    fmb_options o = {.size = sizeof o};
    fmb_solver *v = NULL;
    fmb_result r = {.size = sizeof r};
    truth unknown = {.s = s};
    uint64_t unjudged = g->unjudged;
    o.method = FMB_METHOD_LP;
    o.evidence = FMB_EVIDENCE_ALL;
    must(fmb_solver_new(&o, NULL, &v));
    bool good = agree_solve(g, v, &unknown);
    must(fmb_solve(v, s, &r));
    fmb_solver_free(v);
    g->unjudged = unjudged;
    g->by_proof++;
    return good ? r.verdict : FMB_UNKNOWN;
}

static void report(question *q, const agree *g, const fmb_system *s, uint64_t seed)
{
    char text[320], comment[80];
    question_text(q, text, sizeof text);
    fprintf(stderr, "\nseed %llu: %s\n  %s\n", (unsigned long long)seed, text, g->why);
    if (!question_fails(q, s)) {
        fprintf(stderr, "  not when asked again\n");
        return;
    }
    fmb_system *small = support_shrink(s, question_fails, q);
    snprintf(comment, sizeof comment, "rule mixes, seed %llu, shrunken", (unsigned long long)seed);
    support_print(small, comment, stderr);
    fmb_system_free(small);
}

static void ask(const task *job, question q, agree *g, const truth *t, uint64_t seed,
                uint64_t *failures)
{
    fmb_solver *v = question_solver(&q);
    bool good = question_holds(&q, g, v, t);
    fmb_solver_free(v);
    if (good)
        return;
    ++*failures;
    if (!job->expects_wrong)
        report(&q, g, t->s, seed);
}

static bool one_system(void *self, uint64_t i, agree *g, uint64_t *failures)
{
    const task *job = self;
    support_rng rng = {~i};
    fmb_system *s = make_system(i);
    truth t = {.s = s};
    must(study_textbook_solve(s, EXACT_ROWS, &t.verdict));
    if (t.verdict == FMB_UNKNOWN)
        t.verdict = proved_verdict(s, g);
    if (t.verdict == FMB_UNKNOWN) {
        fprintf(stderr, "seed %llu: the oracle: %s\n", (unsigned long long)i, g->why);
        ++*failures;
    }
    question q = {.kind = ASK_SOLVE};
    for (uint64_t k = 0; k < job->each; k++) {
        q.options = way_at(&rng, job->mix[(i * job->each + k) % job->mixes]);
        q.order = support_chance(&rng, 25) ? support_next(&rng) : 0;
        ask(job, q, g, &t, i, failures);
    }
    if (i % SHADOWS == 0 && !job->expects_wrong) {
        unsigned lp = support_chance(&rng, 50) ? MIX_LP : 0;
        q.options = way_at(&rng, job->mix[i / SHADOWS % job->mixes] | lp);
        q.choice = support_next(&rng);
        q.kind = ASK_PROJECT;
        ask(job, q, g, &t, i, failures);
        q.kind = ASK_END;
        ask(job, q, g, &t, i, failures);
    }
    fmb_system_free(s);
    return job->expects_wrong || *failures < GIVE_UP;
}

static void choose_mixes(task *job, const char *word)
{
    for (int i = 0; i < MIX_SMALL; i++)
        if (strcmp(word, "all") == 0 ||
            mix_needs_rebase(mix_at(i)) == (strcmp(word, "rebased") == 0))
            job->mix[job->mixes++] = mix_at(i);
}

static bool text(const char *arg, const char *name, const char **out)
{
    size_t n = strlen(name);
    if (strncmp(arg, name, n) != 0)
        return false;
    *out = arg + n;
    return true;
}

int main(int argc, char **argv)
{
    task job = {0};
    const char *count = "20000", *first = "0", *processes = "2", *mixes = "all", *expect = "right",
               *each = "41";
    for (int i = 1; i < argc; i++)
        if (!text(argv[i], "--count=", &count) && !text(argv[i], "--first=", &first) &&
            !text(argv[i], "--processes=", &processes) && !text(argv[i], "--mixes=", &mixes) &&
            !text(argv[i], "--expect=", &expect) && !text(argv[i], "--each=", &each)) {
            fprintf(stderr, "usage: rule-mixes [--count=N] [--first=I] [--processes=P] "
                            "[--each=K] [--mixes=all|rebased|others] [--expect=wrong]\n");
            return 64;
        }
    choose_mixes(&job, mixes);
    job.each = strtoull(each, NULL, 10);
    job.each = job.each < job.mixes ? job.each : job.mixes;
    job.expects_wrong = strcmp(expect, "wrong") == 0;
    crew_sum sum;
    bool good = crew_run(one_system, &job, strtoull(first, NULL, 10), strtoull(count, NULL, 10),
                         atoi(processes), EXACT_ROWS, &sum);
    printf("%llu systems, %llu of %llu mixes each, %llu questions, %llu wrong; verdicts by checked "
           "proof for "
           "lack of the ground truth: %llu, parts of projections and boxes it could not judge: "
           "%llu, undecided: %llu%s\n",
           (unsigned long long)sum.jobs, (unsigned long long)job.each,
           (unsigned long long)job.mixes, (unsigned long long)sum.questions,
           (unsigned long long)sum.failures, (unsigned long long)sum.by_proof,
           (unsigned long long)sum.unjudged, (unsigned long long)sum.undecided,
           good ? "" : "; a process died");
    return good && (sum.failures > 0) == job.expects_wrong ? 0 : 1;
}
