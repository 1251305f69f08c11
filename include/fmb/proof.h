/* fmb/proof.h: evidence, and the small independent program that judges it.
 *
 * The solver proposes, fmb_check disposes. Evidence is a list of claims about one system, each with
 * the exact numbers that prove it: a point, a ray, Farkas multipliers. docs/proof-format.md gives
 * the text form and the meaning of every claim; <fmb/gmp.h> the exact values.
 * Source: Schrijver, Theory of Linear and Integer Programming, 1986, section 7.3 (Farkas' lemma
 * with strict rows: Motzkin's transposition theorem, section 7.8).
 */
#ifndef FMB_PROOF_H
#define FMB_PROOF_H

#include <fmb/system.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A list of claims about a system, with the numbers that prove them. */
typedef struct fmb_evidence fmb_evidence;

/* What a claim says, and which numbers prove it. */
typedef enum fmb_claim_kind {
    FMB_CLAIM_NONE = 0,
    FMB_CLAIM_FEASIBLE,    /* point: satisfies every row */
    FMB_CLAIM_INFEASIBLE,  /* multipliers: their combination reads 0 <= negative, or 0 < 0 */
    FMB_CLAIM_BOUND,       /* of a variable, or of a linear form (fmb_evidence_term): side, value,
                              rel: multipliers prove it, point shows it tight */
    FMB_CLAIM_UNBOUNDED,   /* of a variable or a form: side, ray */
    FMB_CLAIM_IMPLIED,     /* an inequality (fmb_evidence_term): multipliers prove it */
    FMB_CLAIM_REDUNDANT,   /* row: follows from rows that no claim REDUNDANT names up to here */
    FMB_CLAIM_EQUALITY,    /* row: holds with equality everywhere: multipliers prove the reverse */
    FMB_CLAIM_IRREDUNDANT, /* row: point satisfies the other rows that stay, and not this one */
    FMB_CLAIM_CORNER,      /* point: satisfies every row, < read as <=; or ray: a direction */
    FMB_CLAIM_WHOLE,  /* variables (fmb_evidence_term): the projection on them is what the claims
                         IMPLIED say that name no others: corners span all of it; or, where the
                         claim has coordinates, variables of ascending ones are eliminated one after
                         another, and what is left is said by claims IMPLIED and FOLLOWS */
    FMB_CLAIM_FOLLOWS /* an inequality (fmb_evidence_term): follows from claims IMPLIED, whose
                         multipliers come by number of the claim */
} fmb_claim_kind;

/* NULL is fine. */
FMB_API void fmb_evidence_free(fmb_evidence *e);
/* Number of claims, and the kind of claim i. Where there is no claim i, or no number of it, here
 * and below: NONE, SIZE_MAX for a row, -1 for a variable, and 0. */
FMB_API size_t fmb_evidence_claims(const fmb_evidence *e);
FMB_API fmb_claim_kind fmb_evidence_kind(const fmb_evidence *e, size_t i);
/* The row a claim is about, or SIZE_MAX; the variable, or -1, of forms too. */
FMB_API size_t fmb_evidence_row(const fmb_evidence *e, size_t i);
FMB_API int fmb_evidence_var(const fmb_evidence *e, size_t i);
/* Of BOUND and UNBOUNDED: which end. Of BOUND: LE if the end is attained, LT if not; of IMPLIED:
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
/* The same numbers as exact text (<fmb/base.h>), "0" where there is none. */
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

/* How long to wait for a proof that is read or judged; by default for ever. */
typedef struct fmb_patience {
    size_t size;        /* sizeof(fmb_patience) */
    double max_seconds; /* wall clock [s]; 0: no limit */
    size_t max_bytes;   /* of the evidence, limbs too, and what a judge works with, but for the
                           numbers of one product or sum [bytes]; 0: no limit */
    /* Asked now and then: true gives up, as after a Ctrl-C. May be NULL. */
    bool (*give_up)(void *self);
    void *self;
} fmb_patience;

/* Why these limits are refused, as fmb_options_trouble tells of others. */
FMB_API size_t fmb_patience_trouble(const fmb_patience *p, char *text, size_t size);

/* [give] Read the text form. Names of variables are those of s. Errors: PARSE, IO, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_read(FILE *in, const fmb_system *s, fmb_evidence **out,
                                                 fmb_where *where);
/* [give] The same, but no longer than somebody waits: *stop says why it ended, and unless that is
 * DONE, *out is NULL. patience NULL: for ever. Errors: also ARG (a limit that is none). */
FMB_API FMB_CHECKED fmb_status fmb_evidence_read_within(FILE *in, const fmb_system *s,
                                                        const fmb_patience *patience,
                                                        fmb_evidence **out, fmb_stop *stop,
                                                        fmb_where *where);
/* [give] Both from size bytes of text. Errors: as above, also ARG (text NULL). */
FMB_API FMB_CHECKED fmb_status fmb_evidence_parse(const char *text, size_t size,
                                                  const fmb_system *s, fmb_evidence **out,
                                                  fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_evidence_parse_within(const char *text, size_t size,
                                                         const fmb_system *s,
                                                         const fmb_patience *patience,
                                                         fmb_evidence **out, fmb_stop *stop,
                                                         fmb_where *where);
/* Write the text form. Errors: ARG (also: s is not of the shape that e is about), RANGE (a number
 * is longer than a word of that form may be, 1,048,576 bytes), IO. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_write(const fmb_evidence *e, const fmb_system *s,
                                                  FILE *out);
/* The same to memory (<fmb/base.h>). Errors: ARG, RANGE, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_print(const fmb_evidence *e, const fmb_system *s,
                                                  char *text, size_t size, size_t *length);

/* What fmb_check found. */
typedef struct fmb_judgement {
    size_t size;         /* sizeof(fmb_judgement) */
    bool accepted;       /* every claim holds, and there is at least one */
    fmb_verdict verdict; /* what the accepted claims say of the system, UNKNOWN if nothing */
    fmb_stop stop;       /* DONE, or the limit at which the judge left off: not accepted then */
    size_t held;         /* claims that hold, of those that were judged */
    size_t claim;        /* first claim that fails, SIZE_MAX if none */
    bool relaxed;        /* the system has integer variables, and some claim that holds is about the
                            reals alone (docs/proof-format.md, "Integers") */
    char reason[160];    /* why it fails, or is not accepted */
} fmb_judgement;

/* Judge all claims of e about s in exact arithmetic. Shares no code with elimination or simplex.
 * Errors: ARG (e was made for another shape of system), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_check(const fmb_system *s, const fmb_evidence *e,
                                         fmb_judgement *out);
/* The same, but no longer than somebody waits; patience NULL: for ever. Errors: ARG (also a limit
 * that is none), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_check_within(const fmb_system *s, const fmb_evidence *e,
                                                const fmb_patience *patience, fmb_judgement *out);

/* Claim i in words on one line, without its proof: "max x = 5/2", "row 3 follows from rows that
 * stay". Errors: ARG, IO. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_tell(const fmb_evidence *e, const fmb_system *s,
                                                 size_t i, FILE *out);
/* The same to memory (<fmb/base.h>), with its line end. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_print_claim(const fmb_evidence *e, const fmb_system *s,
                                                        size_t i, char *text, size_t size,
                                                        size_t *length);

/* What a proof may be wanted for. */
typedef enum fmb_demand {
    FMB_DEMAND_NOTHING = 0,
    FMB_DEMAND_FEASIBLE, /* with a point that is integral where the system has integer variables */
    FMB_DEMAND_INFEASIBLE,
    FMB_DEMAND_BOUNDS,     /* both ends of every variable: BOUND or UNBOUNDED; or INFEASIBLE */
    FMB_DEMAND_REDUCED,    /* each inequality: REDUNDANT, EQUALITY or IRREDUNDANT */
    FMB_DEMAND_PROJECTION, /* each row of a projection, whose variables go by their names: IMPLIED,
                              up to a factor; or the system is INFEASIBLE */
    FMB_DEMAND_WHOLE,  /* the same, and no row is missing: WHOLE, and no other row is IMPLIED; the
                          projection asks for none itself, and where it has integer variables, it
                          has all of the system */
    FMB_DEMAND_OPTIMUM /* BOUND or UNBOUNDED for an objective, its constant left out: that of image,
                          whose variables go by their names, else that of the system, and where it
                          has none, any; over integers, if the system has some; or the system is
                          INFEASIBLE */
} fmb_demand;

/* Are there the claims of e that this takes? Whether they hold is for fmb_check to say. image is
 * the projection, or may carry the objective; else NULL. *meets; if not, why[size] says what is
 * missing; why may be NULL. Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_meets(const fmb_evidence *e, const fmb_system *s,
                                                  fmb_demand what, const fmb_system *image,
                                                  bool *meets, char *why, size_t size);
/* The same, but no longer than somebody waits: *stop says why it ended, and unless that is DONE,
 * *meets is false and why is untouched. patience NULL: for ever. Errors: ARG (also a limit that is
 * none), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_evidence_meets_within(const fmb_evidence *e, const fmb_system *s,
                                                         fmb_demand what, const fmb_system *image,
                                                         const fmb_patience *patience,
                                                         fmb_stop *stop, bool *meets, char *why,
                                                         size_t size);

#ifdef __cplusplus
}
#endif
#endif
