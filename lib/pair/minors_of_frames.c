/* minors_of_frames.c: see minors_of_frames.h. */
#include "pair/minors_of_frames.h"

#include "pair/kernels/inverse.h"

static bool has_all_edges(const fmb_frame *f, int dim)
{
    return f->dim == dim && f->naxes == dim && (unsigned)f->shape <= FMB_SIMPLEX && f->origin &&
           f->axes;
}

/* Measured (docs/experiments.md): the most dimensions in which kernels of a width are sooner than
 * doubles, one pair after another; and the fewest pairs from which on they are. */
static int most_dimensions(int width)
{
    return width > 2 ? 7 : 5;
}
static int fewest_pairs(int dim)
{
    static const int FEWEST[] = {2, 2, 4, 8};
    return FEWEST[dim - FMB_MINORS_LEAST_DIM];
}

bool fmb_minors_of_frames_pay(const fmb_pair_call *a, int n)
{
    return n >= fewest_pairs(a->k->dim);
}

bool fmb_minors_of_frames_kind(const fmb_pair_call *a, size_t i, fmb_minors_what *out)
{
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    const int dim = a->k->dim;
    if (!a->k->room || dim > most_dimensions(a->kernels->width) || !has_all_edges(p, dim) ||
        !has_all_edges(q, dim))
        return false;
    *out = fmb_minors_what_of(p->shape, q->shape, p->speed || q->speed);
    return fmb_minors_decide(dim, *out);
}

/* Make the records of n frames; returns bits of those that have one. */
static unsigned make_records(const fmb_pair_call *a, const fmb_frame *const *f, int n, double *to)
{
    const int dim = a->k->dim, width = a->kernels->width;
    unsigned made = 0;
    for (int i = 0; i < n; i += width) {
        double *record[FMB_BLOCK_MOST_LANES] = {0};
        const int some = n - i < width ? n - i : width;
        for (int l = 0; l < some; l++, to += fmb_minors_record(dim)) {
            record[l] = to;
            fmb_inverse_write_frame(f[i + l], to);
        }
        made |= a->kernels->minors->invert(dim, record, (unsigned)some) << i;
        for (int l = 0; l < some; l++)
            fmb_inverse_write_units(dim, record[l]);
    }
    return made;
}

/* Ask the kernel about the pairs of records with a bit in `made`. */
static fmb_pair_bits ask_kernel(const fmb_pair_call *a, fmb_minors_what what,
                                double *const record[2], unsigned made)
{
    uint32_t index[2 * FMB_MINOR_PAIRS];
    fmb_verdict is[FMB_MINOR_PAIRS];
    fmb_pair_bits bits = {0, 0};
    size_t n = 0;
    for (unsigned left = made; left; left &= left - 1)
        index[2 * n++] = (uint32_t)__builtin_ctz(left);
    const fmb_packed_pairs pairs = {.record = {record[0], record[1]},
                                    .index = {index, index},
                                    .n = n,
                                    .closed = a->k->options.contact == FMB_CONTACT_CLOSED};
    (void)a->kernels->minors->pairs(a->k->dim, what, &pairs, a->k->room, is);
    for (size_t l = 0; l < n; l++) {
        bits.apart |= (unsigned)(is[l] == FMB_INFEASIBLE) << index[2 * l];
        bits.meet |= (unsigned)(is[l] == FMB_FEASIBLE) << index[2 * l];
    }
    return bits;
}

fmb_pair_bits fmb_minors_of_frames(const fmb_pair_call *a, fmb_minors_what what, const size_t *pair,
                                   int n, unsigned *made)
{
    const fmb_pair *k = a->k;
    const fmb_frame *side[2][FMB_MINOR_PAIRS];
    double *const record[2] = {k->record, k->record + FMB_MINOR_PAIRS * fmb_minors_record(k->dim)};
    for (int l = 0; l < n; l++) {
        const fmb_frame *p = &a->p[pair[l]], *q = &a->q[pair[l]];
        const bool swap = what >= FMB_MINORS_MIXED && p->shape == FMB_SIMPLEX;
        side[swap][l] = p;
        side[!swap][l] = q;
    }
    *made = make_records(a, side[0], n, record[0]) & make_records(a, side[1], n, record[1]);
    return ask_kernel(a, what, record, *made);
}
