/* meet.c: which cells of two meshes meet: two trees side by side, then pair by pair.
 *
 * A box that moves sweeps the box around its first and its last place, rounded outward.
 */
#include <math.h>
#include <string.h>

#include "mesh/frames.h"

typedef struct meeting {
    const fmb_mesh *a, *b;         /* the same one for self-intersections */
    const uint32_t *ids_a, *ids_b; /* equal numbers for equal points, across both */
    const fmb_mesh_options *o;
    fmb_mem *mem;
    fmb_mesh_frames frames;
    fmb_mesh_answer *out;
    double done;      /* of the pairs of cells, roughly */
    unsigned unheard; /* leaves since the last progress */
} meeting;

/* ---- boxes ----------------------------------------------------------------------------------- */

static fmb_mesh_box sweep_box(const fmb_mesh_box *b, const double *motion)
{
    fmb_mesh_box s = *b;
    for (int j = 0; motion && j < 3; j++) {
        double *end = motion[j] < 0 ? &s.lower[j] : &s.upper[j];
        if (motion[j] != 0)
            *end = nextafter(*end + motion[j], motion[j] < 0 ? -INFINITY : INFINITY);
    }
    return s;
}

static bool do_boxes_meet(const fmb_mesh_box *p, const fmb_mesh_box *q)
{
    return p->lower[0] <= q->upper[0] && q->lower[0] <= p->upper[0] && p->lower[1] <= q->upper[1] &&
           q->lower[1] <= p->upper[1] && p->lower[2] <= q->upper[2] && q->lower[2] <= p->upper[2];
}

static fmb_mesh_box box_of_cell(const fmb_cell *c)
{
    fmb_mesh_box b;
    for (int j = 0; j < 3; j++) {
        b.lower[j] = b.upper[j] = c->point[0][j];
        for (int k = 1; k < c->corners; k++) {
            double x = c->point[k][j];
            b.lower[j] = x < b.lower[j] ? x : b.lower[j];
            b.upper[j] = x > b.upper[j] ? x : b.upper[j];
        }
    }
    return b;
}

/* ---- pairs of cells -------------------------------------------------------------------------- */

static fmb_status decide_cells(meeting *x, const fmb_cell *a, const fmb_cell *b, unsigned trouble,
                               int shared, fmb_mesh_how *how)
{
    bool alike = a->corners == b->corners && !trouble && !x->o->motion;
    *how = FMB_MESH_TOUCH;
    if (alike && a->corners == 3)
        *how = fmb_decide_triangles(a, b, shared);
    else if (alike)
        *how = fmb_decide_tetrahedra(a, b, shared);
    if (alike && (a->corners == 3 || shared == 0 || *how != FMB_MESH_TOUCH))
        return FMB_OK;
    x->out->framed++;
    return fmb_mesh_decide_frames(&x->frames, a, b, trouble >> 4 != 0, shared, how);
}

static fmb_status append_hit(meeting *x, fmb_mesh_hit hit)
{
    fmb_mesh_answer *out = x->out;
    fmb_status st = fmb_mem_reserve(x->mem, (void **)&out->hit, &out->capacity, out->hits + 1,
                                    sizeof *out->hit);
    if (st == FMB_OK)
        out->hit[out->hits++] = hit;
    return st;
}

static fmb_status look_at_cells_of_leaves(meeting *x, const fmb_cell *a, uint32_t i,
                                          const fmb_cell *b, uint32_t j)
{
    fmb_mesh_how how;
    int shared = fmb_cells_count_shared(a, b);
    x->out->tested++;
    unsigned trouble = x->a->trouble[i] | (unsigned)x->b->trouble[j] << 4;
    fmb_status st = decide_cells(x, a, b, trouble, shared, &how);
    bool wanted = how != FMB_MESH_APART && (how != FMB_MESH_SHARE || x->o->neighbours);
    return st == FMB_OK && wanted ? append_hit(x, (fmb_mesh_hit){i, j, shared, how}) : st;
}

/* ---- trees ----------------------------------------------------------------------------------- */

enum { LEAVES_BETWEEN_SIGNS = 256 };

/* So much more is done. FMB_LIMIT: stop. */
static fmb_status tell_progress(meeting *x, double weight)
{
    x->done += weight;
    if (!x->o->progress || ++x->unheard < LEAVES_BETWEEN_SIGNS)
        return FMB_OK;
    x->unheard = 0;
    if (x->o->progress(x->o->self, x->done < 1 ? x->done : 1))
        return FMB_OK;
    x->out->stop = FMB_STOP_CANCELLED;
    return FMB_LIMIT;
}

/* Of one node with itself: each pair once, the smaller number first. */
static fmb_status meet_leaves(meeting *x, const fmb_mesh_node *p, const fmb_mesh_node *q)
{
    fmb_status st = FMB_OK;
    for (uint32_t i = p->from; st == FMB_OK && i < p->to; i++) {
        uint32_t c = x->a->order[i];
        fmb_cell a = fmb_mesh_cell_of(x->a, x->ids_a, c);
        fmb_mesh_box box_a = box_of_cell(&a);
        for (uint32_t j = p == q ? i + 1 : q->from; st == FMB_OK && j < q->to; j++) {
            uint32_t d = x->b->order[j];
            fmb_cell b = fmb_mesh_cell_of(x->b, x->ids_b, d);
            fmb_mesh_box box_b = box_of_cell(&b);
            box_b = sweep_box(&box_b, x->o->motion);
            bool swap = x->a == x->b && d < c;
            if (do_boxes_meet(&box_a, &box_b))
                st = swap ? look_at_cells_of_leaves(x, &b, d, &a, c)
                          : look_at_cells_of_leaves(x, &a, c, &b, d);
        }
    }
    return st;
}

/* The larger node of both gives way to its children. */
static fmb_status meet_nodes(meeting *x, const fmb_mesh_node *p, const fmb_mesh_node *q,
                             double weight)
{
    fmb_mesh_box swept = sweep_box(&q->box, x->o->motion);
    fmb_status st = FMB_OK;
    if (!do_boxes_meet(&p->box, &swept))
        return tell_progress(x, weight);
    if (!p->left && !q->left) {
        st = meet_leaves(x, p, q);
        return st == FMB_OK ? tell_progress(x, weight) : st;
    }
    bool split_p = p->left && (!q->left || p->to - p->from >= q->to - q->from);
    for (uint32_t i = 0; st == FMB_OK && i < 2; i++)
        st = split_p ? meet_nodes(x, &x->a->node[p->left + i], q, weight / 2)
                     : meet_nodes(x, p, &x->b->node[q->left + i], weight / 2);
    return st;
}

/* All pairs within one node of the only mesh. */
static fmb_status meet_within_node(meeting *x, const fmb_mesh_node *p, double weight)
{
    if (!p->left) {
        fmb_status st = meet_leaves(x, p, p);
        return st == FMB_OK ? tell_progress(x, weight) : st;
    }
    const fmb_mesh_node *child = &x->a->node[p->left];
    fmb_status st = meet_within_node(x, &child[0], weight / 4);
    if (st == FMB_OK)
        st = meet_within_node(x, &child[1], weight / 4);
    return st == FMB_OK ? meet_nodes(x, &child[0], &child[1], weight / 2) : st;
}

/* ---- the order of hits ----------------------------------------------------------------------- */

static uint32_t key_of_hit(const fmb_mesh_hit *h, bool by_a)
{
    return by_a ? h->a : h->b;
}

/* Counting sort, which keeps the order of equal keys. */
static void sort_hits_by(bool by_a, const fmb_mesh_hit *from, size_t n, size_t *start, size_t keys,
                         fmb_mesh_hit *to)
{
    memset(start, 0, (keys + 1) * sizeof *start);
    for (size_t i = 0; i < n; i++)
        start[key_of_hit(&from[i], by_a) + 1]++;
    for (size_t k = 1; k <= keys; k++)
        start[k] += start[k - 1];
    for (size_t i = 0; i < n; i++)
        to[start[key_of_hit(&from[i], by_a)]++] = from[i];
}

static fmb_status sort_hits(meeting *x)
{
    fmb_mesh_answer *out = x->out;
    size_t keys = x->a->cells > x->b->cells ? x->a->cells : x->b->cells;
    fmb_mem mem;
    fmb_mem_init(&mem, &x->mem->alloc, 0);
    fmb_mesh_hit *other = fmb_mem_get(&mem, out->hits, sizeof *other);
    size_t *start = fmb_mem_get(&mem, keys + 1, sizeof *start);
    fmb_status st = other && start ? FMB_OK : fmb_mem_status(&mem);
    if (st == FMB_OK && out->hits > 0) {
        sort_hits_by(false, out->hit, out->hits, start, keys, other);
        sort_hits_by(true, other, out->hits, start, keys, out->hit);
    }
    fmb_mem_put(&mem, other, out->hits, sizeof *other);
    fmb_mem_put(&mem, start, keys + 1, sizeof *start);
    return st;
}

/* ---- the query ------------------------------------------------------------------------------- */

static bool is_good_motion(const double *motion)
{
    return !motion || (isfinite(motion[0]) && isfinite(motion[1]) && isfinite(motion[2]));
}

static fmb_status meet_meshes(meeting *x)
{
    fmb_status st = FMB_OK;
    if (x->a->cells > 0 && x->b->cells > 0)
        st = x->a == x->b ? meet_within_node(x, x->a->node, 1)
                          : meet_nodes(x, x->a->node, x->b->node, 1);
    if (st == FMB_LIMIT && x->out->stop == FMB_STOP_DONE)
        x->out->stop = FMB_STOP_BYTES;
    return st == FMB_OK || st == FMB_LIMIT ? sort_hits(x) : st;
}

/* Numbers of b's points, as a knows them. */
static fmb_status meet_with_ids(meeting *x, fmb_mem *mem)
{
    uint32_t *ids = NULL;
    fmb_status st = FMB_OK;
    x->ids_a = x->ids_b = x->a->same;
    if (x->a != x->b) {
        if (x->a->vertices + x->b->vertices > FMB_MESH_MOST)
            return FMB_ERR_ARG;
        ids = fmb_mem_get(mem, x->b->vertices, sizeof *ids);
        st = ids ? fmb_mesh_find_same(x->b, x->a, mem, ids) : fmb_mem_status(mem);
        x->ids_b = ids;
    }
    if (st == FMB_OK)
        st = meet_meshes(x);
    fmb_mem_put(mem, ids, x->b->vertices, sizeof *ids);
    return st;
}

fmb_status fmb_mesh_meet(const fmb_mesh *a, const fmb_mesh *b, const fmb_mesh_options *o,
                         fmb_mesh_answer *out)
{
    static const fmb_mesh_options usual = {0};
    fmb_mesh_answer answer = {0};
    fmb_mem hits, work;
    o = o ? o : &usual;
    if (!a || !out || !is_good_motion(o->motion) || ((!b || b == a) && o->motion))
        return FMB_ERR_ARG;
    fmb_mem_init(&hits, o->mem, o->max_bytes);
    fmb_mem_init(&work, o->mem, 0);
    answer.mem = hits.alloc;
    meeting x = {.a = a, .b = b ? b : a, .o = o, .mem = &hits, .out = &answer};
    fmb_status st = fmb_mesh_frames_open(&x.frames, o->mem, o->motion);
    if (st == FMB_OK)
        st = meet_with_ids(&x, &work);
    fmb_mesh_frames_close(&x.frames);
    if (st == FMB_OK)
        *out = answer;
    else
        fmb_mesh_answer_clear(&answer);
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
