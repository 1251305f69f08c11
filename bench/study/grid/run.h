/* run.h: the run of one way to eliminate on one system, and its numbers. */
#ifndef FMB_STUDY_RUN_H
#define FMB_STUDY_RUN_H

#include <fmb/rule.h>
#include <fmb/solve.h>

/* How to eliminate. */
typedef struct study_way {
    const char *name;             /* of the set of rules, in reports */
    const char *rules;            /* as options.rules takes them; or "fmplex", which decides but
                                   * does not project */
    const fmb_rule *const *added; /* more rules, NULL ends them; or NULL */
    fmb_order order;
    fmb_chooser chooser;  /* in its place, unless choose is NULL */
    const char *method;   /* as options.method takes it; NULL: elimination only */
    const char *evidence; /* as options.evidence takes it; NULL: the default */
} study_way;

typedef struct study_limits {
    size_t max_rows;      /* live rows: a limit that is the same on every machine */
    double max_seconds;   /* [s] a query; 0 = no limit */
    const char *presolve; /* as options.presolve takes it */
} study_limits;

/* Rules (and "constant") by name, in the order of their first use. */
enum { STUDY_MOST_NAMES = 32 };
typedef struct study_names {
    const char *name[STUDY_MOST_NAMES];
    size_t size;
} study_names;

typedef enum study_outcome {
    STUDY_NOT_RUN = 0,
    STUDY_DECIDED,
    STUDY_STOPPED, /* by a limit */
    STUDY_REFUSED, /* the rules do not apply, or not together */
    STUDY_WRONG    /* differs from the reference */
} study_outcome;

enum { STUDY_MOST_ROUNDS = 32 };

typedef struct study_run {
    /* Elimination of the variables that are not kept; of an infeasible system, of all. */
    study_outcome outcome;
    fmb_stop stop;
    fmb_verdict verdict;
    uint64_t pairs, made; /* pairs looked at, rows combined */
    uint64_t kept;        /* combined rows that survived the rules of their round */
    uint64_t lived;       /* rows alive after each round, added up over the rounds */
    uint64_t peak;        /* most rows alive before or after a round */
    uint64_t held;        /* most rows alive at any moment */
    uint64_t dropped[STUDY_MOST_NAMES];
    size_t rounds;                     /* of elimination by pairs */
    uint64_t alive[STUDY_MOST_ROUNDS]; /* rows alive after each of the first rounds */
    /* Elimination of all variables, for the verdict; or the same projection once more. */
    study_outcome solved;
    double seconds; /* of the thread [s]; of a stopped query, until its stop */
} study_run;

/* Both queries of one way. */
typedef struct study_engine {
    fmb_solver *counting, *timing;
    bool by_fmplex; /* timing runs FMplex, which has no counts */
    study_names *names;
    study_run *run; /* filled by the sink */
} study_engine;

/* Errors: RULE (a rule is unknown), ARG, MEMORY. If a chooser returns a column that was not
 * offered, both queries fail with ARG. */
fmb_status study_engine_open(study_engine *e, const study_way *way, const study_limits *limits,
                             study_names *names);
void study_engine_close(study_engine *e);

/* [give] Eliminate all but keep[0..n) and fill in the counts of the run; *projection is NULL unless
 * it was decided. With keep NULL: eliminate all variables, or until a row is false. */
fmb_status study_engine_count(study_engine *e, const fmb_system *s, const int *keep, int n,
                              study_run *run, fmb_system **projection);
/* Decide s, or project it on keep[0..n) unless keep is NULL, and fill in `solved` and `seconds`.
 * truth may be FMB_UNKNOWN. */
fmb_status study_engine_time(study_engine *e, const fmb_system *s, const int *keep, int n,
                             fmb_verdict truth, study_run *run);

#endif
