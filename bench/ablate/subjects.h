/* subjects.h: the problems that ways are tried on: known files, and families under fresh seeds. */
#ifndef FMB_ABLATE_SUBJECTS_H
#define FMB_ABLATE_SUBJECTS_H

#include "../peers/child.h"

typedef struct subject_plan {
    uint64_t seed, each; /* seeds of each family, from seed on */
    char **file;
    size_t files;
} subject_plan;

/* The question in a word: "project", ..., or "pairs". p NULL: any problem of rows. */
const char *subject_word(const problem *p, peer_question question);
/* Takes over p. */
typedef void subject_ask(void *self, problem *p, peer_question question);

/* Projections of all families; linear programs of all families, at a size drawn by the seed: their
 * verdict, box, optimum and irredundant rows; both also with long numbers (a / behind the name);
 * vertices and hulls of polytopes; verdicts and boxes of pairs of frames (problem.own). Each file:
 * its verdict, its irredundant rows, and its projection where it keeps some variables. False if a
 * file could not be read. */
bool subjects_each(const subject_plan *plan, subject_ask *ask, void *self);

#endif
