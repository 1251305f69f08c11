/* lift_private.h: systems whose projection is an image, a sum or a hull; see fmb/lift.h.
 *
 * Each function fills a system that has no variables and rows yet, and marks those that the answer
 * keeps, which come first. LIMIT is that of the memory within which the system stands. After ARG,
 * fmb_system_trouble of it tells why. After any error it is only good to be freed.
 */
#ifndef FMB_LIFT_LIFT_PRIVATE_H
#define FMB_LIFT_LIFT_PRIVATE_H

#include <fmb/generators.h>
#include <fmb/system.h>

/* How many variables s keeps (fmb_system_keeps). */
int fmb_lift_dim(const fmb_system *s);

/* Only the variables of the answer, as fmb_lift_image adds them first. Errors: ARG, MEMORY. */
fmb_status fmb_lift_add_answer_of_graph(fmb_system *lift, const fmb_system *s,
                                        const fmb_system *graph);
/* Errors: ARG, MEMORY, LIMIT. */
fmb_status fmb_lift_image(fmb_system *lift, const fmb_system *s, const fmb_system *graph);
fmb_status fmb_lift_sum(fmb_system *lift, const fmb_system *const *s, size_t n);
/* None of them is empty; like has the names, if there are none. */
fmb_status fmb_lift_hull(fmb_system *lift, const fmb_system *like, const fmb_system *const *s,
                         size_t n);
/* Do s[0..n) keep variables of the same names? lift is only told what is wrong. */
fmb_status fmb_lift_match(fmb_system *lift, const fmb_system *const *s, size_t n);

/* ---- for the other files of this room -------------------------------------------------------- */

/* Variables named as those that s keeps, which are kept. */
fmb_status fmb_lift_add_answer(fmb_system *lift, const fmb_system *s);
/* A variable called that, or that with _k behind it (k > 0), with underscores while it is taken. */
fmb_status fmb_lift_add_fresh(fmb_system *lift, const char *name, size_t k, int *index);
/* Such a copy of each variable of s: copy[j] of variable j. */
fmb_status fmb_lift_add_copies(fmb_system *lift, const fmb_system *s, size_t k, int *copy);

/* Copies of the variables of several polyhedra. */
typedef struct fmb_lift_copies {
    const fmb_system *const *s; /* [n] */
    size_t n;
    int **var; /* [n][dim of s[i]] */
} fmb_lift_copies;

/* Add the answer, named as like, and copies of all variables of each. In any case
 * fmb_lift_close_copies. */
fmb_status fmb_lift_open_copies(fmb_lift_copies *c, fmb_system *lift, const fmb_system *like,
                                const fmb_system *const *s, size_t n);
void fmb_lift_close_copies(fmb_lift_copies *c, fmb_system *lift);
/* The rows that say: each variable of the answer is the sum of its copies. */
fmb_status fmb_lift_append_sums(const fmb_lift_copies *c, fmb_system *lift);

#endif
