/* cone.c: the dual simplex method without costs, in doubles; see cone.h.
 *
 * A basis of generators writes the target uniquely. While some multiplier is negative, its
 * generator leaves, for one whose coefficient in that row is negative, too; the largest such keeps
 * the numbers good. If there is none, the row is a hyperplane with all generators on one side and
 * the target on the other (Farkas). Consecutive targets start from each other's bases. Without
 * costs the method might cycle: it gives up after a number of steps.
 */
#include "lp/cone.h"

#include <math.h>
#include <string.h>

/* Numbers below this are taken for rounding errors: inputs are about 1. */
#define TINY 1e-9
/* Pivots after which errors have gathered. */
#define STALE 100

fmb_status fmb_cone_init(fmb_cone *c, fmb_run *run, size_t d)
{
    fmb_mem *mem = run->mem;
    *c = (fmb_cone){.run = run, .mem = mem, .kernels = run->kernels, .d = d};
    c->basic = fmb_mem_get(mem, d, sizeof *c->basic);
    c->inverse = fmb_mem_zero(mem, d * d, sizeof *c->inverse);
    c->value = fmb_mem_zero(mem, d, sizeof *c->value);
    c->normal = fmb_mem_zero(mem, d, sizeof *c->normal);
    if (!c->basic || !c->inverse || !c->value || !c->normal)
        return fmb_mem_status(mem);
    for (size_t k = 0; k < d; k++) {
        c->basic[k] = SIZE_MAX;
        c->inverse[k * d + k] = 1;
    }
    return FMB_OK;
}

void fmb_cone_clear(fmb_cone *c)
{
    fmb_mem_put(c->mem, c->at, c->d * c->capacity, sizeof *c->at);
    fmb_mem_put(c->mem, c->is_free, c->capacity, sizeof *c->is_free);
    fmb_mem_put(c->mem, c->is_gone, c->capacity, sizeof *c->is_gone);
    fmb_mem_put(c->mem, c->price, c->capacity, sizeof *c->price);
    fmb_mem_put(c->mem, c->basic, c->d, sizeof *c->basic);
    fmb_mem_put(c->mem, c->inverse, c->d * c->d, sizeof *c->inverse);
    fmb_mem_put(c->mem, c->value, c->d, sizeof *c->value);
    fmb_mem_put(c->mem, c->normal, c->d, sizeof *c->normal);
}

/* Twice the room: generators lie by dimension, so each dimension moves. */
static fmb_status grow(fmb_cone *c)
{
    size_t room = c->capacity == 0 ? 64 : 2 * c->capacity;
    fmb_cone old = *c;
    c->at = fmb_mem_get(c->mem, c->d * room, sizeof *c->at);
    c->is_free = fmb_mem_zero(c->mem, room, sizeof *c->is_free);
    c->is_gone = fmb_mem_zero(c->mem, room, sizeof *c->is_gone);
    c->price = fmb_mem_get(c->mem, room, sizeof *c->price);
    c->capacity = room;
    if (!c->at || !c->is_free || !c->is_gone || !c->price) {
        fmb_status st = fmb_mem_status(c->mem);
        fmb_mem_put(c->mem, c->at, c->d * room, sizeof *c->at);
        fmb_mem_put(c->mem, c->is_free, room, sizeof *c->is_free);
        fmb_mem_put(c->mem, c->is_gone, room, sizeof *c->is_gone);
        fmb_mem_put(c->mem, c->price, room, sizeof *c->price);
        *c = old;
        return st;
    }
    for (size_t k = 0; k < c->d && old.size > 0; k++)
        memcpy(&c->at[k * room], &old.at[k * old.capacity], old.size * sizeof *c->at);
    if (old.size > 0) {
        memcpy(c->is_free, old.is_free, old.size * sizeof *c->is_free);
        memcpy(c->is_gone, old.is_gone, old.size * sizeof *c->is_gone);
    }
    fmb_mem_put(c->mem, old.at, c->d * old.capacity, sizeof *c->at);
    fmb_mem_put(c->mem, old.is_free, old.capacity, sizeof *c->is_free);
    fmb_mem_put(c->mem, old.is_gone, old.capacity, sizeof *c->is_gone);
    fmb_mem_put(c->mem, old.price, old.capacity, sizeof *c->price);
    return FMB_OK;
}

fmb_status fmb_cone_add(fmb_cone *c, const double *v, bool is_free)
{
    fmb_status st = c->size == c->capacity ? grow(c) : FMB_OK;
    if (st != FMB_OK)
        return st;
    for (size_t k = 0; k < c->d; k++)
        c->at[k * c->capacity + c->size] = v[k];
    c->is_free[c->size] = is_free;
    c->is_gone[c->size] = false;
    c->size++;
    return FMB_OK;
}

/* ---- the basis ------------------------------------------------------------------------------- */

/* Number r of generator j, written in the basis. */
static double entry(const fmb_cone *c, size_t r, size_t j)
{
    double sum = 0;
    for (size_t k = 0; k < c->d; k++)
        sum += c->inverse[r * c->d + k] * c->at[k * c->capacity + j];
    return sum;
}

/* Generator j, written in the basis, has pivot at place r: it takes that place. */
static void replace(fmb_cone *c, size_t r, size_t j)
{
    size_t d = c->d;
    double *row = &c->inverse[r * d], pivot = entry(c, r, j);
    for (size_t k = 0; k < d; k++)
        row[k] /= pivot;
    for (size_t i = 0; i < d; i++) {
        double f = i == r ? 0 : entry(c, i, j);
        for (size_t k = 0; f != 0 && k < d; k++)
            c->inverse[i * d + k] -= f * row[k];
    }
    c->basic[r] = j;
    c->pivots++;
}

void fmb_cone_span(fmb_cone *c, size_t j)
{
    size_t best = SIZE_MAX;
    double most = 1e-7;
    for (size_t r = 0; r < c->d; r++) {
        double a = c->basic[r] == SIZE_MAX ? fabs(entry(c, r, j)) : 0;
        if (a > most) {
            most = a;
            best = r;
        }
    }
    if (best != SIZE_MAX)
        replace(c, best, j);
}

/* The inverse once more, from unit vectors. */
static void invert(fmb_cone *c)
{
    size_t d = c->d;
    memset(c->inverse, 0, d * d * sizeof *c->inverse);
    for (size_t k = 0; k < d; k++)
        c->inverse[k * d + k] = 1;
    size_t old[64];
    size_t some = d < 64 ? d : 64; /* larger ones are left as they are: see search */
    memcpy(old, c->basic, some * sizeof *old);
    for (size_t k = 0; k < d; k++)
        c->basic[k] = SIZE_MAX;
    for (size_t k = 0; k < some; k++)
        if (old[k] != SIZE_MAX)
            fmb_cone_span(c, old[k]);
    c->pivots = 0;
}

/* ---- the search ------------------------------------------------------------------------------ */

static void write_target(fmb_cone *c, const double *target)
{
    for (size_t r = 0; r < c->d; r++) {
        c->value[r] = 0;
        for (size_t k = 0; k < c->d; k++)
            c->value[r] += c->inverse[r * c->d + k] * target[k];
    }
}

/* The place whose value is most out of order: negative, or not zero for the banned generator. */
static size_t find_leaving(const fmb_cone *c, size_t banned)
{
    size_t worst = SIZE_MAX;
    double most = TINY;
    for (size_t r = 0; r < c->d; r++) {
        size_t j = c->basic[r];
        double excess = -c->value[r];
        if (j != SIZE_MAX && j == banned)
            excess = fabs(c->value[r]);
        else if (j == SIZE_MAX || c->is_free[j])
            continue;
        if (excess > most) {
            most = excess;
            worst = r;
        }
    }
    return worst;
}

/* The generator that best takes place r: its entry there has the sign of the value. */
static size_t find_entering(fmb_cone *c, size_t r, size_t banned)
{
    const double *row = &c->inverse[r * c->d];
    double sign = c->value[r] < 0 ? -1 : 1, most = 1e-7;
    size_t best = SIZE_MAX;
    memset(c->price, 0, c->size * sizeof *c->price);
    for (size_t k = 0; k < c->d; k++)
        if (row[k] != 0)
            c->kernels->accumulate(c->price, &c->at[k * c->capacity], c->size, row[k]);
    for (size_t j = 0; j < c->size; j++) {
        double a = c->is_free[j] ? fabs(c->price[j]) : sign * c->price[j];
        if (a > most && j != banned && !c->is_gone[j]) {
            most = a;
            best = j;
        }
    }
    return best;
}

static void set_normal(fmb_cone *c, size_t r)
{
    double sign = c->value[r] < 0 ? 1 : -1;
    for (size_t k = 0; k < c->d; k++)
        c->normal[k] = sign * c->inverse[r * c->d + k];
}

/* A generator that is gone leaves the basis for whatever fits. */
static void clear_gone(fmb_cone *c)
{
    for (size_t r = 0; r < c->d; r++) {
        if (c->basic[r] == SIZE_MAX || !c->is_gone[c->basic[r]])
            continue;
        c->value[r] = 1;
        size_t j = find_entering(c, r, SIZE_MAX);
        c->value[r] = -1;
        j = j != SIZE_MAX ? j : find_entering(c, r, SIZE_MAX);
        if (j != SIZE_MAX)
            replace(c, r, j);
        else
            c->basic[r] = SIZE_MAX;
    }
}

fmb_status fmb_cone_search(fmb_cone *c, const double *target, size_t banned, fmb_guess *out)
{
    fmb_status st = FMB_OK;
    *out = FMB_GUESS_NONE;
    if (c->pivots > STALE && c->d <= 64)
        invert(c);
    clear_gone(c);
    for (size_t steps = 0; st == FMB_OK && steps < 8 * c->d + 32; steps++) {
        write_target(c, target);
        size_t r = find_leaving(c, banned);
        if (r == SIZE_MAX) {
            *out = FMB_GUESS_INSIDE;
            return FMB_OK;
        }
        size_t j = find_entering(c, r, banned);
        if (j == SIZE_MAX) {
            set_normal(c, r);
            *out = FMB_GUESS_OUTSIDE;
            return FMB_OK;
        }
        replace(c, r, j);
        st = fmb_run_poll(c->run);
    }
    return st;
}
