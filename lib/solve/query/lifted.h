/* lifted.h: the homogenized cone of a system: its rays are vertices and rays of the closure.
 */
#ifndef FMB_SOLVE_LIFTED_H
#define FMB_SOLVE_LIFTED_H

#include "dd/cone_rows.h"
#include "hull/image/image.h"
#include "solve/query/solver.h"
#include "system/system_private.h"

/* Row 0 is t >= 0, row 1 + i is row i of the system; strict rows are "wanted". */
typedef struct fmb_lifted {
    fmb_query *q;
    const fmb_system *s;
    size_t d;
    fmb_cone_rows rows;
    size_t *keep; /* [d] all coordinates */
    fmb_cone cone;
    fmb_image image; /* once the cone is complete: all its rays and lines */
} fmb_lifted;

/* z[d] becomes b t - a.x of a row a.x <= b, or t where r is NULL. */
void fmb_lifted_write_form(const fmb_sysrow *r, size_t d, mpz_t *z);

/* s outlives h. fmb_lifted_close it, even after an error. Errors: MEMORY, LIMIT, here and below. */
fmb_status fmb_lifted_open(fmb_lifted *h, fmb_query *q, const fmb_system *s);
void fmb_lifted_close(fmb_lifted *h);

/* Find the rays. *done false: there were more than `rays` intermediate rays (0: any number), and
 * the next call continues from there. */
fmb_status fmb_lifted_run(fmb_lifted *h, uint64_t rays, bool *done);

#endif
