/* contacts.h: exact distances and depths in four to eight dimensions, judged (difference.h).
 */
#ifndef VALIDATE_CONTACTS_H
#define VALIDATE_CONTACTS_H

#include "fmb-validate/difference.h"
#include "study/reference/validate.h"

enum { VALIDATE_LEAST_DIM = 4 }; /* in fewer, study_validator judges contacts itself */

/* What is said of two frames: how deep they are in each other, or else how far apart. */
typedef struct validate_claim {
    bool deep;
    double length;
    mpq_t square, shift[VALIDATE_MOST_DIM];  /* the length, and where Q goes */
    mpq_t point[2][VALIDATE_MOST_DIM], time; /* of those apart */
} validate_claim;

void validate_claim_init(validate_claim *c);
void validate_claim_clear(validate_claim *c);

/* What the library says; *said: it gives an answer, and does not contradict itself. Errors: MEMORY.
 */
fmb_status validate_claim_ask(fmb_solver *v, const fmb_frame *f, validate_claim *c, bool *said);

typedef struct validate_contacts validate_contacts;

/* [give] Errors: MEMORY. */
fmb_status validate_contacts_open(const study_validation *v, validate_contacts **out);
void validate_contacts_close(validate_contacts *b);

/* Is all of that true of two frames? Cuboids and simplices by edges, of finite numbers. */
fmb_status validate_judge(validate_contacts *b, const fmb_frame *f, const validate_claim *c,
                          bool *good);
/* The library's answers about pairs first ... first + n - 1, each in one of both orders, until a
 * signal comes; adds to the tally and to what was found of these pairs from item `from` on. */
fmb_status validate_contacts_run(validate_contacts *b, uint64_t first, size_t n, study_tally *tally,
                                 study_findings *found, size_t from);

#endif
