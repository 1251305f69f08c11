/* mesh_distance.c: see mesh_distance.h.
 *
 * Branch and bound, depth first, the nearer child first; boxes no nearer than the best pair so far
 * are pruned. The bound found is certainly not exceeded by some pair, whatever was pruned; a margin
 * is added so that doubles can decide which pairs are within it.
 */
#include "mesh/mesh_distance.h"

#include "proximity/proximity_private.h"

enum { PAIRS_BETWEEN_SIGNS = 256 };

/* The search, with the least bound so far; boxes whose gap is not below its square are pruned. */
typedef struct distance_search {
    fmb_walk_plan *plan;
    double most, gap;
} distance_search;

static fmb_cell cell_of_first(const fmb_walk_plan *plan, uint32_t c)
{
    return fmb_mesh_cell_of(plan->a, plan->ids_a, c);
}

static fmb_cell cell_of_second(const fmb_walk_plan *plan, uint32_t d)
{
    return fmb_mesh_cell_of(plan->b, plan->ids_b, d);
}

static fmb_status poll_search(distance_search *x)
{
    fmb_walk_plan *plan = x->plan;
    const fmb_mesh_options *o = plan->o;
    bool heard = plan->nearest->tested++ % PAIRS_BETWEEN_SIGNS != 0 || !o->progress;
    if (!heard && !o->progress(o->self, 0)) {
        plan->cancelled = true;
        atomic_store(&plan->stopped, 1);
        return fmb_run_poll_now(&plan->run);
    }
    return fmb_run_poll(&plan->run);
}

static fmb_status search_leaves(distance_search *x, const fmb_mesh_node *p, const fmb_mesh_node *q)
{
    const fmb_walk_plan *plan = x->plan;
    fmb_status st = FMB_OK;
    for (uint32_t j = q->from; st == FMB_OK && j < q->to; j++) {
        fmb_mesh_box box = fmb_mesh_box_sweep(plan->b->box[j], plan->o->motion);
        fmb_cell b = cell_of_second(plan, plan->b->order[j]);
        for (uint32_t i = p->from; st == FMB_OK && i < p->to; i++) {
            if (fmb_mesh_boxes_gap(&plan->a->box[i], &box) >= x->gap)
                continue;
            fmb_cell a = cell_of_first(plan, plan->a->order[i]);
            double range[2];
            fmb_mesh_cells_range(&a, &b, plan->o->motion, x->most, range);
            if (range[1] < x->most) {
                x->most = range[1];
                x->gap = range[1] * range[1];
            }
            st = poll_search(x);
        }
    }
    return st;
}

/* Search a pair of nodes: the larger one is replaced by its children. */
static fmb_status search_nodes(distance_search *x, const fmb_mesh_node *p, const fmb_mesh_node *q)
{
    if (!p->left && !q->left)
        return search_leaves(x, p, q);
    bool split_p = p->left && (!q->left || p->to - p->from >= q->to - q->from);
    const fmb_mesh_node *child = split_p ? &x->plan->a->node[p->left] : &x->plan->b->node[q->left];
    double gap[2];
    for (int i = 0; i < 2; i++) {
        fmb_mesh_box swept =
            fmb_mesh_box_sweep(split_p ? q->box : child[i].box, x->plan->o->motion);
        gap[i] = fmb_mesh_boxes_gap(split_p ? &child[i].box : &p->box, &swept);
    }
    fmb_status st = FMB_OK;
    for (int k = 0; st == FMB_OK && k < 2; k++) {
        int i = (gap[1] < gap[0]) != k;
        if (gap[i] < x->gap)
            st = search_nodes(x, split_p ? &child[i] : p, split_p ? q : &child[i]);
    }
    return st;
}

/* If doubles give no bound, take the exact distance of any pair. */
static fmb_status measure_first_cells(fmb_walk_plan *plan, fmb_mesh_frames *frames)
{
    fmb_cell a = cell_of_first(plan, 0), b = cell_of_second(plan, 0);
    fmb_proximity *found = NULL;
    fmb_status st = fmb_mesh_measure_cells(frames, &a, &b, &found);
    if (st == FMB_OK)
        fmb_mesh_clearance_set(&plan->clearance, found->measure);
    fmb_proximity_free(found);
    return st;
}

fmb_status fmb_mesh_bound_distance(fmb_walk_plan *plan)
{
    distance_search x = {plan, INFINITY, INFINITY};
    if (plan->a->cells == 0 || plan->b->cells == 0)
        return FMB_OK;
    fmb_status st = fmb_run_poll_now(&plan->run);
    FMB_THEN(st, search_nodes(&x, plan->a->node, plan->b->node));
    double bound = x.most * (1 + 0x1p-30);
    if (st == FMB_OK && isfinite(bound)) {
        mpq_t square;
        mpq_init(square);
        mpq_set_d(square, bound);
        mpq_mul(square, square, square);
        fmb_mesh_clearance_set(&plan->clearance, square);
        mpq_clear(square);
    } else if (st == FMB_OK) {
        fmb_mesh_frames frames;
        fmb_mesh_frames_open(&frames, plan->o->mem, plan->o->motion);
        st = measure_first_cells(plan, &frames);
        fmb_mesh_frames_close(&frames);
    }
    return st;
}

/* Choose the nearest hit; the first pair that meets is as near as any. */
static fmb_status choose_of_hits(fmb_walk_plan *plan, fmb_mesh_frames *frames,
                                 const fmb_mesh_answer *near)
{
    fmb_mesh_nearest *out = plan->nearest;
    fmb_status st = FMB_OK;
    size_t meets = 0;
    while (meets < near->hits && near->hit[meets].how == FMB_MESH_APART)
        meets++;
    size_t from = meets < near->hits ? meets : 0, to = meets < near->hits ? meets + 1 : meets;
    for (size_t i = from; st == FMB_OK && i < to; i++) {
        fmb_cell a = cell_of_first(plan, near->hit[i].a), b = cell_of_second(plan, near->hit[i].b);
        fmb_proximity *found = NULL;
        st = fmb_run_poll_now(&plan->run);
        FMB_THEN(st, fmb_mesh_measure_cells(frames, &a, &b, &found));
        if (found && (!out->distance || mpq_cmp(found->measure, out->distance->measure) < 0)) {
            fmb_proximity *worse = out->distance;
            out->distance = found;
            out->a = near->hit[i].a;
            out->b = near->hit[i].b;
            found = worse;
        }
        fmb_proximity_free(found);
    }
    return st;
}

fmb_status fmb_mesh_choose_nearest(fmb_walk_plan *plan, const fmb_mesh_answer *near)
{
    fmb_mesh_frames frames;
    if (near->stop != FMB_STOP_DONE)
        return FMB_OK;
    fmb_mesh_frames_open(&frames, plan->o->mem, plan->o->motion);
    fmb_status st = choose_of_hits(plan, &frames, near);
    fmb_mesh_frames_close(&frames);
    if (st != FMB_OK) {
        fmb_proximity_free(plan->nearest->distance);
        plan->nearest->distance = NULL;
    }
    return st;
}
