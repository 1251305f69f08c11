/* tree.c: boxes over boxes: each node halves its cells at the median along the widest extent of
 * their middles. Ties are broken by number, so that the tree is the same everywhere.
 */
#include <math.h>

#include "mesh/mesh_private.h"

static fmb_mesh_box box_of_nothing(void)
{
    return (fmb_mesh_box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

static void extend_box(fmb_mesh_box *b, const double *p)
{
    for (int j = 0; j < 3; j++) {
        b->lower[j] = p[j] < b->lower[j] ? p[j] : b->lower[j];
        b->upper[j] = p[j] > b->upper[j] ? p[j] : b->upper[j];
    }
}

static void extend_box_by_cell(const fmb_mesh *m, size_t c, fmb_mesh_box *b)
{
    for (int k = 0; k < m->corners; k++)
        extend_box(b, m->point + 3 * (size_t)m->corner[c * (size_t)m->corners + (size_t)k]);
}

/* The tree while it grows. */
typedef struct grower {
    fmb_mesh *m;
    float *middle; /* [cells][3]: where cells are cut apart need not be known well */
} grower;

static bool is_before(const grower *g, int axis, uint32_t a, uint32_t b)
{
    float of_a = g->middle[3 * (size_t)a + (size_t)axis];
    float of_b = g->middle[3 * (size_t)b + (size_t)axis];
    return of_a < of_b || (of_a == of_b && a < b);
}

static void swap_cells(uint32_t *a, uint32_t *b)
{
    uint32_t t = *a;
    *a = *b;
    *b = t;
}

/* The middle one of first, centre and last. */
static uint32_t pick_pivot(const grower *g, int axis, uint32_t a, uint32_t b, uint32_t c)
{
    if (is_before(g, axis, b, a))
        swap_cells(&a, &b);
    return is_before(g, axis, c, a) ? a : is_before(g, axis, c, b) ? c : b;
}

/* Hoare's quickselect: the cells before `nth` of order[from .. to) are those that belong there. */
static void select_median(const grower *g, int axis, size_t from, size_t to, size_t nth)
{
    uint32_t *order = g->m->order;
    while (to - from > 1) {
        uint32_t pivot =
            pick_pivot(g, axis, order[from], order[from + (to - from) / 2], order[to - 1]);
        size_t i = from, j = to - 1;
        for (;;) {
            while (is_before(g, axis, order[i], pivot))
                i++;
            while (is_before(g, axis, pivot, order[j]))
                j--;
            if (i >= j)
                break;
            swap_cells(&order[i++], &order[j--]);
        }
        if (nth < i)
            to = i;
        else if (nth > j)
            from = j + 1;
        else
            return;
    }
}

static int widest_axis(const grower *g, size_t from, size_t to)
{
    fmb_mesh_box b = box_of_nothing();
    int best = 0;
    for (size_t i = from; i < to; i++) {
        const float *middle = g->middle + 3 * (size_t)g->m->order[i];
        extend_box(&b, (double[3]){middle[0], middle[1], middle[2]});
    }
    for (int j = 1; j < 3; j++)
        if (b.upper[j] - b.lower[j] > b.upper[best] - b.lower[best])
            best = j;
    return best;
}

/* Node k, which stands, and all below it. */
static void grow_node(const grower *g, size_t k)
{
    fmb_mesh *m = g->m;
    fmb_mesh_node *n = &m->node[k];
    n->box = box_of_nothing();
    if (n->to - n->from <= FMB_MESH_LEAF_CELLS) {
        n->left = 0;
        for (size_t i = n->from; i < n->to; i++)
            extend_box_by_cell(m, m->order[i], &n->box);
        return;
    }
    uint32_t half = n->from + (n->to - n->from) / 2;
    select_median(g, widest_axis(g, n->from, n->to), n->from, n->to, half);
    n->left = (uint32_t)m->nodes;
    m->nodes += 2;
    fmb_mesh_node *child = &m->node[n->left];
    child[0] = (fmb_mesh_node){.from = n->from, .to = half};
    child[1] = (fmb_mesh_node){.from = half, .to = n->to};
    for (int i = 0; i < 2; i++) {
        grow_node(g, n->left + (size_t)i);
        extend_box(&n->box, child[i].box.lower);
        extend_box(&n->box, child[i].box.upper);
    }
}

static void find_middles(const grower *g)
{
    for (size_t c = 0; c < g->m->cells; c++) {
        fmb_mesh_box b = box_of_nothing();
        extend_box_by_cell(g->m, c, &b);
        for (int j = 0; j < 3; j++)
            g->middle[3 * c + (size_t)j] = (float)(b.lower[j] / 2 + b.upper[j] / 2);
    }
}

fmb_status fmb_mesh_grow_tree(fmb_mesh *m)
{
    /* Halves of at least FMB_MESH_LEAF_CELLS / 2 + 1 cells. */
    size_t most = 2 * (m->cells / (FMB_MESH_LEAF_CELLS / 2) + 1);
    grower g = {.m = m};
    fmb_status st = FMB_OK;
    m->order = fmb_mem_get(&m->mem, m->cells, sizeof *m->order);
    m->node = fmb_mem_get(&m->mem, most, sizeof *m->node);
    m->nodes = m->node ? most : 0;
    g.middle = fmb_mem_get(&m->mem, 3 * m->cells, sizeof *g.middle);
    if (m->order && m->node && g.middle) {
        for (size_t c = 0; c < m->cells; c++)
            m->order[c] = (uint32_t)c;
        find_middles(&g);
        m->node[0] = (fmb_mesh_node){.from = 0, .to = (uint32_t)m->cells};
        m->nodes = 1;
        grow_node(&g, 0);
        m->nodes = most;
    } else {
        st = fmb_mem_status(&m->mem);
    }
    fmb_mem_put(&m->mem, g.middle, 3 * m->cells, sizeof *g.middle);
    return st;
}
