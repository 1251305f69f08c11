/* form.h: the text form of evidence as a table, shared by reader and writer.
 *
 * A claim is a heading ("claim bound upper x <= 5/2"), lines of parts ("row 3 1", "point x 5/2")
 * and "end"; a last line, "claims 7", gives their number. docs/proof-format.md describes the format
 * for users.
 */
#ifndef FMB_PROOF_FORM_H
#define FMB_PROOF_FORM_H

#include "proof/evidence/evidence.h"

/* A longer word (a number, a name) is refused, so that a bad file cannot exhaust the memory. */
#define FMB_PROOF_WORD_MAX ((size_t)1 << 20) /* [bytes] */

/* What follows "claim KIND" on the heading line. */
typedef enum fmb_heading {
    FMB_HEADING_NONE,
    FMB_HEADING_END,        /* side, variable; without a variable, lines give the terms */
    FMB_HEADING_BOUND,      /* side, variable, relation, value; the same */
    FMB_HEADING_INEQUALITY, /* relation, value */
    FMB_HEADING_ROW,        /* row */
    FMB_HEADING_VARIABLES   /* variables: terms */
} fmb_heading;

/* Kinds of lines inside a claim: "WORD KEY NUMBER". */
typedef enum fmb_form_part {
    FMB_PART_POINT,
    FMB_PART_RAY,
    FMB_PART_TERM,
    FMB_PART_ROW,
    FMB_PART_REVERSE,
    FMB_PART_STEP,
    FMB_PART_CLAIM,
    FMB_PARTS
} fmb_form_part;

/* What the key of a line refers to. */
typedef enum fmb_part_key { FMB_KEY_VARIABLE = 0, FMB_KEY_ROW, FMB_KEY_CLAIM } fmb_part_key;

typedef struct fmb_part_form {
    const char *word;
    fmb_part_key key;
} fmb_part_form;

typedef struct fmb_claim_form {
    const char *word; /* NULL: no such kind */
    fmb_heading heading;
    bool part[FMB_PARTS]; /* the parts allowed */
} fmb_claim_form;

extern const fmb_part_form fmb_part_forms[FMB_PARTS];
extern const fmb_claim_form fmb_claim_forms[FMB_CLAIM_FOLLOWS + 1]; /* by kind */

/* Sign of a relation for that end of an interval: an upper end is <= or <, a lower one >= or >. */
const char *fmb_form_relation(fmb_rel rel, fmb_side side);

/* May this claim have lines of that part? A claim about a single variable has no terms. */
bool fmb_form_allows(const fmb_claim *c, fmb_form_part part);

/* The list of a claim that holds a part. */
fmb_sparse_vector *fmb_form_list(fmb_claim *c, fmb_form_part part);

#endif
