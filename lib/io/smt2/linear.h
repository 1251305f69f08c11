/* linear.h: linear terms of an SMT-LIB text, as a DAG that shares what the text shares.
 *
 * A node is a variable, or a sum  constant + sum coef_k leaf_k  over earlier nodes, without zero
 * coefficients. Sums of at most FMB_LIN_SHORT terms are copied into the sums that use them, longer
 * ones are referred to: so the pool stays linear in the text, and a term that a let or a define-fun
 * names is computed once.
 *
 * Invariants: leaves are smaller than their node (the order is topological); a leaf that is a sum
 * has more than FMB_LIN_SHORT terms.
 */
#ifndef FMB_IO_SMT2_LINEAR_H
#define FMB_IO_SMT2_LINEAR_H

#include "io/core/io_private.h"

#define FMB_LIN_SHORT 8

typedef struct fmb_lin_term {
    uint32_t leaf;
    mpq_t coef;
} fmb_lin_term;

typedef struct fmb_lin_node {
    int var; /* or -1: a sum */
    uint32_t n;
    size_t first;   /* its terms are term[first .. first + n) */
    mpq_t constant; /* of a sum */
    uint32_t place; /* scratch of expansion: index in reached[] */
    uint32_t stamp;
} fmb_lin_node;

/* A sum being built: the first n terms (initialised up to capacity), and the constant. */
typedef struct fmb_lin_sum {
    fmb_lin_term *term;
    size_t n, capacity;
    size_t tidy; /* number of terms after like terms were last combined */
    mpq_t constant;
} fmb_lin_sum;

typedef struct fmb_lin {
    fmb_cursor *c;
    fmb_lin_node *node;
    size_t nodes, node_capacity;
    fmb_lin_term *term;
    size_t terms, term_capacity;
    fmb_lin_sum sum;
    uint32_t *reached; /* scratch of expansion */
    size_t reached_capacity;
    mpq_t *factor; /* one per reached node; all initialised */
    size_t factors;
    mpq_t product; /* scratch */
    uint32_t stamp;
} fmb_lin;

void fmb_lin_init(fmb_lin *l, fmb_cursor *c);
void fmb_lin_clear(fmb_lin *l);
/* Forget the nodes from number `nodes` on. */
void fmb_lin_forget(fmb_lin *l, size_t nodes);

/* A new node for variable var. Below: for a number, swapped out of value. Errors: MEMORY. */
fmb_status fmb_lin_variable(fmb_lin *l, int var, uint32_t *out);
fmb_status fmb_lin_number(fmb_lin *l, mpq_t value, uint32_t *out);

/* Build a sum: begin, add (factor times node) repeatedly, end. at: the place named if the numbers
 * exceed the budget. Errors: MEMORY, PARSE. */
void fmb_lin_begin(fmb_lin *l);
fmb_status fmb_lin_add(fmb_lin *l, const char *at, uint32_t node, mpq_srcptr factor);
fmb_status fmb_lin_end(fmb_lin *l, uint32_t *out);

/* Is the node a number? Then value is set. Errors: MEMORY, PARSE. */
fmb_status fmb_lin_constant(fmb_lin *l, const char *at, uint32_t node, bool *yes, mpq_t value);
/* Expand the node into d: terms over variables, and minus its constant as right side. Errors:
 * MEMORY, PARSE. */
fmb_status fmb_lin_expand(fmb_lin *l, const char *at, uint32_t node, fmb_draft *d);

/* Does the node have no terms at all, so that its constant is its value? */
static inline bool fmb_lin_is_bare(const fmb_lin *l, uint32_t node)
{
    return l->node[node].var < 0 && l->node[node].n == 0;
}

#endif
