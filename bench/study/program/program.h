/* program.h: linear programs by family, at any size, for measuring and for judging.
 *
 *   study_program_plan plan;
 *   study_program p;
 *   if (study_program_plan_parse("sparse-origin:5000x200", &plan, &which) && ...)
 *       study_program_draw(&plan, &p) ... study_program_clear(&p);
 *
 * The same plan gives the same program for ever, on every machine. Of many families the verdict is
 * known, as it was planted, and of some the best value of the objective. No GSL: tests ask here,
 * too.
 */
#ifndef FMB_STUDY_PROGRAM_H
#define FMB_STUDY_PROGRAM_H

#include <fmb/gmp.h>

/* rows x variables: what becomes of both is said in the table of program.c. */
typedef struct study_program_plan {
    int family; /* 0 <= family < study_program_families() */
    int rows, variables;
    uint64_t seed;
} study_program_plan;

typedef struct study_program {
    fmb_system *s;       /* with an objective, which is to be made large */
    fmb_verdict verdict; /* UNKNOWN where there was no plan */
    bool has_best;       /* the greatest value of the objective is known */
    mpq_t best;
} study_program;

/* The families, their names and what they are, a line each. */
int study_program_families(void);
const char *study_program_name(int family);
const char *study_program_about(int family);

/* "sparse-origin:5000x200": rows x variables; "sparse-origin" alone: a usual size. The seed is left
 * as it is. *bad gets what is wrong, static. */
bool study_program_plan_parse(const char *text, study_program_plan *out, const char **bad);
/* "sparse-origin:5000x200", in out[size]. */
void study_program_plan_text(const study_program_plan *plan, char *out, size_t size);

/* [give, study_program_clear] Errors: MEMORY. */
fmb_status study_program_draw(const study_program_plan *plan, study_program *out);
void study_program_clear(study_program *p);

/* ---- the same system in another dress -------------------------------------------------------- */

/* [give] The system and its objective in y, x_j = 10^power[j] y_j, its rows times powers of 10: all
 * of them between 10^-most and 10^most, at random. power[dim] may be NULL. Errors: MEMORY. */
fmb_status study_system_rescale(const fmb_system *s, int most, uint64_t seed, int *power,
                                fmb_system **out);
/* [give] Each number of the inequalities becomes p/q beside it, q of so many digits, at most 18;
 * equalities become multiples of themselves by such numbers: a system that looks the same in
 * doubles, and whose verdict can differ if it hangs by a thread. The objective stays. Errors:
 * MEMORY. */
fmb_status study_system_fractions(const fmb_system *s, int digits, uint64_t seed, fmb_system **out);

/* [give] Of the coefficients of each inequality so many of 100 stay, at random, and one at least;
 * equalities and the objective stay. Errors: MEMORY. */
fmb_status study_system_thin(const fmb_system *s, int percent, uint64_t seed, fmb_system **out);

#endif
