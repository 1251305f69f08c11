/* lift_private.h: systems whose projection is an image, a sum or a hull; see fmb/lift.h.
 *
 * Each function fills a system without variables and rows, and marks the variables of the answer,
 * which come first, as kept. LIMIT refers to the memory limit around the system. After ARG, its
 * fmb_system_trouble gives the reason. After any error the system can only be freed.
 */
#ifndef FMB_LIFT_LIFT_PRIVATE_H
#define FMB_LIFT_LIFT_PRIVATE_H

#include <fmb/generators.h>
#include <fmb/system.h>

/* The number of variables that s keeps (fmb_system_keeps). */
int fmb_lift_dim(const fmb_system *s);

/* Add only the variables of the answer, as fmb_lift_image adds them first. Errors: ARG, MEMORY. */
fmb_status fmb_lift_add_answer_of_graph(fmb_system *lift, const fmb_system *s,
                                        const fmb_system *graph);
/* Errors: ARG, MEMORY, LIMIT. */
fmb_status fmb_lift_image(fmb_system *lift, const fmb_system *s, const fmb_system *graph);
fmb_status fmb_lift_sum(fmb_system *lift, const fmb_system *const *s, size_t n);
/* None of the polyhedra is empty; `like` gives the names, even if n is 0. */
fmb_status fmb_lift_hull(fmb_system *lift, const fmb_system *like, const fmb_system *const *s,
                         size_t n);
/* Do s[0..n) keep variables of the same names? Errors are noted in lift. */
fmb_status fmb_lift_match(fmb_system *lift, const fmb_system *const *s, size_t n);

/* ---- for the other files of this room -------------------------------------------------------- */

/* Add variables named like those that s keeps, and mark them as kept. */
fmb_status fmb_lift_add_answer(fmb_system *lift, const fmb_system *s);
/* Add a variable called name, or name_k if k > 0, with underscores appended while that is taken. */
fmb_status fmb_lift_add_fresh(fmb_system *lift, const char *name, size_t k, int *index);
/* Add such a copy of each variable of s: variable j becomes copy[j]. */
fmb_status fmb_lift_add_copies(fmb_system *lift, const fmb_system *s, size_t k, int *copy);

/* Copies of the variables of several polyhedra. */
typedef struct fmb_lift_copies {
    const fmb_system *const *s; /* [n] */
    size_t n;
    int **var; /* [n][dim of s[i]] */
} fmb_lift_copies;

/* Add the answer, named like `like`, and copies of all variables of each polyhedron. The caller
 * must call fmb_lift_close_copies even after an error. */
fmb_status fmb_lift_open_copies(fmb_lift_copies *c, fmb_system *lift, const fmb_system *like,
                                const fmb_system *const *s, size_t n);
void fmb_lift_close_copies(fmb_lift_copies *c, fmb_system *lift);
/* Append the rows: each variable of the answer is the sum of its copies. */
fmb_status fmb_lift_append_sums(const fmb_lift_copies *c, fmb_system *lift);

#endif
