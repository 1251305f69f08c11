/* minors_of_frames.c: see minors_of_frames.h. */
#include "pair/minors_of_frames.h"

#include "pair/packed/inverse.h"

enum { MOST_LANES = FMB_BLOCK_MOST_LANES };

static bool has_all_edges(const fmb_frame *f, int dim)
{
    return f->dim == dim && f->naxes == dim && (unsigned)f->shape <= FMB_SIMPLEX && f->origin &&
           f->axes;
}

bool fmb_minors_of_frames_kind(const fmb_pair_call *a, size_t i, fmb_minors_what *out)
{
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    const int dim = a->k->dim;
    if (!a->k->room || !fmb_minors_of_frames_pay(dim, a->kernels->width) ||
        !has_all_edges(p, dim) || !has_all_edges(q, dim))
        return false;
    *out = fmb_minors_what_of(p->shape, q->shape, p->speed || q->speed);
    return fmb_minors_decide(dim, *out);
}

bool fmb_minors_of_frames_pay(int dim, int n)
{
    /* With doubles a pair takes 1.3 to 5 microseconds in four to seven dimensions; eight lanes with
     * their records take 2.6, 4.5, 8 and 24 (docs/experiments.md). */
    static const int LEAST[] = {2, 2, 4};
    const int known = (int)(sizeof LEAST / sizeof *LEAST);
    return dim - FMB_MINORS_LEAST_DIM < known && n >= LEAST[dim - FMB_MINORS_LEAST_DIM];
}

/* Make the records of n frames; returns bits of those that have one. */
static unsigned make_records(const fmb_pair_call *a, const fmb_frame *const *f, int n, double *to)
{
    const int dim = a->k->dim;
    double *record[MOST_LANES] = {0};
    for (int l = 0; l < n; l++) {
        record[l] = to + l * fmb_minors_record(dim);
        fmb_inverse_write_frame(f[l], record[l]);
    }
    const unsigned made = a->kernels->minors->invert(dim, record, (unsigned)n);
    for (int l = 0; l < n; l++)
        fmb_inverse_write_units(dim, record[l]);
    return made;
}

fmb_pair_bits fmb_minors_of_frames(const fmb_pair_call *a, fmb_minors_what what, const size_t *pair,
                                   int n, unsigned *made)
{
    static const uint32_t INDEX[2 * MOST_LANES] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7};
    double record[2][MOST_LANES * FMB_MINORS_MOST_RECORD];
    const fmb_frame *side[2][MOST_LANES];
    fmb_verdict is[MOST_LANES];
    for (int l = 0; l < n; l++) {
        const fmb_frame *p = &a->p[pair[l]], *q = &a->q[pair[l]];
        const bool swap = what >= FMB_MINORS_MIXED && p->shape == FMB_SIMPLEX;
        side[swap][l] = p;
        side[!swap][l] = q;
    }
    *made = make_records(a, side[0], n, record[0]) & make_records(a, side[1], n, record[1]);
    const fmb_packed_pairs pairs = {.record = {record[0], record[1]},
                                    .index = {INDEX, INDEX},
                                    .n = (size_t)n,
                                    .closed = a->k->options.contact == FMB_CONTACT_CLOSED};
    (void)a->kernels->minors->pairs(a->k->dim, what, &pairs, a->k->room, is);
    fmb_pair_bits bits = {0, 0};
    for (int l = 0; l < n; l++) {
        bits.apart |= (unsigned)(is[l] == FMB_INFEASIBLE) << l;
        bits.meet |= (unsigned)(is[l] == FMB_FEASIBLE) << l;
    }
    return (fmb_pair_bits){bits.apart & *made, bits.meet & *made};
}
