/* law.c: what laws share; see law.h. */
#include "property/scale/law.h"

#include <stdio.h>
#include <stdlib.h>

#include "property/scale/table.h"
#include "support/support.h"

const law_entry law_list[LAWS] = {
    {"systems", law_of_systems}, {"hulls", law_of_hulls},   {"pairs", law_of_pairs},
    {"nears", law_of_nears},     {"meshes", law_of_meshes}, {"sets", law_of_sets},
};

int law_draw(law_source *s, int lo, int hi)
{
    unsigned span = (unsigned)(hi - lo) + 1, value = 0;
    if (s->left == 0) {
        support_rng g = {s->state};
        int drawn = support_between(&g, lo, hi);
        s->state = g.state;
        return drawn;
    }
    for (unsigned reach = 1; reach < span && s->left > 0; reach <<= 8, s->left--)
        value = value << 8 | *s->byte++;
    return lo + (int)(value % span);
}

bool law_broken(char why[LAW_WHY], const char *what, int a, int b)
{
    snprintf(why, LAW_WHY, "%s: %d, scaled %d", what, a, b);
    return false;
}

void law_shift(mpq_t q, int power)
{
    if (power >= 0)
        mpq_mul_2exp(q, q, (mp_bitcnt_t)power);
    else
        mpq_div_2exp(q, q, (mp_bitcnt_t)-power);
}

/* ---- rows ------------------------------------------------------------------------------------ */

/* The rows of s with x_j = 2^power[j] y_j in place of its variables. */
static void take_rows(const fmb_system *s, const int *power, law_table *out)
{
    int dim = fmb_system_dim(s);
    mpq_t coef;
    mpq_init(coef);
    law_table_open(out, dim + 1);
    for (size_t i = 0; i < fmb_system_rows(s); i++) {
        fmb_rel rel = fmb_system_rel(s, i);
        mpq_t *row = law_table_append(out, rel == FMB_EQ ? LAW_SPANS : rel == FMB_LT ? 1 : 2);
        for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
            int j = fmb_system_term_q(s, i, k, coef);
            mpq_set(row[j], coef);
            law_shift(row[j], power ? power[j] : 0);
        }
        fmb_system_rhs_q(s, i, row[dim]);
    }
    mpq_clear(coef);
}

bool law_same_rows(const fmb_system *a, const fmb_system *b, const int *power)
{
    law_table rows[2];
    take_rows(a, power, &rows[0]);
    take_rows(b, NULL, &rows[1]);
    bool same = fmb_system_rows(a) == fmb_system_rows(b) && law_same_tables(&rows[0], &rows[1]);
    law_table_close(&rows[0]);
    law_table_close(&rows[1]);
    return same;
}
