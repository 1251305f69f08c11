/* cells.c: see cells.h. */
#include "cells.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void must(fmb_status st)
{
    if (st != FMB_OK) {
        fprintf(stderr, "%s\n", fmb_status_text(st));
        exit(70);
    }
}

study_pair_plan cell_plan(int i)
{
    int kind = i % 3;
    return (study_pair_plan){.family = STUDY_PAIR_ARTICLE,
                             .dim = 2 + i / 3 % 2,
                             .moves = i / 6,
                             .shape = {kind == 2, kind > 0}};
}

const char *cell_text(const study_pair_plan *plan)
{
    static char text[sizeof "2D moving CC"];
    static const char *const kind[3] = {"CC", "CT", "TT"};
    snprintf(text, sizeof text, "%dD %-6s %s", plan->dim % 10, plan->moves ? "moving" : "still",
             kind[plan->shape[0] + plan->shape[1]]);
    return text;
}

typedef struct wanted {
    fmb_pair *k;
    fmb_verdict verdict;
} wanted;

static bool is_wanted(void *self, const fmb_frame *p, const fmb_frame *q)
{
    wanted *w = self;
    fmb_verdict is;
    must(fmb_pair_test(w->k, 1, p, q,
                       &(fmb_pair_answers){.size = sizeof(fmb_pair_answers), .verdict = &is}));
    return is == w->verdict;
}

study_pairs cell_pairs(const study_pair_plan *plan, size_t n, fmb_pair *k, fmb_verdict verdict)
{
    study_pairs pairs;
    wanted only = {k, verdict};
    must(study_pairs_make(plan, 1, n, is_wanted, &only, &pairs));
    return pairs;
}

bool parse_simd(const char *word, fmb_simd *out)
{
    static const char *const name[] = {"--simd=plain", "--simd=avx2", "--simd=avx512"};
    static const fmb_simd level[] = {FMB_SIMD_PLAIN, FMB_SIMD_AVX2, FMB_SIMD_AVX512};
    for (int l = 0; l < 3; l++)
        if (strcmp(word, name[l]) == 0) {
            *out = level[l];
            return true;
        }
    return false;
}
