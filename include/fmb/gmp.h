/* fmb/gmp.h: the exact values behind the other headers; the only header that shows GMP. */
#ifndef FMB_GMP_H
#define FMB_GMP_H

#include <gmp.h>

#include <fmb/frame.h>
#include <fmb/io.h>
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

/* ---- pairs of frames from text (docs/formats.md, "frames") ----------------------------------- */

/* A frame; or, where rows is not NULL, the polytope of the points that its rows allow, static. */
typedef struct fmb_body {
    fmb_frame_q frame;      /* of a polytope: dim alone */
    const fmb_system *rows; /* over dim variables, or NULL */
} fmb_body;

/* One line: two bodies in one space. */
typedef struct fmb_frames_line {
    long number;    /* of the line, from 1 */
    const char *id; /* the value of its key "id", as JSON, or NULL */
    int dim;
    fmb_body body[2];   /* A and B; one whose speed is 0 is static */
    fmb_frame frame[2]; /* the same in doubles, each number the nearest ... */
    bool are_doubles;   /* ... and no other: both are frames of doubles. If not, frame[] may hold
                           no frames at all */
} fmb_frames_line;

/* A reader of such lines. */
typedef struct fmb_frames fmb_frames;

/* [give] Read from a stream, which stays the caller's; how may be NULL; its format does not count.
 * Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frames_open(FILE *in, const fmb_reader *how, fmb_frames **out);
FMB_API void fmb_frames_close(fmb_frames *r);
/* The next line that is not blank, or *out = NULL at the end. It belongs to the reader and is valid
 * until the next call. After PARSE (*where is filled, if not NULL) the next call goes on with the
 * next line. Errors: PARSE, IO, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frames_next(fmb_frames *r, const fmb_frames_line **out,
                                               fmb_where *where);

/* [give] The system that says where the bodies of a line meet: fmb_system_from_frames_q in
 * FMB_COORDINATES_ALL of those that are frames (c1_1 ... are those of the first of them), then the
 * rows of those that are polytopes; with open contact, their inequalities are strict. Errors:
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_from_line(const fmb_frames_line *line,
                                                    fmb_contact contact, const fmb_alloc *mem,
                                                    fmb_system **out);

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
