/* facts.h: what the assertions of an SMT-LIB text say of its Boolean unknowns.
 *
 * An asserted unknown is true in all that follows and in all that came before, whichever assertion
 * needs it. So a command that needs a choice between cases is passed over while unknowns are open;
 * if the text then tells something new, it is read again from its start with the facts known
 * (unit propagation, Davis and Putnam 1960, a reading of the text a step).
 */
#ifndef FMB_IO_SMT2_FACTS_H
#define FMB_IO_SMT2_FACTS_H

#include "io/core/cursor.h"

/* Reading a byte again costs as much as about so many digits. */
#define FMB_SMT_BYTE_DIGITS 16

/* What is known of a formula without search. */
typedef enum fmb_smt_truth {
    FMB_SMT_OPEN_TRUTH = 0,
    FMB_SMT_IS_TRUE,
    FMB_SMT_IS_FALSE
} fmb_smt_truth;

typedef struct fmb_smt_facts {
    fmb_smt_truth *truth; /* [unknowns] in the order of their declarations */
    size_t unknowns, capacity;
    size_t *told; /* unknowns that this reading has told, one after another */
    size_t tolds, told_capacity;
    size_t declared;  /* by this reading */
    size_t open;      /* of those declared, unknown */
    bool learned;     /* this reading has told something new */
    bool undecided;   /* the command that failed last needs a choice between cases */
    bool passed_over; /* one such was passed over by this reading */
    fmb_where first;  /* where that was */
} fmb_smt_facts;

/* Nothing is known. */
static inline void fmb_smt_facts_clear(fmb_smt_facts *facts, fmb_mem *mem)
{
    fmb_mem_put(mem, facts->truth, facts->capacity, sizeof *facts->truth);
    fmb_mem_put(mem, facts->told, facts->told_capacity, sizeof *facts->told);
    *facts = (fmb_smt_facts){0};
}

#endif
