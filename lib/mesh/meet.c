/* meet.c: which cells of two meshes meet, by one thread or several, in order. */
#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "base/sized.h"
#include "base/threads.h"
#include "mesh/mesh_distance.h"

/* ---- the order of hits ----------------------------------------------------------------------- */

static uint32_t key_of_hit(const fmb_mesh_hit *h, bool by_a)
{
    return by_a ? h->a : h->b;
}

static size_t count_keys(const fmb_walk_plan *plan)
{
    return plan->a->cells > plan->b->cells ? plan->a->cells : plan->b->cells;
}

/* Stable counting sort of the hits of all threads into the first thread's list, which has room for
 * them. start: [keys + 1]. */
static fmb_status sort_hits_by(bool by_a, fmb_tree_walk *walk, int threads, size_t *start,
                               size_t keys)
{
    size_t n = 0;
    for (int t = 0; t < threads; t++)
        n += walk[t].out.hits;
    fmb_mesh_hit *to;
    FMB_TRY(FMB_GET(&walk[0].mem, to, n));
    memset(start, 0, (keys + 1) * sizeof *start);
    for (int t = 0; t < threads; t++)
        for (size_t i = 0; i < walk[t].out.hits; i++)
            start[key_of_hit(&walk[t].out.hit[i], by_a) + 1]++;
    for (size_t k = 1; k <= keys; k++)
        start[k] += start[k - 1];
    for (int t = 0; t < threads; t++) {
        for (size_t i = 0; i < walk[t].out.hits; i++)
            to[start[key_of_hit(&walk[t].out.hit[i], by_a)]++] = walk[t].out.hit[i];
        fmb_mesh_answer_clear(&walk[t].out);
    }
    walk[0].out.hit = to;
    walk[0].out.hits = walk[0].out.capacity = n;
    return FMB_OK;
}

/* Sort the hits of all threads into the first thread's list; share_of_hits left room for that. */
static fmb_status sort_hits(const fmb_walk_plan *plan, fmb_tree_walk *walk, int threads)
{
    size_t keys = count_keys(plan);
    walk[0].mem.limit = 0;
    size_t *start = fmb_mem_get(&walk[0].mem, keys + 1, sizeof *start);
    fmb_status st = start ? FMB_OK : fmb_mem_status(&walk[0].mem);
    FMB_THEN(st, sort_hits_by(false, walk, threads, start, keys));
    FMB_THEN(st, sort_hits_by(true, walk, 1, start, keys));
    fmb_mem_put(&walk[0].mem, start, keys + 1, sizeof *start);
    return st;
}

/* ---- threads --------------------------------------------------------------------------------- */

enum { MOST_THREADS = 64 };

/* Note the status of this thread's last part; after a failure, stop the others. */
static void end_part(fmb_tree_walk *x, fmb_status st)
{
    x->st = st;
    if (st != FMB_OK)
        atomic_store(&x->plan->stopped, 1);
}

/* The jobs of all threads. */
typedef struct walks {
    const fmb_walk_part *part; /* NULL: rows of pairs */
    size_t from;               /* the first row */
    fmb_tree_walk *walk;       /* [threads] */
} walks;

static void walk_one(void *self, size_t k, size_t thread)
{
    const walks *w = self;
    fmb_tree_walk *x = &w->walk[thread];
    if (x->st != FMB_OK)
        return;
    fmb_status st = fmb_run_poll_now(&x->run);
    FMB_THEN(st, w->part ? fmb_walk_part_of_trees(x, &w->part[k])
                         : fmb_walk_row_of_pairs(x, (uint32_t)(w->from + k)));
    end_part(x, st);
}

static fmb_status walk_all(fmb_walk_plan *plan, fmb_mem *mem, fmb_tree_walk *walk, int threads)
{
    fmb_walk_part part[FMB_WALK_MOST_PARTS];
    bool by_rows = plan->to > plan->from;
    size_t jobs = by_rows ? plan->to - plan->from : (size_t)fmb_walk_parts(plan, part);
    walks w = {by_rows ? NULL : part, plan->from, walk};
    for (size_t k = 0; threads == 1 && k < jobs; k++)
        walk_one(&w, k, 0);
    if (threads == 1)
        return FMB_OK;
    fmb_threads running;
    fmb_status st = fmb_threads_open(&running, mem, (size_t)threads);
    if (st == FMB_OK)
        fmb_threads_do(&running, jobs, walk_one, &w);
    fmb_threads_close(&running);
    return st;
}

/* Join the results of all threads in the first one's walk. */
static fmb_status join_walks(const fmb_walk_plan *plan, fmb_tree_walk *walk, int threads)
{
    fmb_mesh_answer *out = &walk[0].out;
    fmb_status st = FMB_OK;
    bool limited = false, late = false, any = out->hits > 0;
    for (int t = 0; st == FMB_OK && t < threads; t++) {
        limited |= walk[t].st == FMB_LIMIT;
        late |= walk[t].run.stop == FMB_STOP_TIME;
        st = walk[t].st == FMB_LIMIT ? FMB_OK : walk[t].st;
    }
    for (int t = 1; t < threads; t++) {
        out->tested += walk[t].out.tested;
        out->framed += walk[t].out.framed;
        any |= walk[t].out.hits > 0;
    }
    out->stop = !limited          ? FMB_STOP_DONE
                : plan->cancelled ? FMB_STOP_CANCELLED
                : late            ? FMB_STOP_TIME
                                  : FMB_STOP_BYTES;
    return st == FMB_OK && any ? sort_hits(plan, walk, threads) : st;
}

/* The limit of a thread's hits [bytes]: sorting needs two copies of each, and one count per key. */
static size_t share_of_hits(const fmb_walk_plan *plan, const fmb_mem *mem, int threads)
{
    size_t counts = (count_keys(plan) + 1) * sizeof(size_t), taken = mem->used + counts;
    size_t left = mem->limit > taken ? mem->limit - taken : 0;
    size_t share = left / 2 / (size_t)threads;
    return mem->limit == 0 ? 0 : share > 0 ? share : 1;
}

static void open_walks(fmb_walk_plan *plan, const fmb_mem *mem, fmb_tree_walk *walk, int threads)
{
    for (int t = 0; t < threads; t++) {
        fmb_tree_walk *x = &walk[t];
        x->plan = plan;
        x->tells = t == 0;
        x->run = plan->run;
        x->unheard = 0;
        x->weight = 0;
        x->st = FMB_OK;
        fmb_mem_init(&x->mem, plan->o->mem, share_of_hits(plan, mem, threads));
        x->out = (fmb_mesh_answer){.mem = x->mem.alloc};
        fmb_mesh_frames_open(&x->frames, plan->o->mem, plan->o->motion);
    }
}

static void close_walks(fmb_tree_walk *walk, int threads)
{
    for (int t = 0; t < threads; t++) {
        fmb_mesh_frames_close(&walk[t].frames);
        fmb_mesh_answer_clear(&walk[t].out);
    }
}

static int count_threads(const fmb_mesh_options *o)
{
    return o->threads < 1 ? 1 : o->threads > MOST_THREADS ? MOST_THREADS : (int)o->threads;
}

static fmb_status meet_by_threads(fmb_walk_plan *plan, fmb_mem *mem, fmb_mesh_answer *out)
{
    int threads = count_threads(plan->o);
    fmb_tree_walk alone, *walk = &alone;
    fmb_status st = FMB_OK;
    if (threads > 1)
        FMB_TRY(FMB_GET(mem, walk, (size_t)threads));
    open_walks(plan, mem, walk, threads);
    if (plan->a->cells > 0 && plan->b->cells > 0)
        st = walk_all(plan, mem, walk, threads);
    FMB_THEN(st, join_walks(plan, walk, threads));
    if (st == FMB_OK) {
        *out = walk[0].out;
        walk[0].out = (fmb_mesh_answer){.size = sizeof(fmb_mesh_answer)};
    }
    close_walks(walk, threads);
    if (threads > 1)
        fmb_mem_put(mem, walk, (size_t)threads, sizeof *walk);
    return st;
}

/* ---- the query ------------------------------------------------------------------------------- */

static bool can_be_clearance(const char *within)
{
    fmb_mesh_clearance clearance;
    if (!within)
        return true;
    fmb_mesh_clearance_init(&clearance);
    bool good = fmb_mesh_clearance_read(&clearance, within);
    fmb_mesh_clearance_clear(&clearance);
    return good;
}

/* Copy the given options, or the default ones. Errors: ARG, with the reason. */
static fmb_status read_mesh_options(const fmb_mesh_options *o, fmb_mesh_options *ours, char *why,
                                    size_t size)
{
    if (!fmb_sized_take(ours, sizeof *ours, o, "options", why, size))
        return FMB_ERR_ARG;
    for (int j = 0; ours->motion && j < 3 && !why[0]; j++)
        if (!isfinite(ours->motion[j]))
            snprintf(why, size, "motion[%d] is %g", j, ours->motion[j]);
    if (!(ours->max_seconds >= 0))
        snprintf(why, size, "max_seconds is %g", ours->max_seconds);
    if (!can_be_clearance(ours->within))
        snprintf(why, size, "within is '%.100s', not p or p/q, at least 0", ours->within);
    return why[0] ? FMB_ERR_ARG : FMB_OK;
}

size_t fmb_mesh_options_trouble(const fmb_mesh_options *o, char *text, size_t size)
{
    fmb_mesh_options ours;
    char why[160];
    (void)read_mesh_options(o, &ours, why, sizeof why);
    return fmb_text_give(why, text, size);
}

/* Number b's points consistently with those of a, then find the pairs. */
static fmb_status meet_with_ids(fmb_walk_plan *plan, fmb_mem *mem, fmb_mesh_answer *out)
{
    const fmb_mesh *a = plan->a, *b = plan->b;
    uint32_t *ids = NULL;
    fmb_status st = FMB_OK;
    plan->ids_a = plan->ids_b = a->same;
    if (a != b) {
        if (a->vertices + b->vertices > FMB_MESH_MOST)
            return FMB_ERR_ARG;
        ids = fmb_mem_get(mem, b->vertices, sizeof *ids);
        st = ids ? fmb_mesh_find_same(b, a, mem, ids) : fmb_mem_status(mem);
        plan->ids_b = ids;
    }
    if (st == FMB_OK && plan->nearest)
        st = fmb_mesh_bound_distance(plan);
    FMB_THEN(st, meet_by_threads(plan, mem, out));
    if (st == FMB_OK && plan->nearest)
        st = fmb_mesh_choose_nearest(plan, out);
    fmb_mem_put(mem, ids, b->vertices, sizeof *ids);
    return st;
}

/* Has the caller's answer, whatever its version, the members that must be freed later? */
static bool can_hold_answer(const fmb_mesh_answer *out)
{
    return fmb_sized_is_good(out, sizeof *out, "out", NULL, 0) &&
           out->size >= offsetof(fmb_mesh_answer, mem) + sizeof out->mem;
}

static fmb_stop stop_of_plan(const fmb_walk_plan *plan)
{
    return plan->cancelled                   ? FMB_STOP_CANCELLED
           : plan->run.stop == FMB_STOP_TIME ? FMB_STOP_TIME
                                             : FMB_STOP_BYTES;
}

static fmb_status meet_as_planned(const fmb_mesh *a, const fmb_mesh *b, const fmb_mesh_options *o,
                                  fmb_walk_plan *plan, fmb_mesh_answer *out)
{
    fmb_mesh_options options;
    fmb_mesh_answer found = {.size = sizeof found};
    fmb_mem mem;
    char why[160];
    if (!a || !out || !can_hold_answer(out) ||
        read_mesh_options(o, &options, why, sizeof why) != FMB_OK ||
        ((!b || b == a) && options.motion))
        return FMB_ERR_ARG;
    o = &options;
    fmb_mem_init(&mem, o->mem, 0);
    mem.limit = o->max_bytes;
    plan->run.mem = &mem;
    plan->run.cancel = &plan->stopped;
    plan->run.threads = 1;
    if (o->max_seconds > 0)
        plan->run.deadline = fmb_monotonic_seconds() + o->max_seconds;
    plan->a = a;
    plan->b = b ? b : a;
    plan->o = o;
    fmb_mem_take(&mem, a->mem.used + (plan->b != a ? plan->b->mem.used : 0));
    bool has_clearance = o->within || plan->nearest;
    if (has_clearance)
        fmb_mesh_clearance_init(&plan->clearance);
    (void)fmb_mesh_clearance_read(&plan->clearance, o->within);
    fmb_status st = meet_with_ids(plan, &mem, &found);
    if (has_clearance)
        fmb_mesh_clearance_clear(&plan->clearance);
    if (st != FMB_OK)
        fmb_mesh_answer_clear(&found);
    if (st == FMB_LIMIT)
        found = (fmb_mesh_answer){
            .size = sizeof(fmb_mesh_answer), .stop = stop_of_plan(plan), .mem = mem.alloc};
    if (st == FMB_OK || st == FMB_LIMIT)
        fmb_sized_give(out, &found, sizeof found);
    return st == FMB_LIMIT ? FMB_OK : st;
}

fmb_status fmb_mesh_meet(const fmb_mesh *a, const fmb_mesh *b, const fmb_mesh_options *o,
                         fmb_mesh_answer *out)
{
    return meet_as_planned(a, b, o, &(fmb_walk_plan){0}, out);
}

fmb_status fmb_mesh_meet_pairs(const fmb_mesh *a, size_t from, size_t to, const fmb_mesh *b,
                               const fmb_mesh_options *o, fmb_mesh_answer *out)
{
    if (from >= to || to > fmb_mesh_cells(a))
        return FMB_ERR_ARG;
    return meet_as_planned(a, b, o, &(fmb_walk_plan){.from = from, .to = to}, out);
}

fmb_status fmb_mesh_distance(const fmb_mesh *a, const fmb_mesh *b, const fmb_mesh_options *o,
                             fmb_mesh_nearest *out)
{
    fmb_mesh_options ours;
    fmb_mesh_answer near = {.size = sizeof near};
    fmb_mesh_nearest found = {.size = sizeof found};
    char why[160];
    if (!b || a == b || !out || !fmb_sized_is_good(out, sizeof *out, "out", NULL, 0) ||
        out->size < offsetof(fmb_mesh_nearest, tested) ||
        !fmb_sized_take(&ours, sizeof ours, o, "options", why, sizeof why) || ours.within)
        return FMB_ERR_ARG;
    ours.neighbours = true;
    fmb_status st = meet_as_planned(a, b, &ours, &(fmb_walk_plan){.nearest = &found}, &near);
    found.tested += near.tested;
    found.stop = near.stop;
    fmb_mesh_answer_clear(&near);
    if (st == FMB_OK)
        fmb_sized_give(out, &found, sizeof found);
    else
        fmb_proximity_free(found.distance);
    return st;
}

void fmb_mesh_answer_clear(fmb_mesh_answer *a)
{
    if (!a || !a->hit)
        return;
    fmb_mem mem;
    fmb_mem_init(&mem, &a->mem, 0);
    mem.used = a->capacity * sizeof *a->hit;
    fmb_mem_put(&mem, a->hit, a->capacity, sizeof *a->hit);
    a->hit = NULL;
    a->hits = a->capacity = 0;
}

const char *fmb_mesh_how_text(fmb_mesh_how h)
{
    static const char *const text[] = {[FMB_MESH_APART] = "apart",
                                       [FMB_MESH_SHARE] = "share",
                                       [FMB_MESH_TOUCH] = "touch",
                                       [FMB_MESH_CROSS] = "cross",
                                       [FMB_MESH_COPLANAR] = "coplanar"};
    return (unsigned)h <= FMB_MESH_COPLANAR ? text[h] : "?";
}
