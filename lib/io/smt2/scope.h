/* scope.h: symbols of an SMT-LIB text and their meanings.
 *
 * Symbols differ in spelling (bars are ignored). A symbol may have a global meaning, given once by
 * a command, and local ones, given by let and by parameters of a define-fun: the newest hides the
 * others.
 *
 * Invariants: slots is a power of two above twice the number of symbols; local[symbol.newest] is
 * the newest local meaning of symbol, with links to the older ones. Inside the body of a define-fun
 * only local meanings from number `visible` on count: a let around the use of the function does not
 * apply to its body.
 */
#ifndef FMB_IO_SMT2_SCOPE_H
#define FMB_IO_SMT2_SCOPE_H

#include "io/core/io_private.h"

/* A term or a formula, and its place in the text. */
typedef struct fmb_smt_value {
    bool formula;
    uint32_t id; /* node of a linear term; literal */
    const char *at;
} fmb_smt_value;

typedef enum fmb_smt_sort { FMB_SMT_REAL = 0, FMB_SMT_INT, FMB_SMT_BOOL } fmb_smt_sort;

typedef enum fmb_smt_meaning {
    FMB_SMT_NOTHING = 0,
    FMB_SMT_VALUE,   /* value */
    FMB_SMT_UNKNOWN, /* a Boolean unknown */
    FMB_SMT_MACRO,   /* index: a define-fun with parameters */
    FMB_SMT_OPERATOR /* index: in the table of operators */
} fmb_smt_meaning;

#define FMB_SMT_NONE SIZE_MAX

typedef struct fmb_smt_symbol {
    fmb_span text;
    fmb_smt_meaning meaning; /* as a function */
    fmb_smt_value value;
    size_t index;
    bool is_sort; /* sorts have names of their own */
    fmb_smt_sort sort;
    size_t newest; /* local meaning, or FMB_SMT_NONE */
} fmb_smt_symbol;

typedef struct fmb_smt_local {
    size_t symbol, older;
    fmb_smt_value value;
} fmb_smt_local;

/* A global meaning that was given: as a function, or as a sort. */
typedef struct fmb_smt_given {
    size_t symbol;
    bool sort;
} fmb_smt_given;

typedef struct fmb_smt_scope {
    fmb_mem *mem;
    fmb_smt_symbol *symbol;
    size_t symbols, symbol_capacity;
    size_t *slot; /* [slots] symbol + 1; 0 = free */
    size_t slots;
    fmb_smt_local *local;
    size_t locals, local_capacity;
    size_t visible;
    fmb_smt_given *given; /* global meanings, in the order in which commands gave them */
    size_t givens, given_capacity;
} fmb_smt_scope;

void fmb_smt_scope_init(fmb_smt_scope *s, fmb_mem *mem);
void fmb_smt_scope_clear(fmb_smt_scope *s);
/* Number of the symbol, new or known. Its text must live as long as the scope. Errors: MEMORY. */
fmb_status fmb_smt_intern(fmb_smt_scope *s, fmb_span text, size_t *out);
/* Record that a command gives the symbol a global meaning, which the caller sets. Below: withdraw
 * all such meanings but the first `givens`. Errors: MEMORY. */
fmb_status fmb_smt_give(fmb_smt_scope *s, size_t symbol, bool sort);
void fmb_smt_take_back(fmb_smt_scope *s, size_t givens);
/* Add a local meaning. Below: remove all but the first `locals`. Errors: MEMORY. */
fmb_status fmb_smt_bind(fmb_smt_scope *s, size_t symbol, fmb_smt_value value);
void fmb_smt_unbind(fmb_smt_scope *s, size_t locals);
/* The local meaning that is visible here, or NULL. */
const fmb_smt_local *fmb_smt_find_local(const fmb_smt_scope *s, size_t symbol);

#endif
