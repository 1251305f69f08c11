/* objective_column.c: see objective_column.h. */
#include "solve/optimize/objective_column.h"

#include <string.h>

/* Room for entries of a row. */
static fmb_status open_row_with_objective(fmb_vec *v, size_t entries, fmb_arena *arena)
{
    *v = (fmb_vec){.s = fmb_arena_get(arena, entries, sizeof *v->s)};
    return v->s ? FMB_OK : fmb_mem_status(arena->mem);
}

/* Copy from[n + 1], in lowest terms, to to[n + 2], with a zero before the right side. */
static fmb_status copy_row_with_objective(fmb_vec *to, const fmb_vec *from, size_t n, fmb_num *k)
{
    if (!fmb_vec_is_wide(from)) {
        memcpy(to->s, from->s, n * sizeof *to->s);
        to->s[n] = 0;
        to->s[n + 1] = from->s[n];
        to->bits = from->bits;
        return FMB_OK;
    }
    memset(to->s, 0, (n + 2) * sizeof *to->s);
    fmb_status st = fmb_vec_widen(to, n + 2, k->mem);
    for (size_t j = 0; st == FMB_OK && j <= n; j++)
        fmb_vec_get(from, j, to->z[j < n ? j : n + 1]);
    return st == FMB_OK ? fmb_vec_settle(to, n + 2, k->mem) : st;
}

/* den z - (den goal).x = 0 in integers z[n + 2], den being the least common denominator. */
static void write_goal_in_integers(const fmb_part *from, const fmb_goal *g, mpz_t *z)
{
    size_t n = (size_t)from->n;
    mpz_ptr den = z[n];
    mpz_set_ui(den, 1);
    for (size_t j = 0; j < n; j++)
        mpz_lcm(den, den, mpq_denref(g->coef[from->var[j]]));
    for (size_t j = 0; j < n; j++) {
        mpq_srcptr c = g->coef[from->var[j]];
        mpz_divexact(z[j], den, mpq_denref(c));
        mpz_mul(z[j], z[j], mpq_numref(c));
        mpz_neg(z[j], z[j]);
    }
    mpz_set_ui(z[n + 1], 0);
}

static fmb_status set_goal_row(fmb_vec *row, const fmb_part *from, const fmb_goal *g, fmb_num *k)
{
    size_t entries = (size_t)from->n + 2;
    mpz_t *z = fmb_vec_block(entries, k->mem);
    if (!z)
        return fmb_mem_status(k->mem);
    write_goal_in_integers(from, g, z);
    fmb_status st = fmb_vec_set_z(row, entries, z, k->mem);
    FMB_THEN(st, fmb_vec_reduce(row, entries, k));
    fmb_vec_block_free(z, entries, k->mem);
    return st;
}

static fmb_status allocate_part_with_objective(fmb_part *p, int n, size_t m, fmb_arena *arena)
{
    *p = (fmb_part){.n = n};
    FMB_TRY(FMB_ARENA_GET(arena, p->var, (size_t)n));
    FMB_TRY(FMB_ARENA_GET(arena, p->row, m));
    FMB_TRY(FMB_ARENA_GET(arena, p->rel, m));
    FMB_TRY(FMB_ARENA_GET(arena, p->source, m));
    return FMB_OK;
}

/* After a limit it does not poll, as only cheap work is requested then. */
static fmb_status fill_rows_with_objective(fmb_part *p, fmb_query *q, const fmb_part *from,
                                           const fmb_goal *g, fmb_num *k)
{
    size_t n = (size_t)from->n;
    fmb_status st = FMB_OK;
    for (size_t i = 0; st == FMB_OK && i <= from->m; i++) {
        st = open_row_with_objective(&p->row[i], n + 2, &q->v->arena);
        if (st != FMB_OK)
            break;
        p->m++;
        st = i < from->m ? copy_row_with_objective(&p->row[i], &from->row[i], n, k)
                         : set_goal_row(&p->row[i], from, g, k);
        if (st == FMB_OK && q->run.stop == FMB_STOP_DONE)
            st = fmb_run_poll_step(&q->run, fmb_vec_is_wide(&p->row[i]));
    }
    return st;
}

fmb_status fmb_objective_column_init(fmb_objective_column *w, fmb_query *q, int part,
                                     const fmb_goal *g)
{
    fmb_num k;
    const fmb_part *from = &q->parts.part[part];
    size_t n = (size_t)from->n;
    fmb_part *p = &w->p;
    w->mem = q->run.mem;
    FMB_TRY(fmb_query_write_rows(q, part));
    FMB_TRY(allocate_part_with_objective(p, from->n + 1, from->m + 1, &q->v->arena));
    memcpy(p->var, from->var, n * sizeof *p->var);
    memcpy(p->rel, from->rel, from->m * sizeof *p->rel);
    memcpy(p->source, from->source, from->m * sizeof *p->source);
    p->var[n] = -1;
    p->rel[from->m] = FMB_EQ;
    p->source[from->m] = from->source[0];
    fmb_status st = fmb_run_open_num(&q->run, &k, 1, fmb_query_is_wide(q));
    FMB_THEN(st, fill_rows_with_objective(p, q, from, g, &k));
    fmb_num_clear(&k);
    return st;
}

void fmb_objective_column_clear(fmb_objective_column *w)
{
    for (size_t i = 0; i < w->p.m; i++)
        fmb_vec_clear(&w->p.row[i], (size_t)w->p.n + 1, w->mem);
    w->p.m = 0;
}
