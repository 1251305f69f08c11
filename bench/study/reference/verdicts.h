/* verdicts.h: what was said about one pair in many ways, and where that does not fit together. */
#ifndef FMB_STUDY_VERDICTS_H
#define FMB_STUDY_VERDICTS_H

#include <fmb/pair.h>

/* What is asked first. */
typedef enum study_pair_method { STUDY_BY_FMB = 0, STUDY_BY_SAT, STUDY_BY_EXACT } study_pair_method;

/* Each is asked as A, B and as B, A. */
typedef enum study_way_of_pairs {
    STUDY_FMB_DOUBLES = 0, /* what doubles alone are certain of */
    STUDY_SAT_DOUBLES,
    STUDY_FMB_CLOSED, /* the whole ladder, down to the exact way */
    STUDY_SAT_CLOSED,
    STUDY_FMB_OPEN,
    STUDY_SAT_OPEN,
    STUDY_EXACT_CLOSED,
    STUDY_EXACT_OPEN,
    STUDY_PAIR_WAYS
} study_way_of_pairs;

typedef struct study_verdicts {
    fmb_verdict said[STUDY_PAIR_WAYS][2]; /* [way][order] */
    unsigned asked;                       /* ways, as bits */
    fmb_verdict proved[2];                /* [contact] by a certificate; UNKNOWN if not asked */
} study_verdicts;

/* "fmb-doubles", ... */
const char *study_way_text(study_way_of_pairs way);
study_pair_method study_way_method(study_way_of_pairs way);
fmb_pair_options study_way_options(study_way_of_pairs way, fmb_simd simd);
/* [give] Errors: those of fmb_pair_new. */
fmb_status study_way_open(study_way_of_pairs way, int dim, fmb_simd simd, fmb_pair **out);

/* Faults, as bits. */
enum {
    STUDY_FAULT_SAT = 1,     /* FMB and SAT differ */
    STUDY_FAULT_EXACT = 2,   /* one of them and the exact way, or a proof, differ */
    STUDY_FAULT_ITSELF = 4,  /* one method contradicts itself: A, B and B, A, or doubles and all */
    STUDY_FAULT_CONTACT = 8, /* open frames meet, closed ones do not */
    STUDY_FAULT_UNDECIDED = 16,  /* the whole ladder did not decide */
    STUDY_FAULT_OUTSIDE = 32,    /* a box does not hold the exact one */
    STUDY_FAULT_WIDE = 64,       /* a box is too large */
    STUDY_FAULT_TIGHTEST = 128,  /* the tightest ends are not the exact ones */
    STUDY_FAULT_WITNESS = 256,   /* a witness is not in both frames */
    STUDY_FAULT_UNPROVED = 512,  /* there is no proof that is accepted */
    STUDY_FAULT_TEXTBOOK = 1024, /* the textbook truth says something else */
    STUDY_FAULT_NEAR = 2048,     /* a depth or a distance, or what belongs to it, is wrong */
    STUDY_FAULTS = 12            /* kinds */
};

/* "sat", ... of bit 1 << i. */
const char *study_fault_text(int i);

/* The faults that verdicts show. */
unsigned study_verdict_faults(const study_verdicts *v);

#endif
