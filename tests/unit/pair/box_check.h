/* box_check.h: compares boxes, times and witnesses of meeting pairs with the exact ones. */
#ifndef FMB_TEST_BOX_CHECK_H
#define FMB_TEST_BOX_CHECK_H

#include <fmb/gmp.h>
#include <fmb/pair.h>

enum { BOX_CHECK_MOST_DIM = 8 };

/* The answers of one pair. */
typedef struct box_answer {
    double world[BOX_CHECK_MOST_DIM][2], inside[BOX_CHECK_MOST_DIM][2], time[2];
    double witness[BOX_CHECK_MOST_DIM];
} box_answer;

/* Where fmb_pair_test shall write one pair. */
fmb_pair_answers box_answer_places(box_answer *a, fmb_verdict *verdict);

/* The largest coordinate of a corner of p or q, at t = 0 or 1. */
double box_largest(const fmb_frame *p, const fmb_frame *q);

typedef struct box_check {
    fmb_solver *solver;
    double excess; /* the most by which an end lay farther out, of what is allowed (1e-12) */
    char why[200];
} box_check;

void box_check_open(box_check *c);
void box_check_close(box_check *c);

/* n answers about one pair: every end contains the exact one and exceeds it by at most 1e-12 (of
 * the largest coordinate, in the world); tightest: it is the exact one, rounded outward. The
 * witness is as near to a common point. If not: false, and why. */
bool box_check_pair(box_check *c, const fmb_frame *p, const fmb_frame *q, const box_answer *a,
                    size_t n, bool tightest);

#endif
