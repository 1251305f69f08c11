/* boxes.c: many pairs that meet, of all families in two to five dimensions, still and moving:
 * boxes, times and witnesses of fmb_pair_test against exact ones.
 *
 * boxes PAIRS [SEED]: about that many pairs in all. Prints a line for each family and dimension:
 * pairs, how many needed an exact query, the largest excess over what is allowed. Ends with 1 at
 * the first fault.
 */
#include <stdio.h>
#include <stdlib.h>

#include "box_check.h"
#include "rows.h"
#include "study/draw/pairs.h"
#include "support/pair_counts.h"

enum { LEAST_DIM = 2, MOST_DIM = 5, KINDS = 2, MOST_DRAWS = 50 };

typedef struct bench {
    fmb_pair *pairs;
    box_check check;
    uint64_t seed;
} bench;

/* The first n pairs that meet; false on a fault. */
static bool run(bench *b, const study_pair_plan *plan, uint64_t n, uint64_t *done)
{
    static study_pair s;
    for (uint64_t i = 0, met = 0; met < n && i < MOST_DRAWS * n; i++) {
        box_answer a;
        fmb_verdict v;
        study_pair_draw(plan, b->seed, i, &s);
        const fmb_pair_answers out = box_answer_places(&a, &v);
        must(fmb_pair_test(b->pairs, 1, &s.p, &s.q, &out));
        if (v != FMB_FEASIBLE)
            continue;
        met++;
        ++*done;
        if (!box_check_pair(&b->check, &s.p, &s.q, &a, 1, false)) {
            printf("%s, %d dimensions, %s, pair %llu: %s\n", study_pair_family_text(plan->family),
                   plan->dim, plan->moves ? "moving" : "still", (unsigned long long)i,
                   b->check.why);
            return false;
        }
    }
    return true;
}

/* One family in one dimension, still and moving. */
static bool run_family(study_pair_family family, int dim, uint64_t n, uint64_t seed,
                       uint64_t *total)
{
    bench b = {.seed = seed};
    uint64_t done = 0;
    bool good = true;
    must(fmb_pair_new(dim, NULL, NULL, &b.pairs));
    box_check_open(&b.check);
    for (int moves = 0; good && moves < KINDS; moves++) {
        const study_pair_plan plan = {.family = family,
                                      .dim = dim,
                                      .moves = moves,
                                      .shape = {STUDY_PAIR_ANY_SHAPE, STUDY_PAIR_ANY_SHAPE}};
        good = run(&b, &plan, n, &done);
    }
    fmb_pair_counts c = counts_of_pairs(b.pairs);
    printf("%-10s %dD: %6llu pairs, %6llu exactly, excess %.3f\n", study_pair_family_text(family),
           dim, (unsigned long long)done, (unsigned long long)c.exact_boxes, b.check.excess);
    fflush(stdout);
    *total += done;
    box_check_close(&b.check);
    fmb_pair_free(b.pairs);
    return good;
}

int main(int argc, char **argv)
{
    uint64_t pairs = argc > 1 ? strtoull(argv[1], NULL, 10) : 0, total = 0;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    uint64_t cells = STUDY_PAIR_FAMILIES * (MOST_DIM - LEAST_DIM + 1) * KINDS;
    if (pairs == 0) {
        fprintf(stderr, "boxes PAIRS [SEED]\n");
        return 64;
    }
    for (int f = 0; f < STUDY_PAIR_FAMILIES; f++)
        for (int dim = LEAST_DIM; dim <= MOST_DIM; dim++)
            if (!run_family((study_pair_family)f, dim, (pairs + cells - 1) / cells, seed, &total))
                return 1;
    printf("%llu pairs: every box is right\n", (unsigned long long)total);
    return 0;
}
