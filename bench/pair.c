/* pair.c: verdicts on pairs of frames: is elimination as fast as separating axes?
 *
 * For each dimension, still or moving, each kind of pair, meeting or disjoint: fmb_pair_test with
 * either method on 65,536 distinct pairs of the article's generator, passes of the two in turn; the
 * time is this thread's CPU time, and what is printed are medians over the passes. In the plane, of
 * frames that stand still, also by separating axes as written by hand (plain_sat.h). See README.md.
 */
#include <string.h>

#include "cells.h"
#include "machine.h"
#include "plain_sat.h"
#include "study/clock/clock.h"
#include "study/sat/sat.h"

enum { PAIRS = 65536, PASSES = 9 };

typedef struct setting {
    fmb_simd simd;
    bool one; /* a call for each pair */
} setting;

typedef struct way {
    fmb_pair *k;
    const study_pairs *pairs;
    fmb_verdict *verdict;
    bool one;
} way;

static fmb_status run(void *self, size_t first, size_t n)
{
    way *w = self;
    size_t step = w->one ? 1 : n;
    fmb_status st = FMB_OK;
    for (size_t i = first; st == FMB_OK && i < first + n; i += step)
        st = fmb_pair_test(
            w->k, step, w->pairs->p + i, w->pairs->q + i,
            &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = w->verdict + i});
    return st;
}

static fmb_status run_plain_sat(void *self, size_t first, size_t n)
{
    way *w = self;
    for (size_t i = first; i < first + n; i++)
        w->verdict[i] =
            plain_sat_meet(&w->pairs->p[i], &w->pairs->q[i]) ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return FMB_OK;
}

static void print_ratios(const study_clock *c)
{
    printf("  %7.1f  %7.1f  %6.3f", study_clock_ns(c, 0).median, study_clock_ns(c, 1).median,
           study_clock_ratio(c, 0, 1).ratio);
    if (c->ways > 2)
        printf("  %7.1f  %6.3f  %6.3f", study_clock_ns(c, 2).median,
               study_clock_ratio(c, 0, 2).ratio, study_clock_ratio(c, 1, 2).ratio);
    printf("\n");
}

static void measure(const setting *how, const study_pair_plan *plan, fmb_verdict verdict)
{
    static fmb_verdict out[3][PAIRS];
    study_pairs pairs;
    way w[3];
    study_timed timed[3];
    for (int i = 0; i < 2; i++) {
        fmb_pair_options o = {.size = sizeof o};
        o.simd = how->simd;
        w[i] = (way){.pairs = &pairs, .verdict = out[i], .one = how->one};
        must(i == 0 ? fmb_pair_new(plan->dim, &o, NULL, &w[i].k)
                    : study_sat_new(plan->dim, &o, &w[i].k));
        timed[i] = (study_timed){run, &w[i]};
    }
    pairs = cell_pairs(plan, PAIRS, w[0].k, verdict);
    w[2] = (way){.pairs = &pairs, .verdict = out[2]};
    timed[2] = (study_timed){run_plain_sat, &w[2]};
    study_clock c = {.way = timed,
                     .ways = plan->dim == 2 && !plan->moves ? 3 : 2,
                     .queries = PAIRS,
                     .groups = 1,
                     .passes = PASSES};
    must(study_clock_run(&c));
    printf("%s %-5s", cell_text(plan), verdict == FMB_FEASIBLE ? "meet" : "apart");
    print_ratios(&c);
    if (memcmp(out[0], out[1], sizeof out[0]) != 0)
        printf("the two differ\n");
    study_clock_clear(&c);
    study_pairs_free(&pairs);
    fmb_pair_free(w[0].k);
    fmb_pair_free(w[1].k);
}

static bool parse(int argc, char **argv, setting *out)
{
    *out = (setting){FMB_SIMD_AUTO, false};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--one") == 0)
            out->one = true;
        else if (!parse_simd(argv[i], &out->simd))
            return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    setting how;
    if (!parse(argc, argv, &how)) {
        fprintf(stderr, "usage: bench-pair [--one] [--simd=plain|avx2|avx512]\n");
        return 64;
    }
    printf("{");
    print_machine_json(stdout);
    printf("}\n%-20s  %7s  %7s  %6s  %7s  %6s  %6s\n", "ns", "fmb", "sat", "ratio", "plain",
           "fmb/pl", "sat/pl");
    for (int i = 0; i < 2 * CELLS; i++) {
        study_pair_plan plan = cell_plan(i / 2);
        measure(&how, &plan, i % 2 ? FMB_INFEASIBLE : FMB_FEASIBLE);
    }
    return 0;
}
