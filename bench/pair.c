/* pair.c: verdicts on pairs of frames: is elimination as fast as separating axes?
 *
 * For each dimension, still or moving, each kind of pair, those that meet and those that do not:
 * fmb_pair_test with either method on 65,536 distinct pairs of the article's generator, passes of
 * the two in turn; the time is this thread's CPU time, and what is printed are medians over the
 * passes. See README.md.
 */
#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "study/clock/clock.h"
#include "study/draw/pairs.h"
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

static void must(fmb_status st)
{
    if (st != FMB_OK) {
        fprintf(stderr, "%s\n", fmb_status_text(st));
        exit(70);
    }
}

static fmb_status run(void *self, size_t first, size_t n)
{
    way *w = self;
    size_t step = w->one ? 1 : n;
    fmb_status st = FMB_OK;
    for (size_t i = first; st == FMB_OK && i < first + n; i += step)
        st = fmb_pair_test(w->k, step, w->pairs->p + i, w->pairs->q + i,
                           &(fmb_pair_answers){.verdict = w->verdict + i});
    return st;
}

typedef struct wanted {
    fmb_pair *k;
    fmb_verdict verdict;
} wanted;

static bool keep(void *self, const fmb_frame *p, const fmb_frame *q)
{
    wanted *w = self;
    fmb_verdict is;
    must(fmb_pair_test(w->k, 1, p, q, &(fmb_pair_answers){.verdict = &is}));
    return is == w->verdict;
}

static void measure(const setting *how, const study_pair_plan *plan, fmb_verdict verdict)
{
    static const char *const kind[3] = {"CC", "CT", "TT"};
    static fmb_verdict out[2][PAIRS];
    study_pairs pairs;
    way w[2];
    study_timed timed[2];
    for (int i = 0; i < 2; i++) {
        fmb_pair_options o = fmb_pair_options_default();
        o.simd = how->simd;
        w[i] = (way){.pairs = &pairs, .verdict = out[i], .one = how->one};
        must(i == 0 ? fmb_pair_new(plan->dim, &o, NULL, &w[i].k)
                    : study_sat_new(plan->dim, &o, &w[i].k));
        timed[i] = (study_timed){run, &w[i]};
    }
    wanted only = {w[0].k, verdict};
    must(study_pairs_make(plan, 1, PAIRS, keep, &only, &pairs));
    study_clock c = {.way = timed, .ways = 2, .queries = PAIRS, .groups = 1, .passes = PASSES};
    must(study_clock_run(&c));
    printf("%dD %-6s %s %-5s  %7.1f  %7.1f  %6.3f\n", plan->dim, plan->moves ? "moving" : "still",
           kind[plan->shape[0] + plan->shape[1]], verdict == FMB_FEASIBLE ? "meet" : "apart",
           study_clock_ns(&c, 0).median, study_clock_ns(&c, 1).median,
           study_clock_ratio(&c, 0, 1).ratio);
    if (memcmp(out[0], out[1], sizeof out[0]) != 0)
        printf("the two differ\n");
    study_clock_clear(&c);
    study_pairs_free(&pairs);
    fmb_pair_free(w[0].k);
    fmb_pair_free(w[1].k);
}

static bool parse(int argc, char **argv, setting *out)
{
    static const char *const name[] = {"plain", "avx2", "avx512"};
    static const fmb_simd level[] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    *out = (setting){FMB_SIMD_AUTO, false};
    for (int i = 1; i < argc; i++) {
        bool known = strcmp(argv[i], "--one") == 0;
        out->one |= known;
        for (int l = 0; l < 3 && strncmp(argv[i], "--simd=", 7) == 0; l++)
            if (strcmp(argv[i] + 7, name[l]) == 0) {
                out->simd = level[l];
                known = true;
            }
        if (!known)
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
    printf("}\n%-20s  %7s  %7s  %6s\n", "ns", "fmb", "sat", "ratio");
    for (int i = 0; i < 24; i++) {
        int kind = i / 2 % 3;
        study_pair_plan plan = {.family = STUDY_PAIR_ARTICLE,
                                .dim = 2 + i / 6 % 2,
                                .moves = i / 12,
                                .shape = {kind == 2, kind > 0}};
        measure(&how, &plan, i % 2 ? FMB_INFEASIBLE : FMB_FEASIBLE);
    }
    return 0;
}
