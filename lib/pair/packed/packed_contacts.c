/* packed_contacts.c: depths and distances of pairs of frames of sets, by index. */
#include "pair/kernels/packed_kernels.h"
#include "pair/packed/packed.h"
#include "pair/pair_contact.h"

/* Pairs in one call of a kernel. */
enum { CONTACTS_OF_CALL = 64 };

/* The pairs collected for a kernel, and their numbers in out. */
typedef struct contacts_waiting {
    size_t n, number[CONTACTS_OF_CALL];
    fmb_frames_pair pair[CONTACTS_OF_CALL];
} contacts_waiting;

typedef struct contacts_query {
    fmb_pair *k;
    const fmb_frames *a, *b;
    int kind_a, kind_b;   /* of the previous pairs; -1 at first */
    fmb_packed_plan plan; /* of verdicts */
    fmb_flat_kind kind;   /* of depths */
    bool planned;         /* there is a kernel for these kinds */
} contacts_query;

/* One pair as frames. */
static fmb_status answer_contact_as_frames(const contacts_query *x, fmb_frames_pair pair,
                                           const fmb_pair_answers *out)
{
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    return fmb_contact_answer_all(x->k, 1, &p, &q, out);
}

/* Write a length and a direction, if they are requested. */
static void write_length(int dim, const double *length,
                         const double (*normal)[FMB_BLOCK_MOST_LANES], int lane, size_t i,
                         double *to, const fmb_pair_answers *out)
{
    if (to)
        to[i] = length[lane];
    for (int j = 0; out->normal && j < dim; j++)
        out->normal[i * (size_t)dim + (size_t)j] = normal[j][lane];
}

/* Pair i of out, which meets, by a lane of an answer. */
static fmb_status write_contact(const contacts_query *x, fmb_frames_pair pair,
                                const fmb_contact_lanes *from, int lane, size_t i,
                                const fmb_pair_answers *out)
{
    bool good = from->good >> lane & 1;
    double normal[3];
    if (good && !out->faces && !out->points && !out->npoints) {
        write_length(x->k->dim, from->depth, from->normal, lane, i, out->depth, out);
        return FMB_OK;
    }
    fmb_pair_answers one = fmb_pair_answers_from(out, (size_t)x->k->dim, i);
    if (!good)
        return answer_contact_as_frames(x, pair, &one);
    for (int j = 0; j < x->k->dim; j++)
        normal[j] = from->normal[j][lane];
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    fmb_contact_write(&p, &q, from->depth[lane], normal, &one);
    return FMB_OK;
}

/* Pair i of out, which is apart. */
static fmb_status write_distance(const contacts_query *x, fmb_frames_pair pair,
                                 const fmb_distance_lanes *from, int lane, size_t i,
                                 const fmb_pair_answers *out)
{
    bool good = from->good >> lane & 1;
    if (good && !out->nearest && !out->offset) {
        write_length(x->k->dim, from->distance, from->normal, lane, i, out->distance, out);
        return FMB_OK;
    }
    fmb_pair_answers one = fmb_pair_answers_from(out, (size_t)x->k->dim, i);
    fmb_frame p = fmb_frames_at(x->a, pair.a), q = fmb_frames_at(x->b, pair.b);
    fmb_pair_near near;
    if (good)
        fmb_contact_read_distance(&p, &q, from, lane, out->offset != NULL, &near);
    return fmb_contact_answer_apart(x->k, &p, &q, good ? &near : NULL, &one);
}

/* Answer the collected pairs, which all meet, or else are all apart, by a kernel. */
static fmb_status ask_waiting(const contacts_query *x, bool meet, contacts_waiting *w,
                              const fmb_pair_answers *out)
{
    const fmb_pair_kernels *wide = x->k->wide;
    fmb_contact_lanes contacts[CONTACTS_OF_CALL];
    fmb_distance_lanes distances[CONTACTS_OF_CALL];
    fmb_packed_pairs packed = {.record = {x->a->record, x->b->record},
                               .index = {&w->pair->a, &w->pair->b},
                               .n = w->n,
                               .moves = x->plan.moves,
                               .kind = &x->kind};
    fmb_status st = FMB_OK;
    if (w->n > 0)
        wide->packed->lengths(&packed, meet ? contacts : NULL, distances);
    for (size_t j = 0; st == FMB_OK && j < w->n; j++) {
        size_t block = j / (size_t)wide->width;
        int lane = (int)(j % (size_t)wide->width);
        st = meet ? write_contact(x, w->pair[j], &contacts[block], lane, w->number[j], out)
                  : write_distance(x, w->pair[j], &distances[block], lane, w->number[j], out);
    }
    w->n = 0;
    return st;
}

/* Add pair i of out to the collected ones. */
static fmb_status wait_for_kernel(const contacts_query *x, bool meet, fmb_frames_pair pair,
                                  size_t i, contacts_waiting *w, const fmb_pair_answers *out)
{
    w->pair[w->n] = pair;
    w->number[w->n++] = i;
    return w->n == CONTACTS_OF_CALL ? ask_waiting(x, meet, w, out) : FMB_OK;
}

/* Answer pair i of out, whose verdict is known. */
static fmb_status answer_decided(const contacts_query *x, fmb_frames_pair pair, size_t i,
                                 contacts_waiting waiting[2], const fmb_pair_answers *out)
{
    fmb_verdict verdict = out->verdict[i];
    bool meet = verdict == FMB_FEASIBLE;
    if (verdict == FMB_UNKNOWN) {
        fmb_pair_answers one = fmb_pair_answers_from(out, (size_t)x->k->dim, i);
        return answer_contact_as_frames(x, pair, &one);
    }
    if (meet && out->distance)
        out->distance[i] = 0;
    bool more = meet ? fmb_contact_asks_depth(out) : fmb_contact_asks_distance(out);
    return more ? wait_for_kernel(x, meet, pair, i, &waiting[meet], out) : FMB_OK;
}

/* Answer n pairs of one kind that has a kernel, from pair i of out on. Verdicts come first, as they
 * are cheap; pairs that meet, and pairs that are apart, then fill separate blocks. */
static fmb_status ask_contacts_of_kind(const contacts_query *x, size_t n,
                                       const fmb_frames_pair *pair, size_t i,
                                       const fmb_pair_answers *out)
{
    const fmb_packed_pairs packed = fmb_packed_pairs_of(x->k, x->a, x->b, &x->plan, n, pair);
    contacts_waiting waiting[2];
    fmb_status st = FMB_OK;
    waiting[0].n = waiting[1].n = 0;
    x->k->wide->packed->pairs[x->k->dim - 2](&packed, out->verdict + i);
    for (size_t j = 0; st == FMB_OK && j < n; j++)
        st = answer_decided(x, pair[j], i + j, waiting, out);
    for (int meet = 0; st == FMB_OK && meet < 2; meet++)
        st = ask_waiting(x, meet, &waiting[meet], out);
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
            fmb_pair_answers one = fmb_pair_answers_from(out, (size_t)k->dim, i);
            st = answer_contact_as_frames(&x, pair[i], &one);
            continue;
        }
        while (i + run < n && has_kind(&x, pair[i + run]))
            run++;
        st = ask_contacts_of_kind(&x, run, pair + i, i, out);
    }
    return st;
}
