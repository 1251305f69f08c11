/* support.h: systems for tests: random ones from a seed, all tiny ones, and a shrinker.
 *
 *   support_case c = support_make(SUPPORT_PLANTED_FARKAS, seed, NULL);
 *   ... ask about c.s, compare with c.verdict ...
 *   support_case_clear(&c);
 *
 * The same seed gives the same system for ever, on every machine. All functions stop the program if
 * memory runs out.
 */
#ifndef FMB_TEST_SUPPORT_H
#define FMB_TEST_SUPPORT_H

#include <stdio.h>

#include <fmb/gmp.h>

/* ---- random numbers -------------------------------------------------------------------------- */

/* splitmix64 (Steele, Lea, Flood 2014, doi 10.1145/2714064.2660195): any state is a good seed. */
typedef struct support_rng {
    uint64_t state;
} support_rng;

uint64_t support_next(support_rng *g);
/* From lo to hi, both included. */
int support_between(support_rng *g, int lo, int hi);
/* True with a probability of `percent` in 100. */
bool support_chance(support_rng *g, int percent);
/* Small (-9..9) if bits is 0; else a mix of small numbers and numbers within 2 of +-2^bits. */
void support_integer(support_rng *g, int bits, mpz_t out);

/* ---- random systems -------------------------------------------------------------------------- */

typedef enum support_family {
    SUPPORT_PLANTED_POINT,  /* feasible: a chosen point satisfies every row, many with equality */
    SUPPORT_PLANTED_FARKAS, /* infeasible: chosen multipliers combine some rows to a conflict */
    SUPPORT_DEGENERATE,     /* numbers -1, 0, 1: many ties, many rows through one point */
    SUPPORT_PARALLEL,       /* duplicates, multiples, and multiples moved a little */
    SUPPORT_MIXED,          /* equalities, strict rows and others, nothing planted */
    SUPPORT_FAMILIES
} support_family;

typedef struct support_shape {
    int dim, rows;
    int bits; /* see support_integer: 0, 31, 53, 63, 200, ... */
} support_shape;

typedef struct support_case {
    fmb_system *s;
    fmb_verdict verdict; /* as planted; FMB_UNKNOWN if none was planted */
    support_family family;
    support_shape shape;
    uint64_t seed;
} support_case;

/* With shape NULL the seed also chooses the shape: up to 5 variables and 10 rows, every bits above.
 */
support_case support_make(support_family family, uint64_t seed, const support_shape *shape);
void support_case_clear(support_case *c);
/* "planted-point", ... */
const char *support_family_name(support_family family);

/* ---- of systems ------------------------------------------------------------------------------ */

/* s with each < relaxed to <=. The caller frees it. */
fmb_system *support_closure(const fmb_system *s);

/* The verdict on s, by a solver of its own, whose evidence fmb_check accepted. */
fmb_verdict support_proved_verdict(const fmb_system *s);

/* How many claims IMPLIED the evidence of the last query on s has, which fmb_check accepted. */
size_t support_proved_rows(const fmb_solver *v, const fmb_system *s);

/* ---- all tiny systems ------------------------------------------------------------------------ */

/* All systems of 2 variables and at most 4 rows, coefficients and right sides in {-1, 0, 1},
 * relations <= and <, up to symmetry: the order of rows, the order of variables, and x -> -x of
 * each variable do not count. The same row may come twice. */
enum { SUPPORT_TINY_COUNT = 58690 }; /* how many there are */

/* Zero-initialise; each call gives the next system, which the caller frees, and NULL at the end. */
typedef struct support_tiny {
    int rows, row[4];
    bool begun;
} support_tiny;

fmb_system *support_tiny_next(support_tiny *at);

/* ---- failing systems ------------------------------------------------------------------------- */

/* Does this system still show the failure? */
typedef bool (*support_predicate)(void *self, const fmb_system *s);

/* A smaller system that still fails, given that s does: rows and variables are dropped, numbers
 * made simpler, < made <=, as long as it fails. The caller frees it. */
fmb_system *support_shrink(const fmb_system *s, support_predicate fails, void *self);

/* As .fmb text, with a first comment line unless it is NULL. */
void support_print(const fmb_system *s, const char *comment, FILE *out);
/* Shrink the system of a failing case and print it to stderr with family, shape and seed. */
void support_report(const support_case *c, support_predicate fails, void *self);

#endif
