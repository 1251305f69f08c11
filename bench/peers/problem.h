/* problem.h: the elimination problem that all drivers get: integer rows, kept variables first.
 *
 * The library's own reader reads it, so that all drivers get the same numbers. A problem of k
 * variants has the same rows in k orders; a driver opens each variant.
 */
#ifndef FMB_PEERS_PROBLEM_H
#define FMB_PEERS_PROBLEM_H

#include <fmb/fmb.h>
#include <gmp.h>

/* a[0..n) . x REL a[n]; for a generator: the vertex a / a[n] or a ray (LE), or a line (EQ). */
typedef struct problem_row {
    mpz_t *a;
    fmb_rel rel;
} problem_row;

typedef struct problem {
    char name[64], family[16];
    int n, keep; /* the first keep of n variables are kept */
    size_t m, equalities;
    bool strict; /* some row is strict */
    problem_row *rows;
    fmb_system *system;         /* the same rows, for fmb, */
    fmb_generators *generators; /* or the same generators */
    const void *own;            /* NULL, or one program's question without rows; not owned */
} problem;

/* Reads a file; a message on stderr and false if it cannot be used. */
bool problem_read(problem *p, const char *path);
/* A problem of a system, which it takes over. */
void problem_of_system(problem *p, const char *name, fmb_system *s);
/* A problem of generators, which it takes over. */
void problem_of_generators(problem *p, const char *name, fmb_generators *g);
/* Replaces the rows by their generators; false if there are none, or too many. */
bool problem_turn_over(problem *p);
/* The same rows in an order that depends on number; 0 is the order of the file. */
void problem_variant(problem *v, const problem *p, unsigned number);
void problem_clear(problem *p);

/* Appends a.x REL a[dim] to a system: drivers return their results so. */
void system_add_row(fmb_system *s, mpz_t *a, fmb_rel rel);
fmb_system *system_of_dim(int dim);
/* Generators coded as rows, as in problem_row. */
fmb_system *system_of_generators(const fmb_generators *g);

/* Allocate n integers, all 0; free them. */
mpz_t *integers_new(size_t n);
void integers_free(mpz_t *a, size_t n);

/* Returns p; ends the program if p is NULL. */
void *need(void *p);

#endif
