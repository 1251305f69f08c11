/* fmb/options.h: the options of a solver, a structure passed by value, described by one table.
 *
 * The table is the source of range checks, `fmb --help` and the man page.
 */
#ifndef FMB_OPTIONS_H
#define FMB_OPTIONS_H

#include <fmb/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers in which rows are kept. */
typedef enum fmb_arith {
    FMB_ARITH_AUTO = 0, /* the best for the question; today the same as INT */
    FMB_ARITH_INT,      /* int64 rows, each widening to 128 bits and GMP when it must */
    FMB_ARITH_GMP       /* GMP rows from the start */
} fmb_arith;

/* How a question is answered. */
typedef enum fmb_method {
    FMB_METHOD_AUTO = 0, /* by size and question */
    FMB_METHOD_FM,       /* elimination only (fmb_project and fmb_reduce still ask the oracle) */
    FMB_METHOD_LP,       /* exact simplex only (fmb_project as with AUTO) */
    FMB_METHOD_HULL,     /* fmb_project by support queries; all else as with LP */
    FMB_METHOD_DD        /* fmb_project by double description; the others as with AUTO */
} fmb_method;

/* Which variable is eliminated next, if none is in an equality (it would be substituted) or has a
 * column of one sign (its rows would be dropped). */
typedef enum fmb_order {
    FMB_ORDER_PAIRS = 0, /* least p*q - p - q, with p and q rows of either sign */
    FMB_ORDER_GIVEN,     /* the least index */
    FMB_ORDER_MIN,       /* least min(p, q) */
    FMB_ORDER_FILL       /* least number of nonzeros in the combined rows, were there no overlap */
} fmb_order;

/* When a rule that drops rows for other reasons than histories may work beside a rule of histories:
 * histories must then start anew from the live rows (a re-base; see fmb/rule.h). */
typedef enum fmb_rebase {
    FMB_REBASE_AUTO = 0, /* when it drops so many rows that it pays */
    FMB_REBASE_ALWAYS,   /* whenever it drops a row */
    FMB_REBASE_NEVER     /* such a mix is refused: FMB_ERR_RULE */
} fmb_rebase;

/* Instructions for the inner loops. */
typedef enum fmb_simd {
    FMB_SIMD_AUTO = 0, /* the widest that the processor has */
    FMB_SIMD_PLAIN,    /* none: C */
    FMB_SIMD_AVX2,
    FMB_SIMD_AVX512 /* F, DQ and VPOPCNTDQ */
} fmb_simd;

/* Use of symmetries of a system: permutations of its variables, and of its rows, that leave the
 * system unchanged. */
typedef enum fmb_symmetries {
    FMB_SYMMETRY_AUTO = 0, /* support queries of fmb_project handle one facet per orbit of the given
                              symmetries (<fmb/symmetry.h>) */
    FMB_SYMMETRY_NONE
} fmb_symmetries;

/* Which claims are kept. Those of an answer may need much memory: a point for each end of a box. */
typedef enum fmb_evidence_kept {
    FMB_EVIDENCE_ALL = 0, /* all claims that prove the answer */
    FMB_EVIDENCE_NONE,
    FMB_EVIDENCE_VERDICT, /* why it is feasible or infeasible */
    FMB_EVIDENCE_WHOLE    /* all; and of a projection, that no row is missing, unless that takes too
                             long: points or directions for each vertex, ray and line */
} fmb_evidence_kept;

/* How to solve. All zeros but the size are the defaults. */
typedef struct fmb_options {
    size_t size; /* sizeof(fmb_options) */
    fmb_arith arith;
    fmb_method method;
    fmb_order order;
    const char *rules; /* comma list of pruning rules, "none", or NULL for the default; borrowed */
    fmb_rebase rebase;
    const char *presolve; /* comma list of steps, "none", or NULL for all; borrowed */
    fmb_simd simd;
    bool trace_rows;            /* report every row that is made to the sink */
    fmb_evidence_kept evidence; /* for fmb_solver_evidence */
    double max_seconds;         /* wall clock per query [s]; 0 = no limit */
    size_t max_rows;            /* live rows [rows]; 0 = no limit */
    size_t max_bytes;           /* the sum of workspace, evidence and results [bytes], limbs too
                                   (<fmb/base.h>); a reduced system counts from the start, as much
                                   as the whole one, and is handed out even so; 0 = no limit */
    size_t threads;             /* for the ends of a box, rows that may be redundant, rays, and two
                                   engines of a projection at once; 0 or 1: only the caller's. With
                                   more, the allocator (<fmb/base.h>) must be safe for threads.
                                   Answers are the same for any number; proofs may differ from those
                                   with one thread */
    fmb_symmetries symmetry;    /* use of given symmetries; answers do not depend on it */
} fmb_options;

/* Why fmb_solver_new refuses these options, in one line: "max_seconds is -1"; "" if it does not.
 * Returns the length (<fmb/base.h>, "Texts"). */
FMB_API size_t fmb_options_trouble(const fmb_options *o, char *text, size_t size);

/* Set one field by name from text ("max_seconds", "2.5"). Errors: ARG (unknown name, a value out of
 * range, or the structure is too small to have that field). Rule names are checked by
 * fmb_solver_new. */
FMB_API FMB_CHECKED fmb_status fmb_options_set(fmb_options *o, const char *name, const char *value);

/* One line of the table. */
typedef struct fmb_option_info {
    const char *name;    /* as fmb_options_set takes it; the command line writes '-' for '_' */
    const char *values;  /* "auto|int|gmp", or the unit of a number */
    const char *initial; /* the default, as text */
    const char *meaning; /* one sentence */
} fmb_option_info;

/* The i-th option, NULL past the end. */
FMB_API const fmb_option_info *fmb_options_describe(size_t i);

#ifdef __cplusplus
}
#endif
#endif
