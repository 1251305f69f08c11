/* problem.h: an elimination problem as all drivers get it: integer rows, kept variables first.
 *
 * Read by the library's own reader, so that no driver sees a number another one does not. A
 * problem of k variants is the same rows in k orders; a driver opens each of them.
 */
#ifndef FMB_PEERS_PROBLEM_H
#define FMB_PEERS_PROBLEM_H

#include <fmb/fmb.h>
#include <gmp.h>

/* a[0..n) . x REL a[n]; of generators the vertex a / a[n] or a ray (LE), or a line (EQ). */
typedef struct problem_row {
    mpz_t *a;
    fmb_rel rel;
} problem_row;

typedef struct problem {
    char name[64], family[16];
    int n, keep; /* the first keep of n variables stay */
    size_t m, equalities;
    bool strict; /* some row is strict */
    problem_row *rows;
    fmb_system *system;         /* the same rows, for fmb, */
    fmb_generators *generators; /* or the same generators */
    const void *own;            /* NULL, or what a program asks that has no rows; not owned */
} problem;

/* Reads a file; a message on stderr and false if it cannot be used. */
bool problem_read(problem *p, const char *path);
/* A problem of a system, which it takes over. */
void problem_of_system(problem *p, const char *name, fmb_system *s);
/* A problem of generators, which it takes over. */
void problem_of_generators(problem *p, const char *name, fmb_generators *g);
/* The generators of its rows take their place; false if there are none, or too many. */
bool problem_turn_over(problem *p);
/* The same rows in an order of its own for each number; 0 is the order of the file. */
void problem_variant(problem *v, const problem *p, unsigned number);
void problem_clear(problem *p);

/* A row's a.x REL a[dim] as a row of a system: how drivers give their results back. */
void system_add_row(fmb_system *s, mpz_t *a, fmb_rel rel);
fmb_system *system_of_dim(int dim);
/* Generators in the dress of rows, as above. */
fmb_system *system_of_generators(const fmb_generators *g);

/* n integers, all 0; and their end. */
mpz_t *integers_new(size_t n);
void integers_free(mpz_t *a, size_t n);

/* p, or the end of the program if it is NULL. */
void *need(void *p);

#endif
