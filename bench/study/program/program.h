/* program.h: families of linear programs of any size, for benchmarks and tests.
 *
 *   study_program_plan plan;
 *   study_program p;
 *   if (study_program_plan_parse("sparse-origin:5000x200", &plan, &which) && ...)
 *       study_program_draw(&plan, &p) ... study_program_clear(&p);
 *
 * The same plan gives the same program for ever, on every machine. Many families have a planted
 * verdict, and some a known optimum of the objective. Needs no GSL: tests draw programs here, too.
 */
#ifndef FMB_STUDY_PROGRAM_H
#define FMB_STUDY_PROGRAM_H

#include <fmb/gmp.h>

/* rows x variables: the table of program.c says how a family uses both. */
typedef struct study_program_plan {
    int family; /* 0 <= family < study_program_families() */
    int rows, variables;
    uint64_t seed;
} study_program_plan;

typedef struct study_program {
    fmb_system *s;       /* with an objective, to be maximized */
    fmb_verdict verdict; /* UNKNOWN if none was planted */
    bool has_best;       /* the greatest value of the objective is known */
    mpq_t best;
} study_program;

/* The families: their number, names and descriptions of one line. */
int study_program_families(void);
const char *study_program_name(int family);
const char *study_program_about(int family);

/* "sparse-origin:5000x200": rows x variables; "sparse-origin" alone: the default size. Leaves the
 * seed unchanged. *bad is set to a static text about the error. */
bool study_program_plan_parse(const char *text, study_program_plan *out, const char **bad);
/* "sparse-origin:5000x200", in out[size]. */
void study_program_plan_text(const study_program_plan *plan, char *out, size_t size);

/* [give, study_program_clear] Errors: MEMORY. */
fmb_status study_program_draw(const study_program_plan *plan, study_program *out);
void study_program_clear(study_program *p);

/* ---- the same system in another dress -------------------------------------------------------- */

/* [give] The system and its objective in y, x_j = 10^power[j] y_j, its rows times powers of 10:
 * random powers between 10^-most and 10^most. power[dim] may be NULL. Errors: MEMORY. */
fmb_status study_system_rescale(const fmb_system *s, int most, uint64_t seed, int *power,
                                fmb_system **out);
/* [give] Each number of the inequalities becomes a fraction p/q near it, q of so many digits, at
 * most 18; equalities are multiplied by such fractions near 1: the system looks the same in
 * doubles, but its verdict may differ if it is nearly degenerate. The objective is unchanged.
 * Errors: MEMORY. */
fmb_status study_system_fractions(const fmb_system *s, int digits, uint64_t seed, fmb_system **out);

/* [give] Keeps that percentage of the coefficients of each inequality, at random, and at least one;
 * equalities and the objective are unchanged. Errors: MEMORY. */
fmb_status study_system_thin(const fmb_system *s, int percent, uint64_t seed, fmb_system **out);

#endif
