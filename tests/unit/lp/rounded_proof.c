/* rounded_proof.c: combinations of rows prove what they imply, and nothing else: all small
 * multipliers, signs, relations and right sides, against the known sum of the two rows. */
#include <criterion/criterion.h>
#include <math.h>

#include "lp/redundancy/active_set/rounded_proof.h"

enum { COLUMNS = 2, PARTS = 2 };

/* Rows of two variables and their right sides; the first two are independent. */
typedef struct target {
    int64_t word[PARTS + 1][COLUMNS + 1];
    fmb_rel rel[PARTS + 1];
    int sixths[PARTS]; /* of the two, that add up to the coefficients of the last row */
    int slack;         /* its right side beyond theirs */
} target;

static const int SIXTHS[] = {-6, -3, 0, 2, 3, 6, 9};
enum { GUESSES = sizeof SIXTHS / sizeof *SIXTHS };

static void write_target(target *t)
{
    static const int64_t parts[PARTS][COLUMNS + 1] = {{12, -6, 24}, {-6, 18, 36}};
    for (size_t j = 0; j <= COLUMNS; j++) {
        t->word[PARTS][j] = j == COLUMNS ? t->slack : 0;
        for (size_t k = 0; k < PARTS; k++) {
            t->word[k][j] = parts[k][j];
            t->word[PARTS][j] += parts[k][j] / 6 * t->sixths[k];
        }
    }
}

static bool is_implied(const target *t, const int *sixths)
{
    bool strict = false;
    for (size_t k = 0; k < PARTS; k++) {
        if (sixths[k] != t->sixths[k] || (sixths[k] < 0 && t->rel[k] != FMB_EQ))
            return false;
        strict = strict || (sixths[k] > 0 && t->rel[k] == FMB_LT);
    }
    return t->slack > 0 || (t->slack == 0 && (strict || t->rel[PARTS] == FMB_LE));
}

/* Multipliers are off by a little, as those in doubles are. */
static bool prove_by(fmb_rounded_proof *c, target *t, const int *sixths)
{
    fmb_vec v[PARTS + 1];
    fmb_lp_row row[PARTS + 1];
    for (size_t i = 0; i <= PARTS; i++) {
        v[i] = (fmb_vec){.s = t->word[i]};
        fmb_vec_measure(&v[i], COLUMNS + 1);
        row[i] = (fmb_lp_row){&v[i], t->rel[i]};
    }
    fmb_rounded_proof_begin(c);
    for (size_t k = 0; k < PARTS; k++)
        cr_assert(fmb_rounded_proof_add(c, k, sixths[k] / 6.0 * (1 + 1e-11)));
    return fmb_rounded_proof_holds(c, COLUMNS, row, PARTS);
}

/* By all guesses; how many prove it? */
static int check_target(fmb_rounded_proof *c, target *t)
{
    int proofs = 0;
    write_target(t);
    for (int code = 0; code < GUESSES * GUESSES; code++) {
        const int sixths[PARTS] = {SIXTHS[code % GUESSES], SIXTHS[code / GUESSES]};
        bool proved = prove_by(c, t, sixths);
        cr_assert_eq(proved, is_implied(t, sixths), "%d, %d sixths for %d, %d; slack %d", sixths[0],
                     sixths[1], t->sixths[0], t->sixths[1], t->slack);
        proofs += proved;
    }
    return proofs;
}

Test(rounded, proves_what_is_implied_only)
{
    static const fmb_rel rels[] = {FMB_LE, FMB_LT, FMB_EQ};
    fmb_mem mem;
    fmb_rounded_proof c;
    int proofs = 0;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_rounded_proof_init(&c, &mem, PARTS), FMB_OK);
    for (int code = 0; code < GUESSES * GUESSES; code++)
        for (int rel = 0; rel < 18; rel++)
            for (int slack = -1; slack <= 1; slack++) {
                target t = {.rel = {rels[rel % 3], rels[rel / 3 % 3], rels[rel / 9]},
                            .sixths = {SIXTHS[code % GUESSES], SIXTHS[code / GUESSES]},
                            .slack = slack};
                proofs += check_target(&c, &t);
            }
    cr_expect_gt(proofs, 500);
    fmb_rounded_proof_clear(&c, &mem);
    cr_assert_eq(mem.used, 0);
}

Test(rounded, takes_short_fractions_only)
{
    fmb_mem mem;
    fmb_rounded_proof c;
    fmb_mem_init(&mem, NULL, 0);
    cr_assert_eq(fmb_rounded_proof_init(&c, &mem, 1), FMB_OK);
    const double others[] = {1 / 4097.0, -1 - 1 / 9001.0, 1e6, INFINITY, NAN};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
        fmb_rounded_proof_begin(&c);
        cr_expect(!fmb_rounded_proof_add(&c, 0, others[k]), "%g", others[k]);
    }
    fmb_rounded_proof_clear(&c, &mem);
}
