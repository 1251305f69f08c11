/* outer_parallel.c: keeps the tightest of parallel rows of an outer projection; see outer.h.
 *
 * Ends of variables, rows of an elimination and rows proved by support queries may be parallel.
 */
#include "lp/redundancy/parallel_rows.h"
#include "solve/limit/outer.h"
#include "system/system_private.h"

/* More rows are not compared. */
#define MOST_ROWS_COMPARED ((size_t)1 << 14)

/* Runs without limits, as the query has already reached one. */
static fmb_status decide_parallel_rows(fmb_query *q, size_t n, size_t m, const fmb_lp_row *row,
                                       fmb_fate *fate)
{
    fmb_run run = q->run;
    atomic_int never;
    atomic_init(&never, 0);
    run.cancel = &never;
    run.stop = FMB_STOP_DONE;
    run.deadline = 0;
    return fmb_drop_parallel_rows(&run, n, m, row, fate, NULL);
}

static fmb_status find_parallel_rows(fmb_query *q, const fmb_system *out, size_t first, size_t m,
                                     fmb_fate *fate)
{
    fmb_arena *arena = &q->v->arena;
    size_t n = (size_t)fmb_system_dim(out), made = 0;
    fmb_vec *v = fmb_arena_get(arena, m, sizeof *v);
    int64_t *words = fmb_arena_get(arena, m * (n + 1), sizeof *words);
    fmb_lp_row *row = fmb_arena_get(arena, m, sizeof *row);
    mpz_t *z = fmb_vec_block(n + 1, q->run.mem);
    fmb_status st = v && words && row && z ? FMB_OK : fmb_mem_status(q->run.mem);
    for (; st == FMB_OK && made < m; made++) {
        v[made] = (fmb_vec){.s = words + made * (n + 1)};
        row[made] = (fmb_lp_row){&v[made], fmb_system_row(out, first + made)->rel};
        fmb_sysrow_expand(fmb_system_row(out, first + made), n, z);
        st = fmb_vec_set_z(&v[made], n + 1, z, q->run.mem);
    }
    FMB_THEN(st, decide_parallel_rows(q, n, m, row, fate));
    for (size_t i = 0; i < made; i++)
        fmb_vec_clear(&v[i], n + 1, q->run.mem);
    fmb_vec_block_free(z, n + 1, q->run.mem);
    return st;
}

fmb_status fmb_outer_drop_parallel_rows(fmb_query *q, fmb_system *out, size_t first)
{
    size_t m = fmb_system_rows(out) - first;
    fmb_arena_place place = fmb_arena_tell(&q->v->arena);
    if (m < 2 || m > MOST_ROWS_COMPARED)
        return FMB_OK;
    fmb_fate *fate = fmb_arena_get(&q->v->arena, m, sizeof *fate);
    if (!fate)
        return fmb_mem_status(q->run.mem) == FMB_LIMIT ? FMB_OK : FMB_ERR_MEMORY;
    for (size_t i = 0; i < m; i++)
        fate[i] = FMB_FATE_UNKNOWN;
    fmb_status st = find_parallel_rows(q, out, first, m, fate);
    for (size_t i = m; i-- > 0;)
        if (fate[i] == FMB_FATE_REDUNDANT)
            fmb_system_remove(out, first + i);
    fmb_arena_rewind(&q->v->arena, place);
    return st == FMB_LIMIT ? FMB_OK : st;
}
