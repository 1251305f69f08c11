/* packed_contacts.c: depths of pairs of frames of sets, by index. */
#include "pair/kernels/packed_kernels.h"
#include "pair/packed/packed.h"
#include "pair/pair_contact.h"

/* Pairs that a kernel is asked about in one call. */
enum { CONTACTS_OF_CALL = 64 };

typedef struct contacts_query {
    fmb_pair *k;
    const fmb_frames *a, *b;
    int kind_a, kind_b; /* of the pairs before; -1 at first */
    fmb_packed_plan plan;
    bool planned; /* a kernel knows them */
} contacts_query;

/* One pair as frames. */
static fmb_status answer_contact_as_frames(const contacts_query *x, fmb_frames_pair pair,
                                           const fmb_pair_answers *out)
{
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    return fmb_contact_answer_all(x->k, 1, &p, &q, out);
}

/* The lane of pair i of out. */
static fmb_status write_contact(const contacts_query *x, fmb_frames_pair pair,
                                const fmb_contact_lanes *from, int lane, size_t i,
                                const fmb_pair_answers *out)
{
    const size_t dim = (size_t)x->k->dim;
    if (from->bits.apart >> lane & 1) {
        out->verdict[i] = FMB_INFEASIBLE;
        return FMB_OK;
    }
    if (!(from->bits.meet & from->good & 1U << lane)) {
        fmb_pair_answers one = fmb_contact_answers_from(out, dim, i);
        return answer_contact_as_frames(x, pair, &one);
    }
    out->verdict[i] = FMB_FEASIBLE;
    if (out->depth)
        out->depth[i] = from->depth[lane];
    for (size_t j = 0; out->normal && j < dim; j++)
        out->normal[dim * i + j] = from->normal[j][lane];
    return FMB_OK;
}

/* n pairs of one kind, CONTACTS_OF_CALL at most, that a kernel knows; the first is pair i of out.
 */
static fmb_status ask_contacts_of_kind(const contacts_query *x, size_t n,
                                       const fmb_frames_pair *pair, size_t i,
                                       const fmb_pair_answers *out)
{
    const fmb_pair_kernels *w = x->k->wide;
    fmb_contact_lanes lanes[CONTACTS_OF_CALL];
    fmb_packed_pairs packed = {.record = {x->a->record, x->b->record},
                               .index = {&pair->a, &pair->b},
                               .n = n,
                               .moves = x->plan.moves,
                               .kind = &x->plan.flat};
    fmb_status st = FMB_OK;
    w->packed->contacts[x->k->dim - 2](&packed, lanes);
    for (size_t j = 0; st == FMB_OK && j < n; j++)
        st = write_contact(x, pair[j], &lanes[j / (size_t)w->width], (int)(j % (size_t)w->width),
                           i + j, out);
    return st;
}

static bool has_kind(const contacts_query *x, fmb_frames_pair pair)
{
    return x->a->kind[pair.a] == x->kind_a && x->b->kind[pair.b] == x->kind_b;
}

static void plan_contacts(contacts_query *x, fmb_frames_pair pair)
{
    if (has_kind(x, pair))
        return;
    x->kind_a = x->a->kind[pair.a];
    x->kind_b = x->b->kind[pair.b];
    x->planned =
        !x->k->options.tightest && fmb_packed_plan_of(x->k, x->kind_a, x->kind_b, &x->plan);
    if (!x->planned)
        return;
    const int naxes[2] = {fmb_kind_naxes(x->k->dim, x->kind_a),
                          fmb_kind_naxes(x->k->dim, x->kind_b)};
    const bool simplex[2] = {fmb_kind_shape(x->kind_a), fmb_kind_shape(x->kind_b)};
    fmb_flat_kind_of(x->k->dim, x->plan.moves, naxes, simplex, &x->plan.flat);
}

fmb_status fmb_packed_contacts(fmb_pair *k, const fmb_frames *a, const fmb_frames *b, size_t n,
                               const fmb_frames_pair *pair, const fmb_pair_answers *out)
{
    contacts_query x = {.k = k, .a = a, .b = b, .kind_a = -1};
    fmb_status st = FMB_OK;
    for (size_t i = 0, run; st == FMB_OK && i < n; i += run) {
        run = 1;
        plan_contacts(&x, pair[i]);
        if (!x.planned || fmb_pair_answers_more(out)) {
            fmb_pair_answers one = fmb_contact_answers_from(out, (size_t)k->dim, i);
            st = answer_contact_as_frames(&x, pair[i], &one);
            continue;
        }
        while (run < CONTACTS_OF_CALL && i + run < n && has_kind(&x, pair[i + run]))
            run++;
        st = ask_contacts_of_kind(&x, run, pair + i, i, out);
    }
    return st;
}
