/* fmb/proof.h: evidence, and the small independent checker that judges it.
 *
 * The solver makes claims, fmb_check checks them. Evidence is a list of claims about one system,
 * each with the exact numbers that prove it: a point, a ray, Farkas multipliers.
 * docs/proof-format.md gives the text form and the meaning of every claim; <fmb/gmp.h> exact
 * values. Source: Schrijver, Theory of Linear and Integer Programming, 1986, section 7.3 (Farkas'
 * lemma with strict rows: Motzkin's transposition theorem, section 7.8).
 */
#ifndef FMB_PROOF_H
#define FMB_PROOF_H

#include <fmb/system.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A list of claims about a system, with the numbers that prove them. */
typedef struct fmb_evidence fmb_evidence;

/* The kinds of claims, and the numbers that prove them. */
typedef enum fmb_claim_kind {
    FMB_CLAIM_NONE = 0,
    FMB_CLAIM_FEASIBLE,    /* point: satisfies every row */
    FMB_CLAIM_INFEASIBLE,  /* multipliers: their combination reads 0 <= negative, or 0 < 0 */
    FMB_CLAIM_BOUND,       /* of a variable, or of a linear form (fmb_evidence_term): side, value,
                              rel: multipliers prove it, point shows that it is tight */
    FMB_CLAIM_UNBOUNDED,   /* of a variable or a form: side, ray */
    FMB_CLAIM_IMPLIED,     /* an inequality (fmb_evidence_term): multipliers prove it */
    FMB_CLAIM_REDUNDANT,   /* row: follows from rows that no claim REDUNDANT names up to here */
    FMB_CLAIM_EQUALITY,    /* row: holds with equality everywhere: multipliers prove the reverse */
    FMB_CLAIM_IRREDUNDANT, /* row: point satisfies the other kept rows, and not this one */
    FMB_CLAIM_CORNER,      /* point: satisfies every row, < read as <=; or ray: a direction */
    FMB_CLAIM_WHOLE,  /* variables (fmb_evidence_term): the projection on them is described by the
                         claims IMPLIED that name no others: corners span all of it; or, if the
                         claim has coordinates, variables are eliminated in ascending order of
                         these, and claims IMPLIED and FOLLOWS imply each remaining row */
    FMB_CLAIM_FOLLOWS /* an inequality (fmb_evidence_term): follows from claims IMPLIED; its
                         multipliers are indexed by number of the claim */
} fmb_claim_kind;

/* NULL is fine. */
FMB_API void fmb_evidence_free(fmb_evidence *e);
/* Number of claims, and the kind of claim i. If there is no claim i, or it has no such number, here
 * and below: NONE, SIZE_MAX for a row, -1 for a variable, and 0. */
FMB_API size_t fmb_evidence_claims(const fmb_evidence *e);
FMB_API fmb_claim_kind fmb_evidence_kind(const fmb_evidence *e, size_t i);
/* The row a claim is about, or SIZE_MAX; the variable, or -1, also for linear forms. */
FMB_API size_t fmb_evidence_row(const fmb_evidence *e, size_t i);
FMB_API int fmb_evidence_var(const fmb_evidence *e, size_t i);
/* For BOUND and UNBOUNDED: which end. For BOUND: LE if the end is attained, LT if not; for IMPLIED:
 * the relation. */
FMB_API fmb_side fmb_evidence_side(const fmb_evidence *e, size_t i);
FMB_API fmb_rel fmb_evidence_rel(const fmb_evidence *e, size_t i);

/* The multiplier of row r in claim i (0 if absent), coordinate j of its point and of its ray, and
 * its value, all as the nearest double (0 where the claim has none). */
FMB_API double fmb_evidence_multiplier(const fmb_evidence *e, size_t i, size_t r);
FMB_API double fmb_evidence_coordinate(const fmb_evidence *e, size_t i, int j);
FMB_API double fmb_evidence_ray(const fmb_evidence *e, size_t i, int j);
FMB_API double fmb_evidence_value(const fmb_evidence *e, size_t i);
/* Number of terms of the linear form that a claim IMPLIED, BOUND or UNBOUNDED is about, unless it
 * is one variable (fmb_evidence_var), and of the variables of a claim WHOLE; the variable of the
 * k-th, or -1, with its coefficient as the nearest double, or 0, in *coef, which may be NULL. */
FMB_API size_t fmb_evidence_terms(const fmb_evidence *e, size_t i);
FMB_API int fmb_evidence_term(const fmb_evidence *e, size_t i, size_t k, double *coef);
/* These numbers as exact text (<fmb/base.h>), "0" if there is none. */
FMB_API size_t fmb_evidence_multiplier_text(const fmb_evidence *e, size_t i, size_t r, char *text,
                                            size_t size);
FMB_API size_t fmb_evidence_coordinate_text(const fmb_evidence *e, size_t i, int j, char *text,
                                            size_t size);
FMB_API size_t fmb_evidence_ray_text(const fmb_evidence *e, size_t i, int j, char *text,
                                     size_t size);
FMB_API size_t fmb_evidence_value_text(const fmb_evidence *e, size_t i, char *text, size_t size);
FMB_API size_t fmb_evidence_term_text(const fmb_evidence *e, size_t i, size_t k, char *text,
                                      size_t size);
/* The first row from r on whose multiplier in claim i is not 0, SIZE_MAX if there is none. */
FMB_API size_t fmb_evidence_next_row(const fmb_evidence *e, size_t i, size_t r);

/* Limits for reading or judging a proof; by default none. */
typedef struct fmb_patience {
    size_t size;        /* sizeof(fmb_patience) */
    double max_seconds; /* wall clock [s]; 0: no limit */
    size_t max_bytes;   /* of the evidence, limbs too, and the workspace of the checker, except the
                           numbers of one product or sum [bytes]; 0: no limit */
    /* Called now and then: true gives up, as after a Ctrl-C. May be NULL. */
    bool (*give_up)(void *self);
    void *self;
} fmb_patience;

/* Why these limits are refused, like fmb_options_trouble. */
FMB_API size_t fmb_patience_trouble(const fmb_patience *p, char *text, size_t size);

/* [give] Read the text form. Names of variables are those of s. Errors: PARSE, IO, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_read(FILE *in, const fmb_system *s, fmb_evidence **out,
                                                 fmb_where *where);
/* [give] fmb_evidence_read within limits: *stop says why it ended, and unless that is DONE, *out is
 * NULL. patience NULL: no limits. Errors: also ARG (an invalid limit). */
FMB_API FMB_CHECKED fmb_status fmb_evidence_read_within(FILE *in, const fmb_system *s,
                                                        const fmb_patience *patience,
                                                        fmb_evidence **out, fmb_stop *stop,
                                                        fmb_where *where);
/* [give] These two for size bytes of text. Errors: as above, also ARG (text NULL). */
FMB_API FMB_CHECKED fmb_status fmb_evidence_parse(const char *text, size_t size,
                                                  const fmb_system *s, fmb_evidence **out,
                                                  fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_evidence_parse_within(const char *text, size_t size,
                                                         const fmb_system *s,
                                                         const fmb_patience *patience,
                                                         fmb_evidence **out, fmb_stop *stop,
                                                         fmb_where *where);
/* Write the text form. Errors: ARG (also: s has another number of rows or variables than the system
 * of e), RANGE (a number is longer than a word of that form may be, 1,048,576 bytes), IO. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_write(const fmb_evidence *e, const fmb_system *s,
                                                  FILE *out);
/* Write the text form to memory (<fmb/base.h>). Errors: ARG, RANGE, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_print(const fmb_evidence *e, const fmb_system *s,
                                                  char *text, size_t size, size_t *length);

/* The result of fmb_check. */
typedef struct fmb_judgement {
    size_t size;         /* sizeof(fmb_judgement) */
    bool accepted;       /* every claim holds, and there is at least one */
    fmb_verdict verdict; /* what the accepted claims prove of the system, UNKNOWN if nothing */
    fmb_stop stop;       /* DONE, or the limit at which the checker stopped: not accepted then */
    size_t held;         /* claims that hold, of those that were judged */
    size_t claim;        /* first claim that fails, SIZE_MAX if none */
    bool relaxed;        /* the system has integer variables, and some claim that holds is about the
                            reals alone (docs/proof-format.md, "Integers") */
    char reason[160];    /* why it fails, or is not accepted */
} fmb_judgement;

/* Judge all claims of e about s in exact arithmetic. Shares no code with elimination or simplex.
 * Errors: ARG (e is about a system with other numbers of rows or variables), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_check(const fmb_system *s, const fmb_evidence *e,
                                         fmb_judgement *out);
/* fmb_check within limits; patience NULL: none. Errors: ARG (also an invalid limit), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_check_within(const fmb_system *s, const fmb_evidence *e,
                                                const fmb_patience *patience, fmb_judgement *out);

/* Claim i in words on one line, without its proof: "max x = 5/2", "row 3 follows from rows that
 * stay". Errors: ARG, IO. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_tell(const fmb_evidence *e, const fmb_system *s,
                                                 size_t i, FILE *out);
/* Claim i in words to memory (<fmb/base.h>), with its line end. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_print_claim(const fmb_evidence *e, const fmb_system *s,
                                                        size_t i, char *text, size_t size,
                                                        size_t *length);

/* What a proof may be required to prove. */
typedef enum fmb_demand {
    FMB_DEMAND_NOTHING = 0,
    FMB_DEMAND_FEASIBLE, /* with a point that is integral in the integer variables of the system */
    FMB_DEMAND_INFEASIBLE,
    FMB_DEMAND_BOUNDS,     /* both ends of every variable: BOUND or UNBOUNDED; or INFEASIBLE */
    FMB_DEMAND_REDUCED,    /* each inequality: REDUNDANT, EQUALITY or IRREDUNDANT */
    FMB_DEMAND_PROJECTION, /* each row of a projection, whose variables are matched by name:
                              IMPLIED, up to a factor; or the system is INFEASIBLE */
    FMB_DEMAND_WHOLE,  /* PROJECTION, and no row is missing: WHOLE, and no other row is IMPLIED; the
                          projection marks no kept variables itself, and if it has integer
                          variables, it has all variables of the system */
    FMB_DEMAND_OPTIMUM /* BOUND or UNBOUNDED for an objective without its constant: that of image,
                          whose variables are matched by name, else that of the system, and if there
                          is none, any; over integers, if the system has some; or the system is
                          INFEASIBLE */
} fmb_demand;

/* Has e the claims that `what` requires? Whether they hold is decided by fmb_check. image is the
 * projection, or may carry the objective; else NULL. *meets; if not, why[size] says what is
 * missing; why may be NULL. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_meets(const fmb_evidence *e, const fmb_system *s,
                                                  fmb_demand what, const fmb_system *image,
                                                  bool *meets, char *why, size_t size);
/* fmb_evidence_meets within limits: *stop says why it ended, and unless that is DONE, *meets is
 * false and why is untouched. patience NULL: no limits. Errors: ARG (also an invalid limit),
 * MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_meets_within(const fmb_evidence *e, const fmb_system *s,
                                                         fmb_demand what, const fmb_system *image,
                                                         const fmb_patience *patience,
                                                         fmb_stop *stop, bool *meets, char *why,
                                                         size_t size);

#ifdef __cplusplus
}
#endif
#endif
