/* fmb/gmp.h: the exact values behind the other headers; the only header that shows GMP. */
#ifndef FMB_GMP_H
#define FMB_GMP_H

#include <gmp.h>

#include <fmb/frame.h>
#include <fmb/proof.h>
#include <fmb/rule.h>
#include <fmb/solve.h>
#include <fmb/system.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Append sum coef[k] x_var[k] REL b, n terms in any order; a variable that comes twice is added
 * up; coef is only read (ISO C cannot say so of an array type). Errors: ARG (variable out of
 * range), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_q(fmb_system *s, size_t n, const int *var,
                                                mpq_t *coef, fmb_rel rel, const mpq_t b);
/* Number of nonzero terms of row i; its k-th term by increasing variable; its right side. */
FMB_API size_t fmb_system_terms(const fmb_system *s, size_t i);
FMB_API int fmb_system_term_q(const fmb_system *s, size_t i, size_t k, mpq_t coef);
FMB_API void fmb_system_rhs_q(const fmb_system *s, size_t i, mpq_t b);

/* A frame (<fmb/frame.h>) in rationals, canonical ones; they are only read. */
typedef struct fmb_frame_q {
    fmb_shape shape;
    int dim, naxes;
    mpq_t *origin; /* [dim] */
    mpq_t *axes;   /* [naxes][dim], row i is edge i */
    mpq_t *speed;  /* [dim], or NULL: static */
} fmb_frame_q;

/* [give] fmb_system_from_frames for these. Errors: ARG (no frame, different dim, dependent axes),
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_from_frames_q(const fmb_frame_q *f, size_t n,
                                                        fmb_coordinates in, fmb_contact contact,
                                                        const fmb_alloc *mem, fmb_system **out);

/* Exact end of interval i of a box; false (and value untouched) unless it is finite or outer. */
FMB_API bool fmb_box_end_q(const fmb_box *b, int i, fmb_side side, mpq_t value);

/* Entry col of a row of a view; col = fmb_view_dim: the right side. And of a base row. */
FMB_API void fmb_view_get(const fmb_view *w, size_t row, int col, mpz_t out);
FMB_API void fmb_view_base_get(const fmb_view *w, size_t base, int col, mpz_t out);

/* Multiplier of row r in claim i; coordinate j of its point, of its ray; its value. All 0 where the
 * claim has none. */
FMB_API void fmb_evidence_multiplier_q(const fmb_evidence *e, size_t i, size_t r, mpq_t out);
FMB_API void fmb_evidence_coordinate_q(const fmb_evidence *e, size_t i, int j, mpq_t out);
FMB_API void fmb_evidence_ray_q(const fmb_evidence *e, size_t i, int j, mpq_t out);
FMB_API void fmb_evidence_value_q(const fmb_evidence *e, size_t i, mpq_t out);

#ifdef __cplusplus
}
#endif
#endif
