/* extreme.c: see extreme.h. */
#include "pair/extreme/extreme.h"

#include <string.h>

#include "frame/frame.h"
#include "pair/extreme/certify.h"
#include "pair/extreme/outward.h"
#include "pair/extreme/walk.h"

typedef struct boxer {
    fmb_extreme_program program;
    fmb_extreme_walk walk;
    fmb_extreme at;                  /* where the last end was found */
    double sum[FMB_EXTREME_COLUMNS]; /* of the vertices, for a witness */
    int vertices;
} boxer;

/* ---- ends ------------------------------------------------------------------------------------ */

/* At that basic solution; it counts among those whose mean is the witness. */
static bool stand_at_basis(boxer *b, const fmb_extreme_basis *basis)
{
    double z[FMB_EXTREME_COLUMNS];
    if (b->vertices > 0 && memcmp(basis, &b->at.basis, sizeof *basis) == 0)
        return true;
    if (!fmb_extreme_stand(&b->at, &b->program, basis))
        return false;
    fmb_extreme_near_values(&b->at, z);
    for (int j = 0; j < b->program.columns; j++)
        b->sum[j] = (b->vertices > 0 ? b->sum[j] : 0) + z[j];
    b->vertices++;
    return true;
}

static bool find_end(boxer *b, const fmb_extreme_goal *goal, double *out)
{
    fmb_wide numerator, denominator;
    int exponent = goal->is_world ? b->program.exponent[goal->number] : 0;
    if (!fmb_extreme_walk_to(&b->walk, goal) || !stand_at_basis(b, &b->walk.basis) ||
        !fmb_extreme_is_farthest(&b->at, goal))
        return false;
    fmb_extreme_value(&b->at, goal, &numerator, &denominator);
    return fmb_extreme_round_outward(&numerator, &denominator, exponent, goal->greatest, out);
}

/* Least ends, then greatest ones: neighbours are near each other. */
static bool find_ends(boxer *b, bool is_world, int first, int n, double *out)
{
    bool good = true;
    for (int side = 0; side < 2; side++)
        for (int i = 0; good && i < n; i++)
            good = find_end(b, &(fmb_extreme_goal){is_world, first + i, side == 1},
                            out + 2 * i + side);
    return good;
}

/* ---- the answer ------------------------------------------------------------------------------ */

/* Like those of fmb_pair_answers; the caller's are written only when all is known. */
typedef struct answer {
    double world[2 * FMB_EXTREME_DIM], inside[2 * FMB_EXTREME_DIM], time[2];
} answer;

static bool find_all_asked(boxer *b, const fmb_pair_answers *out, int naxes, answer *to)
{
    const fmb_extreme_program *s = &b->program;
    to->time[0] = 0;
    to->time[1] = 1;
    return (!out->world || find_ends(b, true, 0, s->dim, to->world)) &&
           (!out->inside || find_ends(b, false, s->first_of_b, naxes, to->inside)) &&
           (!out->time || s->time < 0 || find_ends(b, false, s->time, 1, to->time)) &&
           stand_at_basis(b, &b->walk.basis);
}

static void write_mean_of_extreme_points(const boxer *b, const fmb_frame *p, double *x)
{
    bool by_corners = fmb_frame_is_by_corners(p->shape);
    for (int i = 0; i < p->dim; i++) {
        x[i] = p->origin[i];
        for (int k = 0; k < p->naxes; k++) {
            double axis = p->axes[k * p->dim + i] - (by_corners ? p->origin[i] : 0);
            x[i] += b->sum[k] / b->vertices * axis;
        }
        if (p->speed)
            x[i] += b->sum[b->program.time] / b->vertices * p->speed[i];
    }
}

bool fmb_extreme_answer(const fmb_frame *p, const fmb_frame *q, const fmb_pair_answers *out)
{
    boxer b;
    answer found;
    b.vertices = 0;
    if (!fmb_extreme_load(&b.program, p, q) || !fmb_extreme_walk_start(&b.walk, &b.program) ||
        !find_all_asked(&b, out, q->naxes, &found))
        return false;
    if (out->world)
        memcpy(out->world, found.world, 2 * (size_t)p->dim * sizeof(double));
    if (out->inside)
        memcpy(out->inside, found.inside, 2 * (size_t)q->naxes * sizeof(double));
    if (out->time)
        memcpy(out->time, found.time, sizeof found.time);
    if (out->witness)
        write_mean_of_extreme_points(&b, p, out->witness);
    return true;
}
