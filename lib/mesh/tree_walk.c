/* tree_walk.c: see tree_walk.h. */
#include "mesh/tree_walk.h"

/* ---- pairs of cells -------------------------------------------------------------------------- */

/* A cell with what its pairs ask for. */
typedef struct listed_cell {
    uint32_t number;
    unsigned faults;
    fmb_cell cell;
    fmb_triangle_plane plane; /* of a triangle */
} listed_cell;

static void list_cell(const fmb_mesh *m, const uint32_t *ids, uint32_t number, listed_cell *out)
{
    out->number = number;
    out->faults = m->faults[number];
    out->cell = fmb_mesh_cell_of(m, ids, number);
    out->plane = fmb_plane_of_cell(&out->cell);
}

/* Decide a flat triangle and one that is not. False: they are not that. */
static bool decide_flat_one(const listed_cell *flat, const listed_cell *other, fmb_mesh_how *how)
{
    return flat->faults == FMB_MESH_FLAT && !other->faults && flat->cell.corners == 3 &&
           other->cell.corners == 3 &&
           fmb_decide_segment(&flat->cell, &other->cell, &other->plane, how);
}

static fmb_status decide_cells(fmb_tree_walk *x, const listed_cell *a, const listed_cell *b,
                               unsigned common, fmb_mesh_how *how)
{
    const fmb_cell *p = &a->cell, *q = &b->cell;
    int shared = fmb_cell_count(common);
    bool alike = p->corners == q->corners && !(a->faults | b->faults) && !x->plan->o->motion;
    *how = FMB_MESH_TOUCH;
    if (alike && p->corners == 3)
        *how = fmb_decide_triangles(p, &a->plane, q, common);
    else if (alike)
        *how = fmb_decide_tetrahedra(p, q, shared);
    if (alike && (p->corners == 3 || shared == 0 || *how != FMB_MESH_TOUCH))
        return FMB_OK;
    if (!x->plan->o->motion && (decide_flat_one(a, b, how) || decide_flat_one(b, a, how)))
        return FMB_OK;
    x->out.framed++;
    FMB_TRY(fmb_run_poll_now(&x->run));
    return fmb_mesh_decide_frames(&x->frames, p, q, (b->faults & FMB_MESH_FLAT) != 0, how);
}

static fmb_status append_hit(fmb_tree_walk *x, fmb_mesh_hit hit)
{
    fmb_mesh_answer *out = &x->out;
    fmb_status st = FMB_RESERVE(&x->mem, &out->hit, &out->capacity, out->hits + 1);
    if (st == FMB_OK)
        out->hit[out->hits++] = hit;
    return st;
}

/* Decide a pair of cells and note a hit. */
static fmb_status look_at_pair_of_cells(fmb_tree_walk *x, const listed_cell *a,
                                        const listed_cell *b)
{
    fmb_mesh_how how;
    unsigned common = fmb_cell_common(&a->cell, &b->cell);
    x->out.tested++;
    fmb_status st = decide_cells(x, a, b, common, &how);
    bool wanted = how != FMB_MESH_APART && (how != FMB_MESH_SHARE || x->plan->o->neighbours);
    if (st == FMB_OK && how == FMB_MESH_APART && x->plan->clearance.gap > 0) {
        bool exactly;
        st = fmb_mesh_cells_are_near(&x->frames, &a->cell, &b->cell, &x->plan->clearance, &exactly,
                                     &wanted);
        x->out.framed += exactly;
    }
    if (st != FMB_OK || !wanted)
        return st;
    return append_hit(x, (fmb_mesh_hit){a->number, b->number, fmb_cell_count(common), how});
}

/* ---- trees ----------------------------------------------------------------------------------- */

enum { LEAVES_BETWEEN_SIGNS = 32 };

/* Add this thread's progress to the plan. FMB_LIMIT: stop. */
static fmb_status share_progress(fmb_tree_walk *x)
{
    fmb_walk_plan *plan = x->plan;
    double units = FMB_WALK_UNITS;
    uint64_t mine = (uint64_t)(x->weight * units);
    double done = (double)(atomic_fetch_add(&plan->done, mine) + mine) / units;
    x->weight = 0;
    if (x->tells && plan->o->progress && !plan->o->progress(plan->o->self, done < 1 ? done : 1)) {
        plan->cancelled = true;
        atomic_store(&plan->stopped, 1);
    }
    return fmb_run_poll_now(&x->run);
}

/* Note that pairs of this weight are done. FMB_LIMIT: stop. */
static fmb_status note_progress(fmb_tree_walk *x, double weight)
{
    x->weight += weight;
    if (++x->unheard < LEAVES_BETWEEN_SIGNS)
        return FMB_OK;
    x->unheard = 0;
    return share_progress(x);
}

/* Cells of a leaf, and their boxes, swept if they move. */
typedef struct leaf_cells {
    int size;
    fmb_mesh_box box[FMB_MESH_LEAF_CELLS];
    listed_cell cell[FMB_MESH_LEAF_CELLS];
} leaf_cells;

/* List the cells of leaf n whose boxes are near a box around the cells of another leaf. */
static void list_cells(const fmb_mesh *m, const uint32_t *ids, const fmb_mesh_node *n,
                       const double *motion, const fmb_mesh_clearance *clearance,
                       const fmb_mesh_box *other, leaf_cells *out)
{
    out->size = 0;
    for (uint32_t i = n->from; i < n->to; i++) {
        out->box[out->size] = fmb_mesh_box_sweep(m->box[i], motion);
        out->cell[out->size].number = m->order[i];
        out->size += fmb_mesh_boxes_are_near(clearance, &out->box[out->size], other);
    }
    for (int i = 0; i < out->size; i++)
        list_cell(m, ids, out->cell[i].number, &out->cell[i]);
}

/* Decide two cells; within one mesh the smaller number comes first. */
static fmb_status meet_cells(fmb_tree_walk *x, const listed_cell *p, const listed_cell *q)
{
    bool swap = x->plan->a == x->plan->b && q->number < p->number;
    return look_at_pair_of_cells(x, swap ? q : p, swap ? p : q);
}

/* Decide all pairs of two leaves; of a leaf with itself each pair once. */
static fmb_status meet_leaves(fmb_tree_walk *x, const fmb_mesh_node *p, const fmb_mesh_node *q)
{
    const fmb_walk_plan *plan = x->plan;
    const double *motion = plan->o->motion;
    const fmb_mesh_clearance *clearance = &plan->clearance;
    fmb_mesh_box swept = fmb_mesh_box_sweep(q->box, motion);
    fmb_status st = fmb_run_poll(&x->run);
    leaf_cells a, other;
    const leaf_cells *b = p == q ? &a : &other;
    list_cells(plan->a, plan->ids_a, p, NULL, clearance, &swept, &a);
    if (p != q)
        list_cells(plan->b, plan->ids_b, q, motion, clearance, &p->box, &other);
    for (int i = 0; i < a.size; i++)
        for (int j = p == q ? i + 1 : 0; st == FMB_OK && j < b->size; j++)
            if (fmb_mesh_boxes_are_near(clearance, &a.box[i], &b->box[j]))
                st = meet_cells(x, &a.cell[i], &b->cell[j]);
    return st;
}

/* Visit a pair of nodes: the larger one is replaced by its children. */
static fmb_status meet_nodes(fmb_tree_walk *x, const fmb_mesh_node *p, const fmb_mesh_node *q,
                             double weight)
{
    fmb_mesh_box swept = fmb_mesh_box_sweep(q->box, x->plan->o->motion);
    fmb_status st = FMB_OK;
    if (!fmb_mesh_boxes_are_near(&x->plan->clearance, &p->box, &swept))
        return note_progress(x, weight);
    if (!p->left && !q->left) {
        st = meet_leaves(x, p, q);
        return st == FMB_OK ? note_progress(x, weight) : st;
    }
    bool split_p = p->left && (!q->left || p->to - p->from >= q->to - q->from);
    for (uint32_t i = 0; st == FMB_OK && i < 2; i++)
        st = split_p ? meet_nodes(x, &x->plan->a->node[p->left + i], q, weight / 2)
                     : meet_nodes(x, p, &x->plan->b->node[q->left + i], weight / 2);
    return st;
}

/* Visit all pairs within one node; there is only one mesh. */
static fmb_status meet_within_node(fmb_tree_walk *x, const fmb_mesh_node *p, double weight)
{
    if (!p->left) {
        fmb_status st = meet_leaves(x, p, p);
        return st == FMB_OK ? note_progress(x, weight) : st;
    }
    const fmb_mesh_node *child = &x->plan->a->node[p->left];
    fmb_status st = meet_within_node(x, &child[0], weight / 4);
    FMB_THEN(st, meet_within_node(x, &child[1], weight / 4));
    return st == FMB_OK ? meet_nodes(x, &child[0], &child[1], weight / 2) : st;
}

/* ---- all pairs ------------------------------------------------------------------------------- */

enum { PAIRS_BETWEEN_NOTES = 64 };

fmb_status fmb_walk_row_of_pairs(fmb_tree_walk *x, uint32_t row)
{
    const fmb_walk_plan *plan = x->plan;
    const size_t cells = plan->b->cells;
    const double weight = 1.0 / (double)(plan->to - plan->from) / (double)cells;
    listed_cell a, b;
    fmb_status st = FMB_OK;
    list_cell(plan->a, plan->ids_a, row, &a);
    for (size_t j = plan->a == plan->b ? (size_t)row + 1 : 0; st == FMB_OK && j < cells;) {
        size_t end = cells - j < PAIRS_BETWEEN_NOTES ? cells : j + PAIRS_BETWEEN_NOTES;
        double share = weight * (double)(end - j);
        st = fmb_run_poll(&x->run);
        for (; st == FMB_OK && j < end; j++) {
            list_cell(plan->b, plan->ids_b, (uint32_t)j, &b);
            st = look_at_pair_of_cells(x, &a, &b);
        }
        FMB_THEN(st, note_progress(x, share));
    }
    return st;
}

/* ---- parts ----------------------------------------------------------------------------------- */

/* Split a part: a node with itself into three, two nodes into two. Returns the number. */
static int split_part(const fmb_walk_plan *plan, const fmb_walk_part *from, fmb_walk_part out[3])
{
    const fmb_mesh_node *p = from->p, *q = from->q, *child;
    if (p == q && plan->a == plan->b) {
        child = &plan->a->node[p->left];
        out[0] = (fmb_walk_part){&child[0], &child[0], from->weight / 4};
        out[1] = (fmb_walk_part){&child[1], &child[1], from->weight / 4};
        out[2] = (fmb_walk_part){&child[0], &child[1], from->weight / 2};
        return 3;
    }
    bool split_p = p->left && (!q->left || p->to - p->from >= q->to - q->from);
    child = split_p ? &plan->a->node[p->left] : &plan->b->node[q->left];
    for (int i = 0; i < 2; i++)
        out[i] =
            (fmb_walk_part){split_p ? &child[i] : p, split_p ? q : &child[i], from->weight / 2};
    return 2;
}

/* Repeatedly, the first part that can be split is replaced by its subparts, at the end. */
int fmb_walk_parts(const fmb_walk_plan *plan, fmb_walk_part out[FMB_WALK_MOST_PARTS])
{
    int n = 1;
    out[0] = (fmb_walk_part){plan->a->node, plan->b->node, 1};
    for (int i = 0; i < n && n + 2 <= FMB_WALK_MOST_PARTS; i++)
        while ((out[i].p->left || out[i].q->left) && n + 2 <= FMB_WALK_MOST_PARTS &&
               out[i].weight > 2.0 / FMB_WALK_MOST_PARTS) {
            fmb_walk_part children[3];
            int k = split_part(plan, &out[i], children);
            out[i] = children[0];
            while (--k > 0)
                out[n++] = children[k];
        }
    return n;
}

fmb_status fmb_walk_part_of_trees(fmb_tree_walk *x, const fmb_walk_part *part)
{
    bool within = part->p == part->q && x->plan->a == x->plan->b;
    return within ? meet_within_node(x, part->p, part->weight)
                  : meet_nodes(x, part->p, part->q, part->weight);
}
