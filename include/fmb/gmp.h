/* fmb/gmp.h: the exact values behind the other headers; the only header that shows GMP. */
#ifndef FMB_GMP_H
#define FMB_GMP_H

#include <gmp.h>

#include <fmb/frame.h>
#include <fmb/generators.h>
#include <fmb/io.h>
#include <fmb/pair.h>
#include <fmb/proof.h>
#include <fmb/proximity.h>
#include <fmb/rule.h>
#include <fmb/session.h>
#include <fmb/solve.h>
#include <fmb/system.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Append sum coef[k] x_var[k] REL b, n terms in any order; terms of the same variable are added
 * up; coef is only read (ISO C cannot express that for an array type). Rationals need not be in
 * lowest terms, nor their denominators positive. Errors: ARG (NULL, variable out of range,
 * denominator 0, bad relation), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_q(fmb_system *s, size_t n, const int *var,
                                                mpq_t *coef, fmb_rel rel, const mpq_t b);
/* Term k of row i by increasing variable (fmb_system_terms); its right side. Where there is no such
 * row or term: 0; the variable is then -1. */
FMB_API int fmb_system_term_q(const fmb_system *s, size_t i, size_t k, mpq_t coef);
FMB_API void fmb_system_rhs_q(const fmb_system *s, size_t i, mpq_t b);

/* An objective (<fmb/system.h>) in rationals; they are only read. */
typedef struct fmb_objective_q {
    fmb_sense sense;
    size_t n;            /* terms, in any order; a variable that comes twice is added up */
    const int *var;      /* [n] */
    mpq_t *coef;         /* [n] */
    mpq_srcptr constant; /* NULL: 0 */
} fmb_objective_q;

/* fmb_system_set_objective for these. Errors: ARG (also: variable out of range, denominator 0),
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_set_objective_q(fmb_system *s, const fmb_objective_q *o);
/* Term k of the objective by increasing variable; its constant. Where there is none: 0; the
 * variable is then -1. */
FMB_API int fmb_system_objective_term_q(const fmb_system *s, size_t k, mpq_t coef);
FMB_API void fmb_system_objective_constant_q(const fmb_system *s, mpq_t constant);

/* fmb_solver_add (<fmb/session.h>) for these, n terms in any order as in fmb_system_add_q; and
 * fmb_solver_set_right. Errors: ARG (as there, a denominator 0), STATE, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_solver_add_q(fmb_solver *v, size_t n, const int *var,
                                                mpq_t *coef, fmb_rel rel, const mpq_t b);
FMB_API FMB_CHECKED fmb_status fmb_solver_set_right_q(fmb_solver *v, size_t row, const mpq_t b);

/* fmb_generators_add (<fmb/generators.h>) of rationals x[dim]; they are only read. Errors: ARG
 * (also: denominator 0), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_generators_add_q(fmb_generators *g, fmb_generator_kind kind,
                                                    mpq_t *x);
/* Coordinate j of generator i; 0 where there is none. Those of rays and lines are integers. */
FMB_API void fmb_generators_coordinate_q(const fmb_generators *g, size_t i, int j, mpq_t out);

/* A frame (<fmb/frame.h>) in rationals; they are only read. */
typedef struct fmb_frame_q {
    fmb_shape shape;
    int dim, naxes;
    mpq_t *origin; /* [dim] */
    mpq_t *axes;   /* [naxes][dim], row i is edge i, or the corner at its end */
    mpq_t *speed;  /* [dim], or NULL: static */
} fmb_frame_q;

/* [give] fmb_system_from_frames for these. Errors: ARG (as there; a denominator 0),
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_from_frames_q(const fmb_frame_q *f, size_t n,
                                                        fmb_coordinates in, fmb_contact contact,
                                                        const fmb_alloc *mem, fmb_system **out);

/* <fmb/proximity.h> for two of these. Errors: ARG (as there; a denominator 0), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_distance_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm,
                                              fmb_proximity **out, fmb_result *res);
FMB_API FMB_CHECKED fmb_status fmb_depth_q(fmb_solver *v, const fmb_frame_q *f, fmb_norm norm,
                                           fmb_proximity **out, fmb_result *res);
FMB_API FMB_CHECKED fmb_status fmb_separate_q(fmb_solver *v, const fmb_frame_q *f,
                                              fmb_contact contact, fmb_system **out,
                                              fmb_result *res);
FMB_API bool fmb_separates_q(const fmb_frame_q *f, fmb_contact contact, const fmb_system *row);
FMB_API FMB_CHECKED fmb_status fmb_common_q(fmb_solver *v, const fmb_frame_q *f,
                                            fmb_generators **out, fmb_result *res);
/* The exact values: the length, but its square where the norm is Euclidean; and the rest. */
FMB_API void fmb_proximity_measure_q(const fmb_proximity *p, mpq_t out);
FMB_API void fmb_proximity_shift_q(const fmb_proximity *p, int j, mpq_t out);
FMB_API void fmb_proximity_point_q(const fmb_proximity *p, int which, int j, mpq_t out);
FMB_API void fmb_proximity_time_q(const fmb_proximity *p, mpq_t out);

/* The caller's arrays for exact answers about one pair: like fmb_pair_answers, in rationals, which
 * the caller has initialised. */
typedef struct fmb_pair_answers_q {
    size_t size;    /* sizeof(fmb_pair_answers_q) */
    mpq_t *world;   /* [dim][2] */
    mpq_t *inside;  /* [naxes of the second frame][2] */
    mpq_t *time;    /* [2]; not written if nothing moves */
    mpq_t *witness; /* [dim + naxes of the second frame], and one more if something moves: a common
                       point, its coordinates in the second frame, its time */
} fmb_pair_answers_q;

/* Do two closed frames meet? If so (FEASIBLE), all that out requests is filled in; each of its
 * arrays may be NULL. Takes microseconds, in up to eight dimensions; some ten times as long, with a
 * few megabytes of memory, if numbers have more than some 45 digits in three, 20 in eight
 * dimensions (when all numbers of a coordinate are over one denominator, less their common
 * divisor). UNKNOWN in more dimensions, without memory, for frames with more axes than dimensions,
 * and beyond some 1,500 digits in three, 640 in eight dimensions: then out is partly written; use
 * fmb_system_from_frames_q, fmb_solve and fmb_bound. Rationals are only read, and must be in lowest
 * terms. Errors: ARG (NULL, invalid frames, or of different dimensions). */
FMB_API FMB_CHECKED fmb_status fmb_pair_answer_q(const fmb_frame_q *p, const fmb_frame_q *q,
                                                 const fmb_pair_answers_q *out,
                                                 fmb_verdict *verdict);

/* ---- pairs of frames from text (docs/formats.md, "frames") ----------------------------------- */

/* A frame; or, if rows is not NULL, the static polytope of the points that satisfy the rows. */
typedef struct fmb_body {
    fmb_frame_q frame;      /* of a polytope: dim alone */
    const fmb_system *rows; /* over dim variables, or NULL */
} fmb_body;

/* One line: two bodies in one space. */
typedef struct fmb_frame_line {
    long number;    /* of the line, from 1 */
    const char *id; /* the value of its key "id", as JSON, or NULL */
    int dim;
    fmb_body body[2];   /* A and B; one whose speed is 0 is static */
    fmb_frame frame[2]; /* the same in doubles, each number the nearest ... */
    bool are_doubles;   /* ... and exactly so: both are frames of doubles. If not, frame[] may be
                           invalid */
} fmb_frame_line;

/* A reader of such lines. */
typedef struct fmb_frame_reader fmb_frame_reader;

/* [give] Read from a stream, which stays the caller's; how may be NULL; its format is ignored.
 * Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frame_reader_new(FILE *in, const fmb_reader *how,
                                                    fmb_frame_reader **out);
/* [give] Read from size bytes of text, which stay the caller's until the reader is freed. Errors:
 * ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frame_reader_from_text(const char *text, size_t size,
                                                          const fmb_reader *how,
                                                          fmb_frame_reader **out);
FMB_API void fmb_frame_reader_free(fmb_frame_reader *r);
/* The next line that is not blank, or *out = NULL at the end. It belongs to the reader and is valid
 * until the next call. After PARSE (*where is filled, if not NULL) the next call continues with the
 * next line. Errors: PARSE, IO, MEMORY, ARG (*where says which argument). */
FMB_API FMB_CHECKED fmb_status fmb_frame_reader_next(fmb_frame_reader *r,
                                                     const fmb_frame_line **out, fmb_where *where);
/* Fill body of the last line from its doubles. Binary pairs (docs/formats.md, "packed frames") and
 * those of a reader with nearest come without rationals: until then origin, axes and speed in body
 * are NULL. Does nothing to other lines. Errors: ARG (NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frame_reader_rationals(fmb_frame_reader *r);
/* Append pairs (p[i], q[i]) of one dimension in binary to out. Their numbers should be finite: the
 * reader refuses others. Errors: ARG, IO. */
FMB_API FMB_CHECKED fmb_status fmb_frame_pairs_write(FILE *out, size_t n, const fmb_frame *p,
                                                     const fmb_frame *q);
/* Write such pairs to memory (<fmb/base.h>); bytes may be NUL. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_frame_pairs_print(size_t n, const fmb_frame *p,
                                                     const fmb_frame *q, char *bytes, size_t size,
                                                     size_t *length);
/* From now on there is no next line, and the reading of a current one is given up. The one call
 * allowed from another thread or a signal handler. NULL is fine. */
FMB_API void fmb_frame_reader_cancel(fmb_frame_reader *r);

/* [give] The system of the common points of the bodies of a line: fmb_system_from_frames_q in
 * FMB_COORDINATES_ALL for the frames (c1_1 ... are coordinates of the first of them), then the rows
 * of the polytopes; with open contact, their inequalities are strict. Errors: MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_from_line(const fmb_frame_line *line, fmb_contact contact,
                                                    const fmb_alloc *mem, fmb_system **out);
/* [give] That system within the limits of v, whose allocator it uses: max_seconds and max_bytes
 * apply to making it, and a fmb_solver_cancel since v's last query began counts. *stop says which
 * limit ended it; then *out is NULL. For two frames, `in` may also be other coordinates. Errors:
 * ARG (also: other coordinates, and the bodies are not two frames, or have linearly dependent
 * axes), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_from_line_within(const fmb_frame_line *line,
                                                           fmb_coordinates in, fmb_contact contact,
                                                           fmb_solver *v, fmb_system **out,
                                                           fmb_stop *stop);

/* How numbers are written: put writes q, in lowest terms, to out. */
typedef struct fmb_number_style {
    void (*put)(void *self, mpq_srcptr q, FILE *out);
    void *self;
} fmb_number_style;

/* fmb_evidence_tell (<fmb/proof.h>) with numbers in that style, which is used during the call only.
 * Errors: ARG (also: style or its put NULL), IO. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_tell_with(const fmb_evidence *e, const fmb_system *s,
                                                      size_t i, const fmb_number_style *style,
                                                      FILE *out);

/* Exact end of interval i of a box; false (and value untouched) unless it is finite or outer, and
 * where there is no such interval. */
FMB_API bool fmb_box_end_q(const fmb_box *b, int i, fmb_side side, mpq_t value);

/* [give] fmb_optimize for an objective in rationals. Errors: ARG (also: variable out of range,
 * denominator 0), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_optimize_q(fmb_solver *v, const fmb_system *s,
                                              const fmb_objective_q *objective, fmb_optimum **out,
                                              fmb_result *res);
/* The exact value; false (and value untouched) unless it is finite or outer. The point and the ray.
 */
FMB_API bool fmb_optimum_value_q(const fmb_optimum *o, mpq_t value);
FMB_API void fmb_optimum_coordinate_q(const fmb_optimum *o, int j, mpq_t out);
FMB_API void fmb_optimum_ray_q(const fmb_optimum *o, int j, mpq_t out);

/* Coordinate j of the point of the last answer, multiplier k of its conflict (<fmb/solve.h>); 0
 * where there is none. */
FMB_API void fmb_solver_point_q(const fmb_solver *v, int j, mpq_t out);
FMB_API void fmb_solver_conflict_multiplier_q(const fmb_solver *v, size_t k, mpq_t out);

/* Entry col of a row of a view; col = fmb_view_dim: the right side. And of a base row. */
FMB_API void fmb_view_get(const fmb_view *w, size_t row, int col, mpz_t out);
FMB_API void fmb_view_base_get(const fmb_view *w, size_t base, int col, mpz_t out);

/* Multiplier of row r in claim i; coordinate j of its point, of its ray; its value. All 0 where the
 * claim has none, or is none. */
FMB_API void fmb_evidence_multiplier_q(const fmb_evidence *e, size_t i, size_t r, mpq_t out);
FMB_API void fmb_evidence_coordinate_q(const fmb_evidence *e, size_t i, int j, mpq_t out);
FMB_API void fmb_evidence_ray_q(const fmb_evidence *e, size_t i, int j, mpq_t out);
FMB_API void fmb_evidence_value_q(const fmb_evidence *e, size_t i, mpq_t out);
/* The k-th term of the form that it is about (fmb_evidence_terms), or -1 and 0. */
FMB_API int fmb_evidence_term_q(const fmb_evidence *e, size_t i, size_t k, mpq_t coef);

#ifdef __cplusplus
}
#endif
#endif
