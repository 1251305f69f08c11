/* outer_box.c: an outer box; see outer.h. */
#include "solve/limit/outer.h"

#include "solve/limit/outer_ends.h"

/* Reading a derivation takes time and memory proportional to the rows of the store; a larger store
 * with derived rows is not read. */
#define MOST_ROWS_READ ((size_t)1 << 15)

/* ---- ends ------------------------------------------------------------------------------------ */

/* Row r, which names column c only, as sign x_c <= sign value. */
static fmb_status claim_outer_end(fmb_query *q, const fmb_part *p, const fmb_elim *e, uint32_t r,
                                  int c, fmb_side side)
{
    fmb_weights w = {0};
    mpq_t t;
    if (!q->claims)
        return FMB_OK;
    mpq_init(t);
    mpz_set_si(mpq_numref(t), side == FMB_UPPER ? 1 : -1);
    fmb_vec_get(&e->row[r].v, (size_t)c, mpq_denref(t));
    mpq_canonicalize(t);
    fmb_status st = fmb_query_derive(q, e, r, t, &w);
    FMB_THEN(st, fmb_query_claim_implied(q, p, &e->row[r].v, t, e->row[r].strict ? FMB_LT : FMB_LE,
                                         &w, NULL));
    fmb_weights_clear(&w, q->run.mem);
    mpq_clear(t);
    return st;
}

static fmb_status put_outer_end(fmb_query *q, const fmb_part *p, const fmb_ends *f, int c,
                                fmb_side side, fmb_exact_side *end)
{
    uint32_t r = f->row[side][c];
    if (r == FMB_NO_ROW || end->kind != FMB_END_UNKNOWN)
        return FMB_OK;
    FMB_TRY(claim_outer_end(q, p, f->e, r, c, side));
    end->kind = FMB_END_OUTER;
    end->attained = false;
    mpq_set(end->value, f->value[side][c]);
    return FMB_OK;
}

/* Put the ends into every interval of a variable of the part. */
static fmb_status put_outer_ends(fmb_query *q, const fmb_part *p, const fmb_ends *f, fmb_box *box)
{
    const fmb_part *first = q->parts.part;
    for (int i = 0; i < box->size; i++) {
        int part = q->parts.of_var[box->var[i]], c = q->parts.place[box->var[i]];
        if (part < 0 || &first[part] != p)
            continue;
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
            FMB_TRY(put_outer_end(q, p, f, c, (fmb_side)side, &box->side[i][side]));
    }
    return FMB_OK;
}

fmb_status fmb_outer_from_rows(fmb_query *q, const fmb_part *p, fmb_elim *e, fmb_box *box)
{
    fmb_ends f;
    if (e->rows > MOST_ROWS_READ && e->row[p->m].p != FMB_NO_ROW)
        return FMB_OK;
    fmb_status st = fmb_ends_open(&f, e);
    FMB_THEN(st, fmb_ends_find(&f));
    if (st == FMB_OK && e->clash == FMB_NO_ROW)
        st = put_outer_ends(q, p, &f, box);
    fmb_ends_clear(&f);
    return st == FMB_LIMIT ? FMB_OK : st;
}

/* ---- all parts ------------------------------------------------------------------------------- */

/* Is an end of a variable of the part still unknown? */
static bool is_some_end_unknown(const fmb_query *q, int part, const fmb_box *box)
{
    for (int i = 0; i < box->size; i++)
        if (q->parts.of_var[box->var[i]] == part &&
            (box->side[i][FMB_LOWER].kind == FMB_END_UNKNOWN ||
             box->side[i][FMB_UPPER].kind == FMB_END_UNKNOWN))
            return true;
    return false;
}

/* Forget all outer ends, whose claims were discarded. */
static void forget_outer_ends(fmb_box *box)
{
    for (int i = 0; i < box->size; i++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++)
            if (box->side[i][side].kind == FMB_END_OUTER)
                box->side[i][side].kind = FMB_END_UNKNOWN;
}

/* Claim INFEASIBLE: the rows contradict each other. */
static fmb_status claim_clash_of_ends(fmb_query *q, const fmb_part *p, const fmb_elim *e,
                                      fmb_box *box, fmb_verdict *verdict)
{
    fmb_status st = fmb_query_claim_clash(q, p, e);
    if (st == FMB_OK)
        *verdict = FMB_INFEASIBLE;
    else if (q->claims)
        forget_outer_ends(box);
    return st;
}

static fmb_status bound_part_at_limit(fmb_query *q, const fmb_part *p, fmb_box *box,
                                      fmb_verdict *verdict)
{
    fmb_elim e;
    fmb_arena_place place = fmb_arena_tell(&q->v->arena);
    fmb_status st = fmb_query_load(q, p, true, &e);
    if (st == FMB_OK && e.clash == FMB_NO_ROW)
        st = fmb_outer_from_rows(q, p, &e, box);
    if (st == FMB_OK && e.clash != FMB_NO_ROW)
        st = claim_clash_of_ends(q, p, &e, box, verdict);
    fmb_elim_clear(&e);
    fmb_arena_rewind(&q->v->arena, place);
    return st == FMB_LIMIT ? FMB_OK : st;
}

fmb_status fmb_outer_box(fmb_query *q, fmb_box *box, fmb_verdict *verdict)
{
    fmb_status st = FMB_OK;
    for (int c = 0; st == FMB_OK && *verdict != FMB_INFEASIBLE && c < q->parts.count; c++)
        if (is_some_end_unknown(q, c, box) && fmb_outer_is_cheap(&q->parts.part[c]))
            st = bound_part_at_limit(q, &q->parts.part[c], box, verdict);
    if (*verdict == FMB_INFEASIBLE)
        q->run.stop = FMB_STOP_DONE;
    return st;
}

void fmb_outer_release(fmb_query *q, fmb_arena_place place)
{
    fmb_query_close_oracles(q);
    fmb_arena_rewind(&q->v->arena, place);
    fmb_arena_trim(&q->v->arena);
}
