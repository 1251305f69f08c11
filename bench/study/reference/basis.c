/* basis.c: see basis.h. */
#include "study/reference/basis.h"

#include <math.h>

/* ---- solutions ------------------------------------------------------------------------------- */

/* Entry (i, j) of the program in doubles: M with slacks, and the row of the sum of each simplex,
 * which has nothing but 0 and 1. */
static void set_entry(mpz_t out, const study_proposer *w, const study_meeting *s, int i, int j)
{
    const fmb_general_system *g = &w->g->program;
    if (i >= s->dim)
        mpz_set_ui(out, g->m[j * g->rows + i] != 0);
    else if (j < s->columns)
        mpz_set(out, s->m[i][j]);
    else
        mpz_set_ui(out, 0);
}

/* Factor the columns of the pivots, if that was not done; false if they are dependent. */
static bool factor(study_proposer *w, const study_meeting *s)
{
    const fmb_general_system *g = &w->g->program;
    bool same = true;
    for (int k = 0; k < g->rows; k++)
        same &= w->factored[k] == g->pivot[k];
    for (int k = 0; !same && k < g->rows; k++) {
        for (int i = 0; i < g->rows; i++)
            set_entry(w->e.a[i][k], w, s, i, g->pivot[k]);
        w->factored[k] = g->pivot[k];
    }
    if (!same && !study_equations_factor(&w->e, g->rows))
        w->factored[0] = -1;
    return w->factored[0] >= 0;
}

/* The largest power of 2 that a unit of an unknown is divided by, if any is between its ends. */
static int bits_below_point(const study_proposer *w, const double *at)
{
    const fmb_general_system *g = &w->g->program;
    int most = 0;
    for (int j = 0; j < g->columns; j++)
        if (!g->is_pivot[j] && at[j] != 0 && at[j] != 1 && BITS + w->column_bits[j] > most)
            most = BITS + w->column_bits[j];
    return most;
}

bool study_basis_solve_point(study_proposer *w, const study_meeting *s, const double *at)
{
    const fmb_general_system *g = &w->g->program;
    const int bits = bits_below_point(w, at);
    mpz_t *entry = &w->scale;
    if (!factor(w, s))
        return false;
    for (int j = 0; j < g->columns; j++) {
        double whole = at[j] == 1 ? 1 : rint(ldexp(at[j], BITS));
        if (g->is_pivot[j])
            continue;
        mpz_set_d(w->z[j], isfinite(whole) ? whole : 0);
        if (whole != 0)
            mpz_mul_2exp(w->z[j], w->z[j],
                         (mp_bitcnt_t)(bits - (at[j] == 1 ? 0 : BITS + w->column_bits[j])));
    }
    for (int i = 0; i < g->rows; i++) {
        mpz_t *right = &w->e.x[i];
        mpz_set_ui(*right, 1);
        mpz_mul_2exp(*right, i < s->dim ? s->h[i] : *right, (mp_bitcnt_t)bits);
        for (int j = 0; j < g->columns; j++)
            if (!g->is_pivot[j] && mpz_sgn(w->z[j]) != 0) {
                set_entry(*entry, w, s, i, j);
                mpz_submul(*right, *entry, w->z[j]);
            }
    }
    study_equations_solve(&w->e);
    for (int j = 0; j < g->columns; j++)
        if (!g->is_pivot[j])
            mpz_mul(w->z[j], w->z[j], w->e.divisor);
    for (int k = 0; k < g->rows; k++)
        mpz_set(w->z[g->pivot[k]], w->e.x[k]);
    mpz_mul_2exp(w->scale, w->e.divisor, (mp_bitcnt_t)bits);
    return true;
}

bool study_basis_solve_prices(study_proposer *w, const study_meeting *s)
{
    if (!factor(w, s))
        return false;
    study_equations_solve_transposed(&w->e);
    for (int i = 0; i < s->dim; i++)
        mpz_set(w->y[i], w->e.x[i]);
    return true;
}

/* ---- steps in whole numbers ------------------------------------------------------------------ */

/* out_j := x times column j of the program, of those that are no pivots, x being what was solved
 * for last; 0 of pivots. */
static void multiply_by_columns(study_proposer *w, const study_meeting *s, mpz_t *out)
{
    const fmb_general_system *g = &w->g->program;
    for (int j = 0; j < g->columns; j++) {
        mpz_set_ui(out[j], 0);
        for (int i = 0; !g->is_pivot[j] && i < g->rows; i++) {
            if (i < s->dim && j < s->columns)
                mpz_addmul(out[j], s->m[i][j], w->e.x[i]);
            else if (i >= s->dim && g->m[j * g->rows + i] != 0)
                mpz_add(out[j], out[j], w->e.x[i]);
        }
    }
}

bool study_basis_solve_form(study_proposer *w, const study_meeting *s, const study_form *f)
{
    const fmb_general_system *g = &w->g->program;
    for (int k = 0; k < g->rows; k++)
        if (g->pivot[k] < s->columns)
            mpz_set(w->e.x[k], f->w[g->pivot[k]]);
        else
            mpz_set_ui(w->e.x[k], 0);
    return study_basis_solve_prices(w, s);
}

void study_basis_find_gains(study_proposer *w, const study_meeting *s, const study_form *f)
{
    if (f)
        multiply_by_columns(w, s, w->gain);
    for (int j = 0; j < w->g->program.columns; j++) {
        if (f)
            mpz_neg(w->gain[j], w->gain[j]);
        else
            mpz_set_ui(w->gain[j], 0);
        if (f && j < s->columns && !w->g->program.is_pivot[j])
            mpz_addmul(w->gain[j], f->w[j], w->e.divisor);
    }
}

int study_basis_place_outside(const study_proposer *w, bool *high)
{
    const fmb_general_system *g = &w->g->program;
    for (int k = 0; k < g->rows; k++) {
        int j = g->pivot[k];
        *high = g->kind[j] == FMB_GENERAL_UNIT && mpz_cmp(w->z[j], w->scale) > 0;
        if (*high || mpz_sgn(w->z[j]) < 0)
            return k;
    }
    return -1;
}

/* The column that comes in for one that goes out toward its high or its low end: of those that move
 * it there, the one whose gain over entry is the least. -1: none does. */
static int find_coming_column(study_proposer *w, bool high)
{
    const fmb_general_system *g = &w->g->program;
    int best = -1;
    for (int j = 0; j < g->columns; j++) {
        int sign = mpz_sgn(w->entry[j]) * (w->g->vertex[j] == 0 ? 1 : -1) * (high ? 1 : -1);
        if (g->is_pivot[j] || sign <= 0)
            continue;
        if (best >= 0) {
            mpz_mul(w->part, w->gain[j], w->entry[best]);
            mpz_mul(w->e.divisor, w->gain[best], w->entry[j]);
        }
        if (best < 0 || mpz_cmpabs(w->part, w->e.divisor) < 0)
            best = j;
    }
    return best;
}

/* Column `in` is a pivot in that place; what was there goes to an end. */
static void exchange(study_proposer *w, int place, int in, bool high)
{
    fmb_general_system *g = &w->g->program;
    int out = g->pivot[place];
    g->is_pivot[out] = false;
    g->is_pivot[in] = true;
    g->pivot[place] = in;
    w->g->vertex[out] = high;
}

bool study_basis_step_into_range(study_proposer *w, const study_meeting *s, int place, bool high)
{
    const fmb_general_system *g = &w->g->program;
    for (int k = 0; k < g->rows; k++)
        mpz_set_ui(w->e.x[k], k == place);
    if (!study_basis_solve_prices(w, s))
        return false;
    multiply_by_columns(w, s, w->entry);
    int in = find_coming_column(w, high);
    if (in < 0)
        return false;
    exchange(w, place, in, high);
    return true;
}

/* The first column that gains where it leaves its end, or -1. */
static int find_gaining_column(const study_proposer *w)
{
    const fmb_general_system *g = &w->g->program;
    for (int j = 0; j < g->columns; j++)
        if (!g->is_pivot[j] && mpz_sgn(w->gain[j]) == (w->g->vertex[j] == 0 ? 1 : -1))
            return j;
    return -1;
}

/* x / divisor: what each pivot falls by for each unit that the column rises. */
static bool solve_for_falls(study_proposer *w, const study_meeting *s, int column)
{
    const fmb_general_system *g = &w->g->program;
    if (!factor(w, s))
        return false;
    for (int i = 0; i < g->rows; i++)
        set_entry(w->e.x[i], w, s, i, column);
    study_equations_solve(&w->e);
    return true;
}

/* part := what the pivot in place k has left, in parts of scale, until it is at an end; *high: its
 * high one. False: it goes on for ever. */
static bool find_room(study_proposer *w, int k, bool rises, bool *high)
{
    int j = w->g->program.pivot[k];
    *high = rises;
    if (rises && w->g->program.kind[j] != FMB_GENERAL_UNIT)
        return false;
    if (rises)
        mpz_sub(w->part, w->scale, w->z[j]);
    else
        mpz_set(w->part, w->z[j]);
    return true;
}

/* The place of the pivot that is the first at an end, the least of equals by number, where column
 * `in` leaves its end; -1: it gets to its other end before; -2: nothing stops it. The way until
 * then is entry[0] / entry[1], in parts of scale and of 1 / divisor. */
static int find_blocking_place(study_proposer *w, int in, bool *high)
{
    const fmb_general_system *g = &w->g->program;
    int best = g->kind[in] == FMB_GENERAL_UNIT ? -1 : -2;
    bool end;
    mpz_set(w->entry[0], w->scale);
    mpz_set(w->entry[1], w->e.divisor);
    for (int k = 0; k < g->rows; k++) {
        int falls = mpz_sgn(w->e.x[k]) * (w->g->vertex[in] == 0 ? 1 : -1);
        if (falls == 0 || !find_room(w, k, falls < 0, &end))
            continue;
        mpz_mul(w->entry[2], w->part, w->entry[1]);
        mpz_mul(w->entry[3], w->entry[0], w->e.x[k]);
        int order = best == -2 ? -1 : mpz_cmpabs(w->entry[2], w->entry[3]);
        if (order > 0 || (order == 0 && (best < 0 || g->pivot[best] < g->pivot[k])))
            continue;
        mpz_set(w->entry[0], w->part);
        mpz_abs(w->entry[1], w->e.x[k]);
        best = k;
        *high = end;
    }
    return best;
}

/* Bland's rule (1977), which never comes back to a basis. */
bool study_basis_step_to_end(study_proposer *w, const study_meeting *s)
{
    bool high = false;
    int in = find_gaining_column(w);
    if (in < 0 || !solve_for_falls(w, s, in))
        return false;
    int place = find_blocking_place(w, in, &high);
    if (place == -1)
        w->g->vertex[in] = w->g->vertex[in] == 0;
    else if (place >= 0)
        exchange(w, place, in, high);
    return place > -2;
}
