/* pair_contact.c: see pair_contact.h. */
#include "pair/pair_contact.h"

#include <math.h>
#include <stdio.h>

#include "pair/contact/bodies.h"
#include "pair/contact/contact_face.h"
#include "pair/corner_edges.h"
#include "pair/pair_portfolio.h"

/* The most pairs that are answered together. */
enum { CONTACTS_AT_ONCE = 64 };

typedef struct contact_query {
    fmb_pair *k;
    const fmb_frame *p, *q; /* of the current pairs */
    size_t n;
    bool distances, rows;                  /* requested for pairs that are apart */
    fmb_verdict verdict[CONTACTS_AT_ONCE]; /* UNKNOWN: to be asked */
    bool good[CONTACTS_AT_ONCE];           /* and this is known: */
    fmb_pair_near near[CONTACTS_AT_ONCE];
    fmb_flat_kind kind; /* of the block; dim 0 before the first */
    fmb_block block;
} contact_query;

/* ---- by kernels ------------------------------------------------------------------------------ */

void fmb_contact_read_distance(const fmb_frame *p, const fmb_frame *q,
                               const fmb_distance_lanes *from, int lane, bool row,
                               fmb_pair_near *out)
{
    out->length = from->distance[lane];
    for (int j = 0; j < p->dim; j++) {
        out->normal[j] = from->normal[j][lane];
        for (int side = 0; side < 2; side++) {
            const double *speed = side == 0 ? p->speed : q->speed;
            out->point[side][j] = p->origin[j] + from->point[side][j][lane] +
                                  (speed ? from->time[lane] * speed[j] : 0);
        }
    }
    out->has_row = row;
    if (row)
        out->offset = p->speed || q->speed
                          ? NAN
                          : fmb_contact_offset_between(p, out->normal, from->low[lane],
                                                       from->high[lane], from->reach[lane], 0);
}

static void read_lane(contact_query *x, const fmb_contact_lanes *from, int lane)
{
    size_t i = x->block.pair[lane];
    x->verdict[i] = from->bits.apart >> lane & 1  ? FMB_INFEASIBLE
                    : from->bits.meet >> lane & 1 ? FMB_FEASIBLE
                                                  : FMB_UNKNOWN;
    x->good[i] = x->verdict[i] == FMB_FEASIBLE && from->good >> lane & 1;
    x->near[i].length = from->depth[lane];
    for (int j = 0; j < x->k->dim; j++)
        x->near[i].normal[j] = from->normal[j][lane];
}

static void ask_block(contact_query *x)
{
    const fmb_pair_kernels *w = x->k->wide;
    fmb_block *b = &x->block;
    fmb_contact_lanes answer;
    fmb_distance_lanes far = {.good = 0};
    if (b->lanes == 0)
        return;
    for (int r = 0; b->lanes < w->width && r < FMB_BLOCK_MOST_ROWS; r++)
        for (int lane = b->lanes; lane < w->width; lane++)
            b->number[r * w->width + lane] = b->number[r * w->width];
    answer.good = 0;
    w->packed->contact(&x->kind, b->number, &answer);
    if (x->distances && answer.bits.apart & ((1U << b->lanes) - 1))
        w->packed->distance(&x->kind, b->number, &far);
    for (int lane = 0; lane < b->lanes; lane++) {
        size_t i = b->pair[lane];
        read_lane(x, &answer, lane);
        if (x->verdict[i] != FMB_INFEASIBLE || !(far.good >> lane & 1))
            continue;
        x->good[i] = true;
        fmb_contact_read_distance(&x->p[i], &x->q[i], &far, lane, x->rows, &x->near[i]);
    }
    b->lanes = 0;
}

/* The block holds pairs of one kind. */
static void prepare_block(contact_query *x, const fmb_frame *p, const fmb_frame *q)
{
    const int naxes[2] = {p->naxes, q->naxes};
    const bool simplex[2] = {p->shape, q->shape}, moves = p->speed || q->speed;
    const fmb_flat_kind *k = &x->kind;
    if (k->dim > 0 && k->moves == moves && k->side[0].naxes == naxes[0] &&
        k->side[1].naxes == naxes[1] && k->side[0].simplex == simplex[0] &&
        k->side[1].simplex == simplex[1])
        return;
    ask_block(x);
    fmb_flat_kind_of(x->k->dim, moves, naxes, simplex, &x->kind);
}

static void ask_kernels(contact_query *x)
{
    fmb_corner_edges p, q;
    for (size_t i = 0; i < x->n; i++) {
        x->verdict[i] = FMB_UNKNOWN;
        x->good[i] = false;
        if (x->k->options.method == FMB_PAIR_EXACT)
            continue;
        if (fmb_frame_is_hull(&x->p[i]) || fmb_frame_is_hull(&x->q[i])) {
            x->verdict[i] = fmb_contact_of_hulls(
                &x->p[i], &x->q[i], x->k->options.contact, &x->k->wide->packed->hulls,
                x->distances ? FMB_HULLS_DISTANCE : FMB_HULLS_DEPTH, &x->good[i], &x->near[i]);
        } else if (fmb_edges_of_frame(&x->p[i], &p) && fmb_edges_of_frame(&x->q[i], &q)) {
            prepare_block(x, &p.frame, &q.frame);
            fmb_block_put_flat(&x->block, x->k->wide->width, &p.frame, &q.frame, i);
            if (x->block.lanes == x->k->wide->width)
                ask_block(x);
        }
    }
    ask_block(x);
}

/* ---- what kernels leave ---------------------------------------------------------------------- */

void fmb_contact_write(const fmb_frame *p, const fmb_frame *q, double depth, const double *normal,
                       const fmb_pair_answers *out)
{
    uint8_t faces[2] = {0, 0};
    double points[3 * FMB_PAIR_MOST_POINTS];
    int n = 0;
    if (out->depth)
        *out->depth = depth;
    for (int j = 0; out->normal && j < p->dim; j++)
        out->normal[j] = normal[j];
    if (!out->faces && !out->points && !out->npoints)
        return;
    if (!p->speed && !q->speed)
        n = fmb_contact_face(p, q, normal, faces, points);
    for (int i = 0; out->faces && i < 2; i++)
        out->faces[i] = faces[i];
    for (int j = 0; out->points && j < n * p->dim; j++)
        out->points[j] = points[j];
    if (out->npoints)
        *out->npoints = (uint8_t)n;
}

/* Answer exactly, for a pair with a known verdict, what doubles could not. */
static fmb_status tell_exactly(fmb_pair *k, const fmb_frame *p, const fmb_frame *q,
                               fmb_verdict *verdict, fmb_pair_near *out)
{
    if (k->options.doubles_only) {
        *verdict = FMB_UNKNOWN;
        return FMB_OK;
    }
    k->counts.exact_boxes++;
    out->has_row = false;
    return fmb_pair_oracle_near(&k->oracle, p, q, verdict, out);
}

static bool asks_exact_contacts(const fmb_pair *k)
{
    return k->options.tightest || k->options.method == FMB_PAIR_EXACT;
}

fmb_status fmb_contact_answer_apart(fmb_pair *k, const fmb_frame *p, const fmb_frame *q,
                                    fmb_pair_near *near, const fmb_pair_answers *out)
{
    fmb_pair_near own;
    if (!near || asks_exact_contacts(k)) {
        near = &own;
        if (asks_exact_contacts(k) || !fmb_contact_distance(p, q, near))
            FMB_TRY(tell_exactly(k, p, q, out->verdict, near));
    }
    if (*out->verdict != FMB_INFEASIBLE)
        return FMB_OK;
    if (out->distance)
        *out->distance = near->length;
    for (int j = 0; j < k->dim; j++) {
        if (out->normal)
            out->normal[j] = near->normal[j];
        for (int side = 0; out->nearest && side < 2; side++)
            out->nearest[side * k->dim + j] = near->point[side][j];
    }
    if (out->offset)
        *out->offset = near->has_row ? near->offset : fmb_contact_offset(p, q, near->normal);
    return FMB_OK;
}

/* Answer the depth of pair i, which meets. */
static fmb_status answer_contact(contact_query *x, size_t i, const fmb_pair_answers *out)
{
    const fmb_frame *p = &x->p[i], *q = &x->q[i];
    fmb_pair_near *near = &x->near[i];
    if (fmb_contact_asks_depth(out) && (!x->good[i] || asks_exact_contacts(x->k)))
        FMB_TRY(tell_exactly(x->k, p, q, out->verdict, near));
    if (*out->verdict != FMB_FEASIBLE)
        return FMB_OK;
    if (fmb_contact_asks_depth(out))
        fmb_contact_write(p, q, near->length, near->normal, out);
    if (out->distance)
        *out->distance = 0;
    return FMB_OK;
}

static fmb_status answer_contact_of_pair(contact_query *x, size_t i, const fmb_pair_answers *out)
{
    bool more = fmb_pair_answers_more(out);
    *out->verdict = x->verdict[i];
    if (x->verdict[i] == FMB_UNKNOWN || (more && x->verdict[i] == FMB_FEASIBLE))
        FMB_TRY(fmb_pair_answer_all(x->k, 1, &x->p[i], &x->q[i], FMB_PAIR_GOOD, out));
    if (*out->verdict == FMB_FEASIBLE)
        FMB_TRY(answer_contact(x, i, out));
    else if (*out->verdict == FMB_INFEASIBLE && fmb_contact_asks_distance(out))
        FMB_TRY(fmb_contact_answer_apart(x->k, &x->p[i], &x->q[i], x->good[i] ? &x->near[i] : NULL,
                                         out));
    return FMB_OK;
}

/* Say what is wrong with pair i, number `number` of the call. */
static bool is_contact_refused(contact_query *x, size_t i, size_t number)
{
    fmb_pair *k = x->k;
    const fmb_frame *f[2] = {&x->p[i], &x->q[i]};
    char fault[FMB_FRAME_FAULT_SIZE];
    for (int side = 0; side < 2; side++) {
        if (fmb_frame_is_good(f[side], k->dim) && f[side]->naxes < FMB_BODY_MOST)
            continue;
        if (!fmb_frame_describe_fault(f[side], k->dim, fault, sizeof fault))
            snprintf(fault, sizeof fault, "%d axes are too many for a depth", f[side]->naxes);
        snprintf(k->error, sizeof k->error, "%c[%zu]: %s", "pq"[side], number, fault);
        return true;
    }
    return false;
}

fmb_status fmb_contact_answer_all(fmb_pair *k, size_t n, const fmb_frame *p, const fmb_frame *q,
                                  const fmb_pair_answers *out)
{
    contact_query x; /* not cleared, as it is large and there may be one pair */
    x.k = k;
    x.distances = fmb_contact_asks_distance(out);
    x.rows = out->offset != NULL;
    x.kind.dim = 0;
    x.block.lanes = 0;
    if (k->dim < 2 || k->dim > 3) {
        snprintf(k->error, sizeof k->error, "depths are told in 2 and 3 dimensions, not %d",
                 k->dim);
        return FMB_ERR_ARG;
    }
    for (size_t from = 0; from < n; from += CONTACTS_AT_ONCE) {
        x.p = p + from;
        x.q = q + from;
        x.n = n - from < CONTACTS_AT_ONCE ? n - from : CONTACTS_AT_ONCE;
        for (size_t i = 0; i < x.n; i++)
            if (is_contact_refused(&x, i, from + i))
                return FMB_ERR_ARG;
        if (!fmb_pair_is_cancelled(k))
            ask_kernels(&x);
        for (size_t i = 0; i < x.n; i++) {
            fmb_pair_answers some = fmb_pair_answers_from(out, (size_t)k->dim, from + i);
            *some.verdict = FMB_UNKNOWN;
            if (!fmb_pair_is_cancelled(k))
                FMB_TRY(answer_contact_of_pair(&x, i, &some));
        }
    }
    return FMB_OK;
}
