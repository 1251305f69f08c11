/* single_pair.c: see single_pair.h. */
#include "pair/single_pair.h"

#include <stdio.h>

#include "base/ways.h"
#include "pair/contact/contact_near.h"
#include "pair/corners/cell.h"
#include "pair/kernels/packed_kernels.h"

fmb_status fmb_single_pair_refuse(const fmb_pair_call *a, size_t i)
{
    fmb_pair *k = a->k;
    char fault[FMB_FRAME_FAULT_SIZE];
    bool first = fmb_frame_describe_fault(&a->p[i], k->dim, fault, sizeof fault);
    if (first || fmb_frame_describe_fault(&a->q[i], k->dim, fault, sizeof fault))
        snprintf(k->error, sizeof k->error, "%c[%zu]: %s", first ? 'p' : 'q', i, fault);
    return FMB_ERR_ARG;
}

/* ---- boxes ----------------------------------------------------------------------------------- */

fmb_pair_answers fmb_pair_answers_from(const fmb_pair_answers *o, size_t dim, size_t i)
{
    return (fmb_pair_answers){.size = sizeof(fmb_pair_answers),
                              .verdict = o->verdict + i,
                              .world = o->world ? o->world + 2 * dim * i : NULL,
                              .inside = o->inside ? o->inside + 2 * dim * i : NULL,
                              .time = o->time ? o->time + 2 * i : NULL,
                              .witness = o->witness ? o->witness + dim * i : NULL,
                              .depth = o->depth ? o->depth + i : NULL,
                              .normal = o->normal ? o->normal + dim * i : NULL,
                              .faces = o->faces ? o->faces + 2 * i : NULL,
                              .points =
                                  o->points ? o->points + FMB_PAIR_MOST_POINTS * dim * i : NULL,
                              .npoints = o->npoints ? o->npoints + i : NULL,
                              .distance = o->distance ? o->distance + i : NULL,
                              .nearest = o->nearest ? o->nearest + 2 * dim * i : NULL,
                              .offset = o->offset ? o->offset + i : NULL};
}

static bool asks_exactly(const fmb_pair_call *a)
{
    return !a->k->options.doubles_only && !fmb_pair_is_cancelled(a->k);
}

/* Answer exactly what is requested beyond the verdict, which is FEASIBLE. */
static fmb_status answer_exactly(const fmb_pair_call *a, size_t i)
{
    fmb_pair_answers out = fmb_pair_answers_from(a->out, (size_t)a->k->dim, i);
    if (!asks_exactly(a)) {
        *out.verdict = FMB_UNKNOWN;
        return FMB_OK;
    }
    a->k->counts.exact_boxes++;
    return fmb_pair_oracle_answer(&a->k->oracle, &a->p[i], &a->q[i], &out);
}

/* NULL without memory. */
static fmb_exact_boxer *need_boxer(fmb_pair *k)
{
    if (!k->boxer)
        k->boxer = fmb_exact_boxer_new(&k->mem, NULL);
    return k->boxer;
}

fmb_status fmb_single_pair_answer(const fmb_pair_call *a, size_t i)
{
    const fmb_pair *k = a->k;
    fmb_pair_answers out = fmb_pair_answers_from(a->out, (size_t)a->k->dim, i);
    fmb_corner_edges p, q;
    if (k->options.method == FMB_PAIR_EXACT)
        return answer_exactly(a, i);
    bool done = !k->options.tightest && fmb_way(FMB_WAY_PAIR_DOUBLES) &&
                fmb_single_pair_edges(a, i, &p, &q) &&
                fmb_general_answer(k->general, &p.frame, &q.frame, &out);
    fmb_way_answered(FMB_WAY_PAIR_DOUBLES, done);
    if (done)
        return FMB_OK;
    done = asks_exactly(a) && fmb_way(FMB_WAY_PAIR_VERTICES) &&
           (fmb_exact_box_answer(need_boxer(a->k), &a->p[i], &a->q[i], &out) ||
            fmb_pair_oracle_answer_at_vertices(&a->k->oracle, &a->p[i], &a->q[i], &out));
    fmb_way_answered(FMB_WAY_PAIR_VERTICES, done);
    return done ? FMB_OK : answer_exactly(a, i);
}

fmb_status fmb_single_pair_decide_exactly(const fmb_pair_call *a, size_t i)
{
    fmb_verdict *out = &a->out->verdict[i];
    *out = FMB_UNKNOWN;
    if (!asks_exactly(a))
        return FMB_OK;
    a->k->counts.exact_verdicts++;
    bool done = a->k->options.method != FMB_PAIR_EXACT && fmb_way(FMB_WAY_PAIR_VERTICES) &&
                fmb_pair_oracle_decide_at_vertices(&a->k->oracle, &a->p[i], &a->q[i], out);
    fmb_way_answered(FMB_WAY_PAIR_VERTICES, done);
    if (!done)
        FMB_TRY(fmb_pair_oracle_decide(&a->k->oracle, &a->p[i], &a->q[i], out));
    return *out == FMB_FEASIBLE && a->boxes ? fmb_single_pair_answer(a, i) : FMB_OK;
}

/* ---- verdicts -------------------------------------------------------------------------------- */

static void decide_at_vertices(const fmb_pair_call *a, size_t i, fmb_verdict *out)
{
    if (!asks_exactly(a) || !fmb_way(FMB_WAY_PAIR_VERTICES))
        return;
    *out = fmb_exact_box_decide(need_boxer(a->k), &a->p[i], &a->q[i], a->k->options.contact);
    a->k->counts.exact_verdicts += *out != FMB_UNKNOWN;
    fmb_way_answered(FMB_WAY_PAIR_VERTICES, *out != FMB_UNKNOWN);
}

/* Decide closed frames that kernels left open: most of them touch, which doubles cannot prove. */
static void meet_at_vertex(const fmb_pair_call *a, size_t i, fmb_verdict *out)
{
    if (a->known != FMB_PAIR_OPEN || a->k->options.contact != FMB_CONTACT_CLOSED ||
        !asks_exactly(a) || !fmb_way(FMB_WAY_PAIR_VERTICES) ||
        !fmb_exact_box_meet(need_boxer(a->k), &a->p[i], &a->q[i]))
        return;
    *out = FMB_FEASIBLE;
    a->k->counts.exact_verdicts++;
    fmb_way_answered(FMB_WAY_PAIR_VERTICES, true);
}

void fmb_single_pair_decide(const fmb_pair_call *a, size_t i, fmb_verdict *out)
{
    fmb_pair *k = a->k;
    const fmb_frame *p = &a->p[i], *q = &a->q[i];
    fmb_corner_edges of_p, of_q;
    bool by_kernels = k->dim == 2 || k->dim == 3;
    if (fmb_single_pair_is_of_hulls(p, q)) {
        *out = fmb_contact_of_hulls(p, q, k->options.contact, &k->wide->packed->hulls,
                                    FMB_HULLS_VERDICT, NULL, NULL);
        fmb_way_answered(FMB_WAY_PAIR_DOUBLES, *out != FMB_UNKNOWN);
        return;
    }
    bool done = fmb_way(FMB_WAY_PAIR_CORNERS) && fmb_decide_corners(p, q, k->options.contact, out);
    fmb_way_answered(FMB_WAY_PAIR_CORNERS, done);
    if (done)
        return;
    if (by_kernels)
        decide_at_vertices(a, i, out);
    else
        meet_at_vertex(a, i, out);
    done = *out != FMB_UNKNOWN;
    if (!done && fmb_way(FMB_WAY_PAIR_DOUBLES) && fmb_single_pair_edges(a, i, &of_p, &of_q))
        *out = fmb_general_decide(k->general, &of_p.frame, &of_q.frame);
    fmb_way_answered(FMB_WAY_PAIR_DOUBLES, !done && *out != FMB_UNKNOWN);
    if (*out == FMB_UNKNOWN && !by_kernels)
        decide_at_vertices(a, i, out);
}
