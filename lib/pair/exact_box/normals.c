/* normals.c: see normals.h.
 *
 * In the integers of exact_box_program.h, h - M z are the points of B less those of A, over all
 * places z. On a normal they span an interval; 0 is outside of one of these, or on the border of
 * one, or inside of all. If they have an interior, as soon as one interval has a length, that tells
 * all (flat.h): 0 is apart from them, or on their border, or inside. Then and only then relative
 * interiors meet, as that of a sum is the sum of those.
 *
 * Time alone is closed: with K open, the points of the frames alone, and the drift d, 0 may lie on
 * the border of all K + t d, 0 <= t <= 1, and yet in one of them. Then a normal on which 0 is at an
 * end has one value on K, as no value on an open set is an end: K is flat. So where K has an
 * interior, the border is apart here, too.
 *
 * Doubles, off by at most FLAT_FILTER u times sizes (docs/error-bounds.md, "Any axes"), are asked
 * first. Integers have 165 bits, those of a normal 333, a sum of eight products of both 502.
 */
#include "pair/exact_box/normals.h"

#define FMB_LANES 1
#include "pair/exact_box/exact_box_program.h"
#include "pair/kernels/verdict/verdict_flat.h"

typedef struct normal_test {
    fmb_exact_box_program program;
    fmb_flat_kind kind;
    flat_pair near;
    bool apart, touches, solid; /* solid: there is an interior */
} normal_test;

/* ---- in doubles ------------------------------------------------------------------------------ */

/* The column of axis i of a side, or of the drift. */
static int column_of_axis(const normal_test *w, int side, int i)
{
    return side == 0 ? i : w->program.first_of_b + i;
}

/* Direction i from those of its columns; B's and the drift's are negative in M. */
static void near_direction(normal_test *w, int i, int column, int less)
{
    for (int j = 0; j < 3; j++) {
        double x = w->program.m[column].near[j];
        x -= less < 0 ? 0 : w->program.m[less].near[j];
        w->near.direction[i][j] = i < FMB_FLAT_MOST_EDGES ? x : -x;
    }
    w->near.size[i] = flat_size(3, w->near.direction[i]);
}

static void load_near_side(normal_test *w, int side)
{
    const fmb_flat_side *s = &w->kind.side[side];
    int base = side * FMB_FLAT_MOST_EDGES;
    for (int i = 0; i < s->naxes; i++) {
        near_direction(w, base + i, column_of_axis(w, side, i), -1);
        w->near.reach += w->near.size[base + i];
    }
    for (int i = s->naxes; i < s->edges; i++) {
        const uint8_t *ends = fmb_flat_ends(i, s->naxes);
        near_direction(w, base + i, column_of_axis(w, side, ends[1]),
                       column_of_axis(w, side, ends[0]));
    }
}

static void load_near(normal_test *w)
{
    for (int j = 0; j < 3; j++)
        w->near.shift[j] = w->program.h.near[j];
    w->near.reach = flat_size(3, w->near.shift);
    load_near_side(w, 0);
    load_near_side(w, 1);
    if (w->kind.moves) {
        near_direction(w, FMB_FLAT_DRIFT, w->program.time, -1);
        w->near.reach += w->near.size[FMB_FLAT_DRIFT];
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            w->near.direction[FMB_FLAT_WORLD + i][j] = i == j;
        w->near.size[FMB_FLAT_WORLD + i] = 1;
    }
}

/* What a normal tells in doubles; false: nothing that is certain. */
static bool ask_near(normal_test *w, int i)
{
    int dim = w->kind.dim;
    double n[3], unit = (dim == 2 ? FLAT_FILTER_PLANE : FLAT_FILTER_SPACE) * 0x1p-53;
    double error = flat_normal(dim, &w->kind, &w->near, i, n) * w->near.reach * unit;
    double gap = flat_gap(dim, &w->kind, &w->near, n);
    w->apart |= gap > error;
    w->solid |= gap < -error;
    return gap > error || gap < -error;
}

/* ---- in integers ----------------------------------------------------------------------------- */

/* Direction i, of either sign. */
static void integer_direction(const normal_test *w, int i, fmb_wide out[3])
{
    int side = i / FMB_FLAT_MOST_EDGES, edge = i % FMB_FLAT_MOST_EDGES;
    for (int j = 0; j < 3; j++) {
        if (i >= FMB_FLAT_WORLD) {
            fmb_wide_set_word(&out[j], i == FMB_FLAT_WORLD + j);
        } else if (i == FMB_FLAT_DRIFT) {
            fmb_wide_copy(&out[j], &w->program.m[w->program.time].whole[j]);
        } else if (edge < w->kind.side[side].naxes) {
            fmb_wide_copy(&out[j], &w->program.m[column_of_axis(w, side, edge)].whole[j]);
        } else {
            const uint8_t *ends = fmb_flat_ends(edge, w->kind.side[side].naxes);
            fmb_wide_copy(&out[j], &w->program.m[column_of_axis(w, side, ends[1])].whole[j]);
            fmb_wide_subtract(&out[j], &w->program.m[column_of_axis(w, side, ends[0])].whole[j]);
        }
    }
}

/* The normal number i; false: it is 0. */
static bool integer_normal(const normal_test *w, int i, fmb_wide n[3])
{
    const uint8_t *of = w->kind.normal[i];
    fmb_wide f[3], g[3];
    integer_direction(w, of[0], f);
    if (w->kind.dim == 2) {
        fmb_wide_copy(&n[0], &f[1]);
        fmb_wide_copy(&n[1], &f[0]);
        fmb_wide_negate(&n[1]);
        fmb_wide_set_word(&n[2], 0);
    } else {
        integer_direction(w, of[1], g);
        for (int j = 0; j < 3; j++) {
            int k = (j + 1) % 3, l = (j + 2) % 3;
            fmb_wide_cross(&n[j], &f[k], &g[l], &f[l], &g[k]);
        }
    }
    return n[0].n > 0 || n[1].n > 0 || n[2].n > 0;
}

static void integer_product(const fmb_wide n[3], const fmb_exact_box_vector *x, fmb_wide *out)
{
    fmb_wide_dot(out, 3, (const fmb_wide *const[]){&n[0], &n[1], &n[2]},
                 (const fmb_wide *const[]){&x->whole[0], &x->whole[1], &x->whole[2]}, 0);
}

/* n M z, its least and its greatest value over all places: those of one frame, or of the time, come
 * on top. */
typedef struct integer_span {
    fmb_wide end[2];
} integer_span;

static void add_span_of_columns(const normal_test *w, const fmb_wide n[3], int first, int columns,
                                bool simplex, integer_span *all)
{
    integer_span own;
    fmb_wide at;
    for (int side = 0; side < 2; side++)
        fmb_wide_set_word(&own.end[side], 0);
    for (int k = first; k < first + columns; k++) {
        integer_product(n, &w->program.m[k], &at);
        int side = fmb_wide_sign(&at) > 0;
        if (!simplex)
            fmb_wide_add(&own.end[side], &at);
        else if (fmb_wide_compare(&at, &own.end[side]) == (side ? 1 : -1))
            fmb_wide_copy(&own.end[side], &at);
    }
    for (int side = 0; side < 2; side++)
        fmb_wide_add(&all->end[side], &own.end[side]);
}

/* What a normal tells. */
static void ask_in_integers(normal_test *w, int i)
{
    const fmb_flat_kind *k = &w->kind;
    fmb_wide n[3], away;
    integer_span span;
    if (!integer_normal(w, i, n))
        return;
    for (int side = 0; side < 2; side++)
        fmb_wide_set_word(&span.end[side], 0);
    for (int side = 0; side < 2; side++)
        add_span_of_columns(w, n, column_of_axis(w, side, 0), k->side[side].naxes,
                            k->side[side].simplex, &span);
    if (k->moves)
        add_span_of_columns(w, n, w->program.time, 1, false, &span);
    integer_product(n, &w->program.h, &away);
    int low = fmb_wide_compare(&away, &span.end[0]), high = fmb_wide_compare(&away, &span.end[1]);
    w->apart |= low < 0 || high > 0;
    w->touches |= low == 0 || high == 0;
    w->solid |= span.end[0].n > 0 || span.end[1].n > 0;
}

/* n = a x b; false: it is 0. */
static bool cross_columns(const fmb_exact_box_vector *a, const fmb_exact_box_vector *b,
                          fmb_wide n[3])
{
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, l = (j + 2) % 3;
        fmb_wide_cross(&n[j], &a->whole[k], &b->whole[l], &a->whole[l], &b->whole[k]);
    }
    return n[0].n > 0 || n[1].n > 0 || n[2].n > 0;
}

/* Have the points of the frames alone, which do not move, an interior? The normal of two columns
 * that are not parallel is not one of all columns. */
static bool is_solid_without_drift(const normal_test *w)
{
    const fmb_exact_box_vector *m = w->program.m;
    int columns = w->program.time;
    fmb_wide n[3], product;
    bool found = false, solid = w->kind.dim == 2;
    for (int i = 0; !found && i < columns; i++)
        for (int j = i + 1; !found && j < columns; j++)
            found = cross_columns(&m[i], &m[j], n);
    for (int k = 0; found && !solid && k < columns; k++) {
        integer_product(n, &m[k], &product);
        solid = product.n > 0;
    }
    return found && solid;
}

/* ---- both ------------------------------------------------------------------------------------ */

/* All that is seen of it. */
static void clear_third_row(fmb_exact_box_program *s)
{
    for (int j = -1; j < s->columns; j++) {
        fmb_exact_box_vector *x = j < 0 ? &s->h : &s->m[j];
        fmb_wide_set_word(&x->whole[2], 0);
        x->near[2] = 0;
    }
}

static void make_kind(const normal_test *w, const fmb_frame *p, const fmb_frame *q,
                      fmb_flat_kind *out)
{
    const int naxes[2] = {p->naxes, q->naxes};
    fmb_flat_kind_of(p->dim, w->program.time >= 0, naxes, w->program.is_simplex, out);
}

bool fmb_exact_box_decide(const fmb_frame *p, const fmb_frame *q, fmb_contact contact,
                          fmb_verdict *out)
{
    normal_test w;
    if (p->dim < 2 || p->dim > 3 || !fmb_exact_box_load(&w.program, p, q))
        return false;
    if (p->dim == 2)
        clear_third_row(&w.program);
    w.apart = w.touches = w.solid = false;
    make_kind(&w, p, q, &w.kind);
    load_near(&w);
    for (int i = 0; !w.apart && i < w.kind.normals; i++)
        if (!ask_near(&w, i))
            ask_in_integers(&w, i);
    if (!w.apart && (!w.solid || (contact == FMB_CONTACT_OPEN && w.touches && w.kind.moves &&
                                  !is_solid_without_drift(&w))))
        return false;
    bool meet = !w.apart && (contact == FMB_CONTACT_CLOSED || !w.touches);
    *out = meet ? FMB_FEASIBLE : FMB_INFEASIBLE;
    return true;
}
