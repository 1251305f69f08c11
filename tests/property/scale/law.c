/* law.c: what laws share; see law.h. */
#include "property/scale/law.h"

#include <stdio.h>
#include <stdlib.h>

#include "support/support.h"

const law_entry law_list[LAWS] = {
    {"systems", law_of_systems}, {"hulls", law_of_hulls},   {"pairs", law_of_pairs},
    {"nears", law_of_nears},     {"meshes", law_of_meshes},
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

void law_must(fmb_status st)
{
    if (st != FMB_OK) {
        fprintf(stderr, "law: %s\n", fmb_status_text(st));
        abort();
    }
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

/* Coefficients and right side of row i in out[dim + 1], the first one that is not 0 being 1 or -1.
 */
static void normal_row(const fmb_system *s, size_t i, const int *power, mpq_t *out)
{
    int dim = fmb_system_dim(s);
    mpq_t by;
    mpq_init(by);
    for (int j = 0; j < dim; j++)
        mpq_set_ui(out[j], 0, 1);
    for (size_t k = 0; k < fmb_system_terms(s, i); k++) {
        int j = fmb_system_term_q(s, i, k, by);
        mpq_set(out[j], by);
        law_shift(out[j], power ? power[j] : 0);
    }
    fmb_system_rhs_q(s, i, out[dim]);
    int first = 0;
    while (first < dim && mpq_sgn(out[first]) == 0)
        first++;
    if (mpq_sgn(out[first]) != 0) {
        mpq_set(by, out[first]);
        if (fmb_system_rel(s, i) != FMB_EQ)
            mpq_abs(by, by);
        for (int j = 0; j <= dim; j++)
            mpq_div(out[j], out[j], by);
    }
    mpq_clear(by);
}

static mpq_t *new_numbers(int n)
{
    mpq_t *x = malloc((size_t)n * sizeof *x);
    for (int j = 0; x && j < n; j++)
        mpq_init(x[j]);
    if (!x)
        abort();
    return x;
}

static void free_numbers(mpq_t *x, int n)
{
    for (int j = 0; j < n; j++)
        mpq_clear(x[j]);
    free(x);
}

static bool has_row(const fmb_system *b, mpq_t *row, fmb_rel rel, mpq_t *room)
{
    int dim = fmb_system_dim(b);
    for (size_t i = 0; i < fmb_system_rows(b); i++) {
        int j = 0;
        normal_row(b, i, NULL, room);
        while (j <= dim && mpq_equal(row[j], room[j]))
            j++;
        if (j > dim && fmb_system_rel(b, i) == rel)
            return true;
    }
    return false;
}

bool law_same_rows(const fmb_system *a, const fmb_system *b, const int *power)
{
    int dim = fmb_system_dim(a);
    bool same = dim == fmb_system_dim(b) && fmb_system_rows(a) == fmb_system_rows(b);
    mpq_t *row = new_numbers(dim + 1), *room = new_numbers(dim + 1);
    for (size_t i = 0; same && i < fmb_system_rows(a); i++) {
        normal_row(a, i, power, row);
        same = has_row(b, row, fmb_system_rel(a, i), room);
    }
    free_numbers(row, dim + 1);
    free_numbers(room, dim + 1);
    return same;
}
