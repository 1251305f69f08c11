/* formula.h: formulas of an SMT-LIB text, as a DAG that shares what the text shares.
 *
 * A formula is a literal: twice a node, plus 1 if it is negated. Nodes are the constant true, atoms
 * (a linear term REL 0), Boolean unknowns, conjunctions, labelled formulas, and formulas beyond
 * conjunctions ("hard"), which are an error only where an assertion needs them. `a or b` is
 * not(not a and not b). An assertion of a Boolean unknown is a fact and no row.
 *
 * Invariant: children are smaller than their node.
 */
#ifndef FMB_IO_SMT2_FORMULA_H
#define FMB_IO_SMT2_FORMULA_H

#include "io/core/cursor.h"
#include "io/smt2/linear.h"

/* The charge for reading a byte again [digits of the budget]. */
#define FMB_SMT_BYTE_DIGITS 16

/* ---- facts: values of Boolean unknowns that assertions imply ------------------------------------
 *
 * An asserted unknown is true in the whole text, also before its assertion. So a command that needs
 * a choice between cases is skipped while unknowns are open; if the text then implies a new fact,
 * it is read again from its start with the known facts (unit propagation, Davis and Putnam 1960,
 * one reading of the text per step). */

/* The truth of a formula as far as it is known without search. */
typedef enum fmb_smt_truth {
    FMB_SMT_OPEN_TRUTH = 0,
    FMB_SMT_IS_TRUE,
    FMB_SMT_IS_FALSE
} fmb_smt_truth;

typedef struct fmb_smt_facts {
    fmb_smt_truth *truth; /* [unknowns] in the order of their declarations */
    size_t unknowns, capacity;
    size_t *told; /* unknowns that this reading has decided, in order */
    size_t tolds, told_capacity;
    size_t declared;  /* unknowns declared by this reading */
    size_t open;      /* of these, undecided ones */
    bool learned;     /* this reading has found a new fact */
    bool undecided;   /* the command that failed last needs a choice between cases */
    bool passed_over; /* this reading has skipped such a command */
    fmb_where first;  /* the place of the first one */
} fmb_smt_facts;

/* Forget all facts. */
static inline void fmb_smt_facts_clear(fmb_smt_facts *facts, fmb_mem *mem)
{
    fmb_mem_put(mem, facts->truth, facts->capacity, sizeof *facts->truth);
    fmb_mem_put(mem, facts->told, facts->told_capacity, sizeof *facts->told);
    *facts = (fmb_smt_facts){0};
}

#define FMB_SMT_TRUE  ((uint32_t)0)
#define FMB_SMT_FALSE ((uint32_t)1)

typedef enum fmb_form_kind {
    FMB_FORM_TRUE = 0,
    FMB_FORM_ATOM,
    FMB_FORM_UNKNOWN,
    FMB_FORM_AND,
    FMB_FORM_LABEL,
    FMB_FORM_HARD
} fmb_form_kind;

typedef struct fmb_form_node {
    fmb_form_kind kind;
    fmb_smt_truth truth;
    const char *at;   /* the place named in errors */
    const char *word; /* AND, HARD: the operator in the text */
    fmb_rel rel;      /* ATOM */
    uint32_t lin;     /* ATOM: its linear term */
    size_t unknown;   /* UNKNOWN: its number among the facts */
    fmb_span label;   /* LABEL */
    size_t first;     /* AND, LABEL: child[first .. first + n) */
    uint32_t n;
    uint32_t stamp[2]; /* the assertion that has processed it already, plain and negated */
} fmb_form_node;

/* A formula to assert, and the label of its rows. */
typedef struct fmb_form_task {
    uint32_t literal;
    fmb_span label; /* p NULL: none */
} fmb_form_task;

typedef struct fmb_forms {
    fmb_lin *lin;
    fmb_smt_facts *facts;
    fmb_form_node *node;
    size_t nodes, node_capacity;
    uint32_t *child;
    size_t children, child_capacity;
    fmb_form_task *task; /* scratch of assertion */
    size_t task_capacity;
    fmb_draft row;
    uint32_t stamp;
} fmb_forms;

/* Errors: MEMORY. */
fmb_status fmb_forms_init(fmb_forms *f, fmb_lin *lin, fmb_smt_facts *facts);
void fmb_forms_clear(fmb_forms *f);
/* Forget the nodes from number `nodes` on. */
void fmb_forms_forget(fmb_forms *f, size_t nodes);

fmb_smt_truth fmb_form_truth(const fmb_forms *f, uint32_t literal);

/* New formulas; at: their place in the text, word (static): the operator there. Errors: MEMORY. */
fmb_status fmb_form_atom(fmb_forms *f, const char *at, uint32_t lin, fmb_rel rel, uint32_t *out);
fmb_status fmb_form_and(fmb_forms *f, const char *at, const char *word, size_t n,
                        const uint32_t *literal, uint32_t *out);
fmb_status fmb_form_label(fmb_forms *f, const char *at, fmb_span label, uint32_t literal,
                          uint32_t *out);
/* A Boolean unknown by its number: a constant if a fact decides it. */
fmb_status fmb_form_unknown(fmb_forms *f, const char *at, size_t unknown, uint32_t *out);
fmb_status fmb_form_hard(fmb_forms *f, const char *at, const char *word, uint32_t *out);

/* Fail: with the known facts the text at `at` is no conjunction, and would need a search. */
fmb_status fmb_form_undecided(fmb_forms *f, const char *at, const char *what);
/* Append the rows of an asserted formula. Errors: MEMORY, PARSE ("not a conjunction"). */
fmb_status fmb_form_assert(fmb_forms *f, uint32_t literal, fmb_system *s);

#endif
