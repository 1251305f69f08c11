/* subject.h: a system to measure: read from a file or drawn from a family, perhaps rescaled or with
 * long fractions. */
#ifndef FMB_BENCH_SUBJECT_H
#define FMB_BENCH_SUBJECT_H

#include "child.h"
#include "study/program/program.h"

/* How the system was changed before the measurement. */
typedef enum subject_dress {
    DRESS_NONE = 0,
    DRESS_SCALES,   /* rows and columns times 10^-9 ... 10^9 */
    DRESS_FRACTIONS /* numbers p/q of 10 digits */
} subject_dress;

typedef struct subject {
    char name[64];
    int n;
    size_t m, terms;
    size_t bytes; /* of the system [bytes], without the limbs of long numbers */
    problem variant[CHILD_VARIANTS];
    int variants;
    fmb_verdict verdict; /* known beforehand, or UNKNOWN */
    bool has_best;       /* of the objective */
    double best;
} subject;

/* A path, or a family and perhaps a size (program.h). False, and a message on stderr, if it is
 * neither. */
bool subject_open(subject *s, const char *what, subject_dress dress, uint64_t seed);
/* Like subject_open, for a plan of a family. */
bool subject_draw(subject *s, const study_program_plan *plan, subject_dress dress);
void subject_close(subject *s);

#endif
