/* packed_contacts.c: depths of pairs of frames of sets, by index. */
#include "pair/kernels/packed_kernels.h"
#include "pair/packed/packed.h"
#include "pair/pair_contact.h"

/* Pairs whose depths a kernel is asked in one call. */
enum { CONTACTS_OF_CALL = 64 };

typedef struct contacts_query {
    fmb_pair *k;
    const fmb_frames *a, *b;
    int kind_a, kind_b;   /* of the pairs before; -1 at first */
    fmb_packed_plan plan; /* of verdicts */
    fmb_flat_kind kind;   /* of depths */
    bool planned;         /* a kernel knows them */
} contacts_query;

/* One pair as frames. */
static fmb_status answer_contact_as_frames(const contacts_query *x, fmb_frames_pair pair,
                                           const fmb_pair_answers *out)
{
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    return fmb_contact_answer_all(x->k, 1, &p, &q, out);
}

/* Pair i of out, which meets, by a lane of an answer. */
static fmb_status write_contact(const contacts_query *x, fmb_frames_pair pair,
                                const fmb_contact_lanes *from, int lane, size_t i,
                                const fmb_pair_answers *out)
{
    fmb_pair_answers one = fmb_contact_answers_from(out, (size_t)x->k->dim, i);
    double normal[3];
    if (!(from->good >> lane & 1))
        return answer_contact_as_frames(x, pair, &one);
    for (int j = 0; j < x->k->dim; j++)
        normal[j] = from->normal[j][lane];
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    fmb_contact_write(&p, &q, from->depth[lane], normal, &one);
    if (one.distance)
        *one.distance = 0;
    return FMB_OK;
}

/* n pairs that meet, number[] of out. */
static fmb_status ask_contacts(const contacts_query *x, size_t n, const fmb_frames_pair *pair,
                               const size_t *number, const fmb_pair_answers *out)
{
    const fmb_pair_kernels *w = x->k->wide;
    fmb_contact_lanes lanes[CONTACTS_OF_CALL];
    fmb_packed_pairs packed = {.record = {x->a->record, x->b->record},
                               .index = {&pair->a, &pair->b},
                               .n = n,
                               .moves = x->plan.moves,
                               .kind = &x->kind};
    fmb_status st = FMB_OK;
    w->packed->contacts[x->k->dim - 2](&packed, lanes);
    for (size_t j = 0; st == FMB_OK && j < n; j++)
        st = write_contact(x, pair[j], &lanes[j / (size_t)w->width], (int)(j % (size_t)w->width),
                           number[j], out);
    return st;
}

/* Pair i of out, whose verdict is known; no depth is asked for. */
static fmb_status answer_without_depth(const contacts_query *x, fmb_frames_pair pair, size_t i,
                                       const fmb_pair_answers *out)
{
    fmb_pair_answers one = fmb_contact_answers_from(out, (size_t)x->k->dim, i);
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    if (*one.verdict == FMB_FEASIBLE && one.distance)
        *one.distance = 0;
    return *one.verdict == FMB_INFEASIBLE && fmb_contact_asks_distance(out)
               ? fmb_contact_answer_apart(x->k, &p, &q, NULL, &one)
               : FMB_OK;
}

/* n pairs of one kind that a kernel knows, from pair i of out on. Verdicts come first, which cost a
 * fraction; those that meet then fill blocks of their own. */
static fmb_status ask_contacts_of_kind(const contacts_query *x, size_t n,
                                       const fmb_frames_pair *pair, size_t i,
                                       const fmb_pair_answers *out)
{
    const int swap = x->plan.swapped;
    const fmb_frames *set[2] = {x->a, x->b};
    const uint32_t *index[2] = {&pair->a, &pair->b};
    fmb_packed_pairs packed = {.record = {set[swap]->record, set[!swap]->record},
                               .index = {index[swap], index[!swap]},
                               .n = n,
                               .moves = x->plan.moves,
                               .shapes = x->plan.shapes,
                               .kind = &x->plan.flat};
    fmb_frames_pair meeting[CONTACTS_OF_CALL];
    size_t number[CONTACTS_OF_CALL], found = 0;
    fmb_status st = FMB_OK;
    x->k->wide->packed->pairs[x->k->dim - 2](&packed, out->verdict + i);
    for (size_t j = 0; st == FMB_OK && j < n; j++) {
        if (out->verdict[i + j] == FMB_UNKNOWN) {
            fmb_pair_answers one = fmb_contact_answers_from(out, (size_t)x->k->dim, i + j);
            st = answer_contact_as_frames(x, pair[j], &one);
        } else if (out->verdict[i + j] == FMB_FEASIBLE && fmb_contact_asks_depth(out)) {
            meeting[found] = pair[j];
            number[found++] = i + j;
        } else {
            st = answer_without_depth(x, pair[j], i + j, out);
        }
        if (found == CONTACTS_OF_CALL) {
            st = ask_contacts(x, found, meeting, number, out);
            found = 0;
        }
    }
    return st == FMB_OK && found > 0 ? ask_contacts(x, found, meeting, number, out) : st;
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
    x->planned = x->k->dim <= 3 && !x->k->options.tightest &&
                 fmb_packed_plan_of(x->k, x->kind_a, x->kind_b, &x->plan);
    if (!x->planned)
        return;
    const int naxes[2] = {fmb_kind_naxes(x->k->dim, x->kind_a),
                          fmb_kind_naxes(x->k->dim, x->kind_b)};
    const bool simplex[2] = {fmb_kind_shape(x->kind_a), fmb_kind_shape(x->kind_b)};
    fmb_flat_kind_of(x->k->dim, x->plan.moves, naxes, simplex, &x->kind);
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
        while (i + run < n && has_kind(&x, pair[i + run]))
            run++;
        st = ask_contacts_of_kind(&x, run, pair + i, i, out);
    }
    return st;
}
