/* sweep.c: triangular factors modulo p; see sweep.h. */
#include "lp/linalg/modular/sweep.h"

#include <string.h>

fmb_status fmb_sweep_reserve(fmb_sweep *w, fmb_arena *arena, size_t terms)
{
    FMB_TRY(FMB_ARENA_RESERVE(arena, &w->index, &w->index_room, terms));
    return FMB_ARENA_RESERVE(arena, &w->value, &w->value_room, terms);
}

fmb_status fmb_sweep_open(fmb_sweep *w, fmb_arena *arena, size_t n, size_t terms, bool down)
{
    *w = (fmb_sweep){.n = n, .down = down};
    FMB_TRY(FMB_ARENA_GET(arena, w->start, n + 1));
    FMB_TRY(FMB_ARENA_GET(arena, w->scale, n));
    w->start[0] = 0;
    return fmb_sweep_reserve(w, arena, terms);
}

fmb_status fmb_sweep_transpose(const fmb_sweep *w, fmb_arena *arena, fmb_sweep *to)
{
    size_t n = w->n, terms = w->start[n];
    FMB_TRY(fmb_sweep_open(to, arena, n, terms, !w->down));
    memset(to->start, 0, (n + 1) * sizeof *to->start);
    for (size_t t = 0; t < terms; t++)
        to->start[w->index[t]]++;
    for (size_t k = 1; k <= n; k++)
        to->start[k] += to->start[k - 1];
    for (size_t k = n; k-- > 0;)
        for (size_t t = w->start[k]; t < w->start[k + 1]; t++) {
            size_t at = --to->start[w->index[t]];
            to->index[at] = (int)k;
            to->value[at] = w->value[t];
        }
    memcpy(to->scale, w->scale, n * sizeof *to->scale);
    return FMB_OK;
}

size_t fmb_sweep_reach(const fmb_sweep *w, bool *reached, int *step)
{
    size_t steps = 0;
    for (size_t s = 0; s < w->n; s++) {
        size_t k = w->down ? w->n - 1 - s : s;
        bool now = false;
        for (size_t t = w->start[k]; t < w->start[k + 1] && !now; t++)
            now = reached[w->index[t]];
        if (now || (reached[k] && w->scale[k] != 1))
            step[steps++] = (int)k;
        reached[k] = reached[k] || now;
    }
    return steps;
}

void fmb_sweep_run(const fmb_sweep *w, const fmb_prime *q, const int *step, size_t steps,
                   uint64_t *v)
{
    for (size_t s = 0; s < steps; s++) {
        size_t k = (size_t)step[s], first = w->start[k], terms = w->start[k + 1] - first;
        uint64_t x =
            terms ? fmb_prime_minus_dot(q, v[k], w->value + first, v, w->index + first, terms)
                  : v[k];
        v[k] = w->scale[k] == 1 ? x : fmb_prime_times(q, x, w->scale[k]);
    }
}
