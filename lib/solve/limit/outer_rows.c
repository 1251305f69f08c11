/* outer_rows.c: an outer projection; see outer.h.
 *
 * Rows that name kept variables only follow from the system, wherever the elimination stopped; so
 * do ends of kept variables.
 */
#include "solve/limit/outer.h"
#include "solve/limit/outer_ends.h"
#include "system/system_private.h"

/* Total entries read in rows, and total rows read in derivations. */
#define MOST_ENTRIES ((size_t)1 << 20)
#define MOST_STEPS   ((size_t)1 << 21)
/* The most work of loading a part, some milliseconds: an entry counts 1 plus the square of its
 * length in limbs, as rows are divided by the common divisor of their entries. */
#define MOST_LOADING ((size_t)1 << 24)

/* The outer projection of one part. */
typedef struct image {
    fmb_query *q;
    const fmb_part *p;
    const int *place;
    fmb_system *out;
    fmb_elim *e;
    size_t steps; /* that may still be taken */
} image;

/* Does the row name kept variables only, and one at least? */
static bool names_kept_columns_only(const image *m, const fmb_derived *r)
{
    bool any = false;
    for (int j = 0; j < m->p->n; j++) {
        if (fmb_vec_sgn(&r->v, (size_t)j) == 0)
            continue;
        if (m->place[m->p->var[j]] < 0)
            return false;
        any = true;
    }
    return any;
}

/* Append a row of the store, with its claim. */
static fmb_status put_implied_row(image *m, uint32_t r)
{
    fmb_derived *d = &m->e->row[r];
    fmb_status st = fmb_vec_reduce(&d->v, (size_t)m->e->n + 1, &m->e->num);
    m->steps -= m->steps > r ? r : m->steps;
    return st == FMB_OK
               ? fmb_query_put_row(m->q, m->p, m->e, r, fmb_derived_rel(d), NULL, m->place, m->out)
               : st;
}

static fmb_status put_all_implied_rows(image *m)
{
    size_t rows = m->e->rows, most = MOST_ENTRIES / (size_t)m->e->n;
    for (size_t i = 0; m->steps > 0 && i < rows && i < most; i++)
        if (names_kept_columns_only(m, &m->e->row[i]))
            FMB_TRY(put_implied_row(m, (uint32_t)i));
    return FMB_OK;
}

/* Append the ends that are not rows already. */
static fmb_status put_ends_as_rows(image *m, const fmb_ends *f, size_t rows)
{
    for (int c = 0; c < m->p->n; c++)
        for (int side = FMB_LOWER; side <= FMB_UPPER; side++) {
            uint32_t r = f->row[side][c];
            bool seen = side == FMB_UPPER && r == f->row[FMB_LOWER][c];
            if (m->place[m->p->var[c]] >= 0 && r != FMB_NO_ROW && r >= rows && !seen)
                FMB_TRY(put_implied_row(m, r));
        }
    return FMB_OK;
}

fmb_status fmb_outer_rows(fmb_query *q, const fmb_part *p, fmb_elim *e, const int *place,
                          fmb_system *out)
{
    image m = {.q = q, .p = p, .place = place, .out = out, .e = e, .steps = MOST_STEPS};
    fmb_ends f;
    size_t rows = e->rows;
    fmb_status st = put_all_implied_rows(&m);
    fmb_status opened = st == FMB_OK ? fmb_ends_open(&f, e) : st;
    if (opened == FMB_OK)
        opened = fmb_ends_find(&f);
    if (opened == FMB_OK && e->clash == FMB_NO_ROW)
        opened = put_ends_as_rows(&m, &f, rows);
    if (st == FMB_OK)
        fmb_ends_clear(&f);
    return opened == FMB_LIMIT ? FMB_OK : opened;
}

/* The rows contradict each other. Claiming this discards all other claims; if it fails, out loses
 * its rows, too. */
static fmb_status refute_by_clash(fmb_query *q, const fmb_part *p, const fmb_elim *e,
                                  fmb_system *out, fmb_verdict *verdict)
{
    fmb_status st = fmb_query_claim_clash(q, p, e);
    if (st == FMB_OK)
        *verdict = FMB_INFEASIBLE;
    while (st != FMB_OK && fmb_system_rows(out) > 0)
        fmb_system_remove(out, fmb_system_rows(out) - 1);
    return st;
}

/* Is the part loaded, or quick to load? Rows of long numbers that were not loaded before the limit
 * are not loaded after it. */
static bool is_loading_short(const fmb_query *q, const fmb_part *p)
{
    size_t work = 0;
    for (size_t i = 0; !p->row && i < p->m && work <= MOST_LOADING; i++) {
        const fmb_sysrow *r = fmb_system_row(q->s, p->source[i]);
        size_t limbs = fmb_vec_is_wide(&r->val) ? r->val.limbs / (r->nnz + 2) : 0;
        work += (r->nnz + 1) * (1 + limbs * limbs);
    }
    return work <= MOST_LOADING;
}

/* Append rows and ends derived from the rows of the part alone. */
static fmb_status put_part_at_limit(fmb_query *q, const fmb_part *p, const int *place,
                                    fmb_system *out, fmb_verdict *verdict)
{
    fmb_elim e;
    if (!is_loading_short(q, p))
        return FMB_OK;
    fmb_arena_place start = fmb_arena_tell(&q->v->arena);
    fmb_status st = fmb_query_load(q, p, true, &e);
    if (st == FMB_OK && e.clash == FMB_NO_ROW)
        st = fmb_outer_rows(q, p, &e, place, out);
    if (st == FMB_OK && e.clash != FMB_NO_ROW)
        st = refute_by_clash(q, p, &e, out, verdict);
    fmb_elim_clear(&e);
    fmb_arena_rewind(&q->v->arena, start);
    return st == FMB_LIMIT ? FMB_OK : st;
}

fmb_status fmb_outer_projection(fmb_query *q, int part, const int *place, fmb_system *out,
                                fmb_verdict *verdict)
{
    fmb_status st = FMB_OK;
    if (fmb_outer_is_cheap(&q->parts.part[part]))
        st = put_part_at_limit(q, &q->parts.part[part], place, out, verdict);
    if (*verdict == FMB_INFEASIBLE)
        q->run.stop = FMB_STOP_DONE;
    return st;
}
