/* fmb/base.h: types and conventions that every other header uses.
 *
 * Four terms are kept apart: a *status* says whether a call worked, a *verdict* is the answer,
 * a *stop* says why a query ended, a *trust* how certain the answer is. Reaching a limit is a
 * result (fmb_stop), not an error (fmb_status).
 *
 * Ownership: only functions marked [give] hand out objects; each has one *_free, which accepts
 * NULL; the contents of a structure of the caller's are released by its *_clear. No function takes
 * ownership of an argument. Out arguments are untouched unless FMB_OK is returned. The *_trouble of
 * an object says in one line why it refused arguments (ARG).
 *
 * Texts: what a function *_write writes to a stream, its twin *_print writes to memory; what *_read
 * reads from a stream, *_parse (or *_from_text) reads from memory. Each *_print(..., text, size,
 * &length) sets length to the number of bytes, and writes these and a NUL only if size is larger:
 * so call it with NULL and 0, allocate length + 1 bytes, call it again. Functions for a number or a
 * line as text (*_text) return the length and write by the same rule. Streams are FILE of C.
 *
 * Structures that may grow begin with their size, as the program was compiled with it: settings
 * (fmb_options, fmb_pair_options, fmb_mesh_options, fmb_reader, fmb_patience), reports (fmb_result,
 * fmb_judgement, fmb_pair_counts, fmb_mesh_answer) and lists of arrays (fmb_pair_answers,
 * fmb_pair_answers_q, fmb_frame_arrays). Set it, and all else to 0, which is the default of every
 * setting:
 *
 *   fmb_options o = {.size = sizeof o, .max_seconds = 10};     (C)
 *   fmb_options o{}; o.size = sizeof o;                        (C++)
 *   o = ffi.new("fmb_options *", {"size": ffi.sizeof("fmb_options")})     (Python, cffi)
 *
 * Programs of an older version keep working: members that their structures lack are taken as 0, or
 * not reported. Those of a newer version work if the members unknown to this one are 0; otherwise,
 * and for a size that was never set, FMB_ERR_ARG. Structures that the library hands out by pointer
 * (events, lines, descriptions) may grow at their end; all other structures never change.
 *
 * Threads: const arguments may be shared; any other object belongs to one thread at a time. The
 * library keeps no globals, starts no threads unless asked to, prints nothing and never exits.
 */
#ifndef FMB_BASE_H
#define FMB_BASE_H

/* Other languages may read these headers: `cc -E -P -DFMB_DECLARATIONS_ONLY` turns <fmb/fmb.h> or
 * <fmb/geometry.h> into the declarations of libfmb alone, in plain C. They need bool, size_t, FILE,
 * int64_t and similar types, which readers of declarations know. */
#ifndef FMB_DECLARATIONS_ONLY
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#endif

#if defined(__GNUC__) && !defined(FMB_DECLARATIONS_ONLY)
#define FMB_API     __attribute__((visibility("default")))
#define FMB_CHECKED __attribute__((warn_unused_result))
#else
#define FMB_API
#define FMB_CHECKED
#endif

/* The version of these headers: "major.minor.patch", and one number to compare. Before 1.0 a new
 * minor version may change existing declarations. */
#define FMB_VERSION_MAJOR  0
#define FMB_VERSION_MINOR  3
#define FMB_VERSION_PATCH  0
#define FMB_VERSION        "0.3.0"
#define FMB_VERSION_NUMBER (FMB_VERSION_MAJOR * 10000 + FMB_VERSION_MINOR * 100 + FMB_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif

/* Did the call work? */
typedef enum fmb_status {
    FMB_OK = 0,
    FMB_ERR_ARG,    /* argument out of range, wrong shape, NaN or infinity */
    FMB_ERR_MEMORY, /* allocation failed; all objects stay valid and freeable */
    FMB_ERR_PARSE,  /* malformed text; position and reason in fmb_where */
    FMB_ERR_IO,     /* stream failed; errno holds the cause */
    FMB_ERR_RULE,   /* rule unknown, or unsound for this query or beside another rule */
    FMB_ERR_STATE,  /* not possible now: no query has finished, it kept no evidence, nothing is
                       loaded or pushed */
    FMB_ERR_RANGE   /* a number does not fit the requested type */
} fmb_status;

/* The answer. Zero is "unknown", so forgotten memory never reads as an answer. */
typedef enum fmb_verdict { FMB_UNKNOWN = 0, FMB_FEASIBLE, FMB_INFEASIBLE } fmb_verdict;

/* How the answer was obtained: at present always EXACT, or NONE if it is unknown. */
typedef enum fmb_trust { FMB_TRUST_NONE = 0, FMB_TRUST_FLOAT, FMB_TRUST_EXACT } fmb_trust;

/* Why a query ended. */
typedef enum fmb_stop {
    FMB_STOP_DONE = 0,
    FMB_STOP_TIME,     /* options.max_seconds passed */
    FMB_STOP_ROWS,     /* options.max_rows live rows exceeded */
    FMB_STOP_BYTES,    /* options.max_bytes exceeded */
    FMB_STOP_CANCELLED /* fmb_solver_cancel was called */
} fmb_stop;

/* Relation of a row a.x REL b. GE and GT are for adding rows only: the rows are stored, and handed
 * out, as -a.x LE -b and -a.x LT -b. */
typedef enum fmb_rel { FMB_LE = 0, FMB_LT, FMB_EQ, FMB_GE, FMB_GT } fmb_rel;
/* "<=", "<", "=", ">=", ">"; static; "?" if r is no relation. */
FMB_API const char *fmb_rel_text(fmb_rel r);

/* Which end of an interval. */
typedef enum fmb_side { FMB_LOWER = 0, FMB_UPPER } fmb_side;

/* Allocator; NULL wherever one is expected means malloc, realloc and free. resize(self, NULL, 0, n)
 * allocates, resize(self, p, n, 0) frees and returns NULL. Sizes are in bytes. The struct is
 * copied; self must outlive its users.
 *
 * When it fails, the call returns FMB_ERR_MEMORY. The limbs of GMP integers do not come from it but
 * from GMP's own allocator, and when that one fails, GMP ends the process, so no status can report
 * it. So options.max_bytes must be below the available memory. It counts the memory of rows,
 * evidence and results, limbs included, as soon as a step has made them. Not counted are the
 * numbers on which a single step works: a combined row, a point, a ray, the ends of a box; and the
 * input. Readers refuse text whose numbers would take far more memory than the text does. */
typedef struct fmb_alloc {
    void *(*resize)(void *self, void *p, size_t old_bytes, size_t new_bytes);
    void *self;
} fmb_alloc;

/* The place of an error in a text, and what was expected there. line and column start at 1 (column
 * counts bytes); 0 means the text as a whole. */
typedef struct fmb_where {
    long line, column;
    char text[160];
} fmb_where;

/* "NAME:LINE:COLUMN: TEXT" as a text (see above), without the unknown parts: NAME if it is NULL,
 * LINE and COLUMN if they are 0. If where is NULL, the length is 0 and nothing is written. */
FMB_API size_t fmb_where_text(const fmb_where *where, const char *name, char *text, size_t size);

/* The version of the library in use, as FMB_VERSION was when it was compiled; static. */
FMB_API const char *fmb_version(void);

/* One line in English for each status, verdict or stop; static, never NULL. Stops and verdicts are
 * the words of the JSON reports ("time", "feasible"). */
FMB_API const char *fmb_status_text(fmb_status st);
FMB_API const char *fmb_verdict_text(fmb_verdict v);
FMB_API const char *fmb_stop_text(fmb_stop s);

#ifdef __cplusplus
}
#endif
#endif
