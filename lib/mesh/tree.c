/* tree.c: the tree of bounding boxes: each node splits its cells at the median along the axis on
 * which their centres extend most. Ties are broken by number, so the tree is the same everywhere.
 */
#include <string.h>

#include "base/arrays.h"

#include "mesh/mesh_private.h"

/* The least and the greatest coordinates of a cell. */
static void find_ends_of_cell(const fmb_mesh *m, size_t c, double lower[3], double upper[3])
{
    const uint32_t *corner = m->corner + c * (size_t)m->corners;
    for (int j = 0; j < 3; j++) {
        lower[j] = upper[j] = m->point[3 * (size_t)corner[0] + (size_t)j];
        for (int k = 1; k < m->corners; k++) {
            double x = m->point[3 * (size_t)corner[k] + (size_t)j];
            lower[j] = x < lower[j] ? x : lower[j];
            upper[j] = x > upper[j] ? x : upper[j];
        }
    }
}

/* A cell while the tree is built: the centre of its box, in floats, as precision does not matter
 * for the split; each coordinate is an integer with the same order. */
typedef struct placed_cell {
    uint32_t middle[3], cell;
} placed_cell;

enum { SIGN_SHIFT = 31 };

/* A float as an integer of the same order: negative ones are inverted, others get the top bit. */
static uint32_t order_of_float(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits ^ (bits >> SIGN_SHIFT ? UINT32_MAX : UINT32_C(1) << SIGN_SHIFT);
}

static float float_of_order(uint32_t order)
{
    uint32_t bits = order ^ (order >> SIGN_SHIFT ? UINT32_C(1) << SIGN_SHIFT : UINT32_MAX);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The key for sorting; no two cells have the same. */
static uint64_t key_of_cell(const placed_cell *c, int axis)
{
    return (uint64_t)c->middle[axis] << 32 | c->cell;
}

static void swap_cells(placed_cell *a, placed_cell *b)
{
    placed_cell t = *a;
    *a = *b;
    *b = t;
}

/* Move the median of the three cells to *last. */
static void move_pivot_to_end(int axis, placed_cell *a, placed_cell *b, placed_cell *last)
{
    uint64_t of_a = key_of_cell(a, axis), of_b = key_of_cell(b, axis);
    uint64_t of_last = key_of_cell(last, axis);
    if ((of_a < of_b) == (of_b < of_last))
        swap_cells(b, last);
    else if ((of_b < of_a) == (of_a < of_last))
        swap_cells(a, last);
}

/* Hoare's quickselect: afterwards the least cells of list[from .. to) are before `nth`. The
 * partition (Lomuto's) has no branch on a key, as half of these would be mispredicted. */
static void select_median(placed_cell *list, int axis, size_t from, size_t to, size_t nth)
{
    while (to - from > 1) {
        placed_cell *last = &list[to - 1];
        move_pivot_to_end(axis, &list[from], &list[from + (to - from) / 2], last);
        uint64_t pivot = key_of_cell(last, axis);
        size_t below = from;
        for (size_t i = from; i < to - 1; i++) {
            placed_cell c = list[i];
            list[i] = list[below];
            list[below] = c;
            below += key_of_cell(&c, axis) < pivot;
        }
        swap_cells(&list[below], last);
        if (nth < below)
            to = below;
        else if (nth > below)
            from = below + 1;
        else
            return;
    }
}

static int widest_axis(const placed_cell *list, size_t from, size_t to)
{
    uint32_t lower[3] = {UINT32_MAX, UINT32_MAX, UINT32_MAX}, upper[3] = {0, 0, 0};
    float widest = 0;
    int best = 0;
    for (size_t i = from; i < to; i++)
        for (int j = 0; j < 3; j++) {
            uint32_t x = list[i].middle[j];
            lower[j] = x < lower[j] ? x : lower[j];
            upper[j] = x > upper[j] ? x : upper[j];
        }
    for (int j = 0; j < 3; j++) {
        float width = float_of_order(upper[j]) - float_of_order(lower[j]);
        best = width > widest ? j : best;
        widest = width > widest ? width : widest;
    }
    return best;
}

/* Copy the cells of a leaf in their present order of the list. */
static void fill_leaf(fmb_mesh *m, fmb_mesh_node *n, const placed_cell *list)
{
    double lower[3], upper[3];
    n->left = 0;
    for (size_t i = n->from; i < n->to; i++) {
        find_ends_of_cell(m, list[i].cell, lower, upper);
        m->order[i] = list[i].cell;
        m->box[i] = fmb_mesh_box_around(lower, upper);
        n->box = fmb_mesh_box_join(n->box, m->box[i]);
    }
}

/* Build the subtree of node k, whose range is set. */
static void grow_node(fmb_mesh *m, placed_cell *list, size_t k)
{
    fmb_mesh_node *n = &m->node[k];
    n->box = fmb_mesh_box_of_nothing();
    if (n->to - n->from <= FMB_MESH_LEAF_CELLS) {
        fill_leaf(m, n, list);
        return;
    }
    uint32_t half = n->from + (n->to - n->from) / 2;
    select_median(list, widest_axis(list, n->from, n->to), n->from, n->to, half);
    n->left = (uint32_t)m->nodes;
    m->nodes += 2;
    fmb_mesh_node *child = &m->node[n->left];
    child[0] = (fmb_mesh_node){.from = n->from, .to = half};
    child[1] = (fmb_mesh_node){.from = half, .to = n->to};
    for (int i = 0; i < 2; i++) {
        grow_node(m, list, n->left + (size_t)i);
        n->box = fmb_mesh_box_join(n->box, child[i].box);
    }
}

static void place_cells(const fmb_mesh *m, placed_cell *list)
{
    double lower[3], upper[3];
    for (size_t c = 0; c < m->cells; c++) {
        find_ends_of_cell(m, c, lower, upper);
        list[c].cell = (uint32_t)c;
        for (int j = 0; j < 3; j++)
            list[c].middle[j] = order_of_float((float)(lower[j] / 2 + upper[j] / 2));
    }
}

fmb_status fmb_mesh_grow_tree(fmb_mesh *m)
{
    /* Halves of at least FMB_MESH_LEAF_CELLS / 2 + 1 cells. */
    size_t most = 2 * (m->cells / (FMB_MESH_LEAF_CELLS / 2) + 1);
    placed_cell *list;
    m->nodes = most;
    FMB_TRY(FMB_ARRAYS(&m->mem, true, FMB_ARRAY(m->order, m->cells), FMB_ARRAY(m->box, m->cells),
                       FMB_ARRAY(m->node, most)));
    FMB_TRY(FMB_GET(&m->mem, list, m->cells));
    place_cells(m, list);
    m->node[0] = (fmb_mesh_node){.from = 0, .to = (uint32_t)m->cells};
    m->nodes = 1;
    grow_node(m, list, 0);
    m->nodes = most;
    fmb_mem_put(&m->mem, list, m->cells, sizeof *list);
    return FMB_OK;
}
