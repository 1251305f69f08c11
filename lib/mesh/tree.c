/* tree.c: the tree of bounding boxes: a plane across the longest axis of the box of a node divides
 * its cells by their centres. What divides them depends on the mesh alone, so the tree is the same
 * everywhere.
 */
#include <float.h>

#include "mesh/mesh_private.h"

static fmb_mesh_box box_of_cell(const fmb_mesh *m, size_t c)
{
    const uint32_t *corner = m->corner + c * (size_t)m->corners;
    const double *first = m->point + 3 * (size_t)corner[0];
    const double *last = m->corners == 4 ? m->point + 3 * (size_t)corner[3] : first;
    const double *p = m->point + 3 * (size_t)corner[1], *q = m->point + 3 * (size_t)corner[2];
    double lower[4] = {0}, upper[4] = {0};
    for (int j = 0; j < 3; j++) {
        double x = first[j] < last[j] ? first[j] : last[j], y = p[j] < q[j] ? p[j] : q[j];
        double z = first[j] > last[j] ? first[j] : last[j], w = p[j] > q[j] ? p[j] : q[j];
        lower[j] = x < y ? x : y;
        upper[j] = z > w ? z : w;
    }
    return fmb_mesh_box_around(lower, upper);
}

static int longest_axis(const fmb_mesh_box *b)
{
    fmb_float4 length = b->upper - b->lower;
    int best = length[1] > length[0] ? 1 : 0;
    return length[2] > length[best] ? 2 : best;
}

/* Move the cells among from ... to - 1 with twice the centre below `twice` to the front; returns
 * the first one behind them. Without branches on a centre, as half of these would be mispredicted.
 */
static uint32_t move_lower_to_front(fmb_mesh *m, int axis, float twice, uint32_t from, uint32_t to)
{
    fmb_mesh_box *box = m->box;
    uint32_t *order = m->order, below = from;
    for (uint32_t i = from; i < to; i++) {
        fmb_mesh_box b = box[i];
        uint32_t cell = order[i];
        float sum = box[i].lower[axis] + box[i].upper[axis];
        box[i] = box[below];
        order[i] = order[below];
        box[below] = b;
        order[below] = cell;
        below += sum < twice;
    }
    return below;
}

enum { MOST_PLANES = 24 };

/* Divide the cells of n; returns the first one of the second part. While a part is less than a
 * quarter, the plane moves to the middle of what is left of the other one's half. */
static uint32_t split_cells(fmb_mesh *m, const fmb_mesh_node *n)
{
    int axis = longest_axis(&n->box);
    uint32_t from = n->from, to = n->to, quarter = (to - from) / 4;
    double low = n->box.lower[axis], high = n->box.upper[axis];
    low = low < -FLT_MAX ? -FLT_MAX : low;
    high = high > FLT_MAX ? FLT_MAX : high;
    for (int k = 0; k < MOST_PLANES; k++) {
        double middle = (low + high) / 2;
        uint32_t half = move_lower_to_front(m, axis, (float)(2 * middle), from, to);
        if (half - n->from < quarter) {
            from = half;
            low = middle;
        } else if (n->to - half < quarter) {
            to = half;
            high = middle;
        } else {
            return half;
        }
    }
    return n->from + (n->to - n->from) / 2;
}

/* Build the subtree of node k, whose range is set. */
static void grow_node(fmb_mesh *m, size_t k)
{
    fmb_mesh_node *n = &m->node[k];
    fmb_mesh_box box = fmb_mesh_box_of_nothing();
    for (uint32_t i = n->from; i < n->to; i++)
        box = fmb_mesh_box_join(box, m->box[i]);
    n->box = box;
    if (n->to - n->from <= FMB_MESH_LEAF_CELLS)
        return;
    uint32_t half = split_cells(m, n);
    n->left = (uint32_t)m->nodes;
    m->nodes += 2;
    m->node[n->left] = (fmb_mesh_node){.from = n->from, .to = half};
    m->node[n->left + 1] = (fmb_mesh_node){.from = half, .to = n->to};
    grow_node(m, n->left);
    grow_node(m, n->left + 1);
}

void fmb_mesh_grow_tree(fmb_mesh *m)
{
    for (size_t c = 0; c < m->cells; c++) {
        m->order[c] = (uint32_t)c;
        m->box[c] = box_of_cell(m, c);
    }
    m->node[0] = (fmb_mesh_node){.from = 0, .to = (uint32_t)m->cells};
    m->nodes = 1;
    grow_node(m, 0);
}
