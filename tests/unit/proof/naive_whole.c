/* naive_whole.c: claims WHOLE by their definition, without faces; see naive.h.
 *
 * The rows allow a cone over (x, t). The corners span it if one of them lies on each of its extreme
 * rays; on an extreme ray the vanishing forms leave only a line, so all sets of that many forms are
 * tried. The effect of strict rows is tested on all sets of corners that forms cut out.
 */
#include <stdlib.h>

#include "naive.h"
#include "support/dense.h"
#include "system/system_private.h"

enum { MOST = 64 }; /* corners */

typedef struct matrix {
    mpq_t *a;
    int rows, width;
} matrix;

typedef struct stage {
    const fmb_evidence *e;
    const fmb_claim *q;
    int width;                    /* kept variables and t */
    matrix corner, row, equation; /* forms are b t - a.x; the last row is t */
    const fmb_claim *of_corner[MOST];
    bool strict[1024]; /* [row.rows] */
    bool free[MOST];   /* [corners] all forms vanish there */
} stage;

/* ---- matrices -------------------------------------------------------------------------------- */

static mpq_ptr at(const matrix *m, int i, int k)
{
    return m->a[i * m->width + k];
}

static matrix new_matrix(int rows, int width)
{
    matrix m = {malloc(((size_t)rows * (size_t)width + 1) * sizeof *m.a), rows, width};
    if (!m.a)
        abort();
    for (int i = 0; i < rows * width; i++)
        mpq_init(m.a[i]);
    return m;
}

static void free_matrix(matrix *m)
{
    for (int i = 0; i < m->rows * m->width; i++)
        mpq_clear(m->a[i]);
    free(m->a);
}

static void put_row(matrix *m, int i, const matrix *from, int k)
{
    for (int c = 0; c < m->width; c++)
        mpq_set(at(m, i, c), at(from, k, c));
}

/* To reduced echelon form; the rank. pivot[rank] are the columns. */
static int reduce_matrix(matrix *m, int *pivot)
{
    int rank = 0;
    mpq_t f, t;
    mpq_inits(f, t, NULL);
    for (int c = 0; c < m->width && rank < m->rows; c++) {
        int p = rank;
        while (p < m->rows && mpq_sgn(at(m, p, c)) == 0)
            p++;
        if (p == m->rows)
            continue;
        for (int k = 0; k < m->width; k++)
            mpq_swap(at(m, p, k), at(m, rank, k));
        mpq_inv(f, at(m, rank, c));
        for (int k = 0; k < m->width; k++)
            mpq_mul(at(m, rank, k), at(m, rank, k), f);
        for (int i = 0; i < m->rows; i++) {
            mpq_set(f, at(m, i, c));
            for (int k = 0; i != rank && k < m->width; k++) {
                mpq_mul(t, f, at(m, rank, k));
                mpq_sub(at(m, i, k), at(m, i, k), t);
            }
        }
        pivot[rank++] = c;
    }
    mpq_clears(f, t, NULL);
    return rank;
}

static int rank_of(const matrix *a, const matrix *b)
{
    matrix m = new_matrix(a->rows + (b ? b->rows : 0), a->width);
    int pivot[MOST];
    for (int i = 0; i < m.rows; i++)
        put_row(&m, i, i < a->rows ? a : b, i < a->rows ? i : i - a->rows);
    int rank = reduce_matrix(&m, pivot);
    free_matrix(&m);
    return rank;
}

static int sign_of_product(const matrix *a, int i, const matrix *b, int k)
{
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (int c = 0; c < a->width; c++) {
        mpq_mul(t, at(a, i, c), at(b, k, c));
        mpq_add(sum, sum, t);
    }
    int sign = mpq_sgn(sum);
    mpq_clears(sum, t, NULL);
    return sign;
}

/* ---- the stage ------------------------------------------------------------------------------- */

/* The place of a variable among those kept, -1: none. */
static int place_of(const fmb_claim *q, size_t var)
{
    for (size_t k = q->terms.size; k > 0; k--)
        if (q->terms.index[k - 1] == var)
            return (int)k - 1;
    return -1;
}

static bool is_row(const stage *s, const fmb_claim *c)
{
    bool kept = c->kind == FMB_CLAIM_IMPLIED;
    for (size_t k = 0; kept && k < c->terms.size; k++)
        kept = place_of(s->q, c->terms.index[k]) >= 0;
    return kept;
}

static void put_form(const stage *s, const fmb_claim *c, matrix *m, int i)
{
    for (size_t k = 0; k < c->terms.size; k++)
        mpq_neg(at(m, i, place_of(s->q, c->terms.index[k])), c->terms.value[k]);
    mpq_set(at(m, i, s->width - 1), c->value);
}

static void put_corner(stage *s, const fmb_claim *c, int i)
{
    const fmb_sparse_vector *list = c->ray.size > 0 ? &c->ray : &c->point;
    for (size_t k = 0; k < list->size; k++) {
        int place = place_of(s->q, list->index[k]);
        if (place >= 0)
            mpq_set(at(&s->corner, i, place), list->value[k]);
    }
    mpq_set_ui(at(&s->corner, i, s->width - 1), c->ray.size == 0, 1);
    s->of_corner[i] = c;
}

static stage set_stage(const fmb_evidence *e, const fmb_claim *q)
{
    stage s = {.e = e, .q = q, .width = (int)q->terms.size + 1};
    int n[3] = {0};
    for (size_t i = 0; i < e->claims; i++) {
        const fmb_claim *c = &e->claim[i];
        if (c->kind == FMB_CLAIM_CORNER)
            n[0]++;
        else if (is_row(&s, c))
            n[c->rel == FMB_EQ ? 2 : 1]++;
    }
    if (n[0] > MOST || n[1] >= 1024 || s.width >= MOST)
        abort();
    s.corner = new_matrix(n[0], s.width);
    s.row = new_matrix(n[1] + 1, s.width);
    s.equation = new_matrix(n[2], s.width);
    n[0] = n[1] = n[2] = 0;
    for (size_t i = 0; i < e->claims; i++) {
        const fmb_claim *c = &e->claim[i];
        if (c->kind == FMB_CLAIM_CORNER) {
            put_corner(&s, c, n[0]++);
        } else if (is_row(&s, c) && c->rel == FMB_EQ) {
            put_form(&s, c, &s.equation, n[2]++);
        } else if (is_row(&s, c)) {
            s.strict[n[1]] = c->rel == FMB_LT;
            put_form(&s, c, &s.row, n[1]++);
        }
    }
    s.strict[n[1]] = true;
    mpq_set_ui(at(&s.row, n[1], s.width - 1), 1, 1);
    return s;
}

/* ---- extreme rays ---------------------------------------------------------------------------- */

static bool is_negative_multiple(const matrix *m, int i, int k)
{
    matrix two = new_matrix(2, m->width);
    int pivot[2];
    put_row(&two, 0, m, i);
    put_row(&two, 1, m, k);
    bool parallel = reduce_matrix(&two, pivot) <= 1;
    free_matrix(&two);
    bool zero = sign_of_product(m, i, m, i) == 0;
    return parallel && (zero ? sign_of_product(m, k, m, k) == 0 : sign_of_product(m, i, m, k) < 0);
}

/* Which corners are free, and is their cone a linear space? *rank is its dimension. */
static bool is_linear(stage *s, int *rank)
{
    matrix f = new_matrix(s->corner.rows, s->width);
    bool linear = true;
    for (int g = 0; g < s->corner.rows; g++) {
        s->free[g] = true;
        for (int i = 0; s->free[g] && i < s->row.rows; i++)
            s->free[g] = sign_of_product(&s->row, i, &s->corner, g) == 0;
        if (s->free[g])
            put_row(&f, g, &s->corner, g);
    }
    for (int g = 0; g < s->corner.rows; g++) {
        bool opposed = !s->free[g];
        for (int k = 0; !opposed && k < s->corner.rows; k++)
            opposed = s->free[k] && is_negative_multiple(&s->corner, g, k);
        linear = linear && opposed;
    }
    *rank = rank_of(&f, NULL);
    free_matrix(&f);
    return linear;
}

/* On the space where m's rows vanish, which is one dimension more than the free part: do the rows
 * allow a vector that is not free? */
static bool has_ray(const stage *s, matrix *m)
{
    int pivot[MOST], rank = reduce_matrix(m, pivot);
    bool found = false;
    for (int c = 0, p = 0; !found && c < s->width; c++) {
        if (p < rank && pivot[p] == c) {
            p++;
            continue;
        }
        matrix y = new_matrix(1, s->width);
        mpq_set_ui(at(&y, 0, c), 1, 1);
        for (int i = 0; i < rank; i++)
            mpq_neg(at(&y, 0, pivot[i]), at(m, i, c));
        bool up = false, down = false;
        for (int i = 0; i < s->row.rows; i++) {
            int sign = sign_of_product(&s->row, i, &y, 0);
            up = up || sign > 0;
            down = down || sign < 0;
        }
        found = up != down;
        free_matrix(&y);
    }
    return found;
}

/* The chosen forms and the equations: if they leave one dimension beyond the free part, it is no
 * extreme ray, or one with a single corner on it. */
static bool is_choice_covered(const stage *s, const int *chosen, int n, int free_rank)
{
    matrix m = new_matrix(s->equation.rows + n, s->width);
    int pivot[MOST], on = 0;
    for (int i = 0; i < m.rows; i++)
        put_row(&m, i, i < n ? &s->row : &s->equation, i < n ? chosen[i] : i - n);
    bool good = true;
    if (reduce_matrix(&m, pivot) == s->width - free_rank - 1) {
        for (int g = 0; g < s->corner.rows; g++) {
            bool zero = !s->free[g];
            for (int i = 0; zero && i < n; i++)
                zero = sign_of_product(&s->row, chosen[i], &s->corner, g) == 0;
            on += zero;
        }
        good = on == 1 || (on == 0 && !has_ray(s, &m));
    }
    free_matrix(&m);
    return good;
}

static bool are_all_covered(const stage *s, int *chosen, int n, int wanted, int free_rank)
{
    if (n == wanted)
        return is_choice_covered(s, chosen, n, free_rank);
    bool good = true;
    for (int i = n > 0 ? chosen[n - 1] + 1 : 0; good && i < s->row.rows; i++) {
        chosen[n] = i;
        good = are_all_covered(s, chosen, n + 1, wanted, free_rank);
    }
    return good;
}

static bool is_spanned(stage *s)
{
    int free_rank, chosen[MOST];
    bool good = is_linear(s, &free_rank);
    int dim = s->width - rank_of(&s->equation, NULL);
    good = good && rank_of(&s->corner, NULL) == dim &&
           s->width - rank_of(&s->equation, &s->row) == free_rank && dim > free_rank;
    return good && are_all_covered(s, chosen, 0, dim - free_rank - 1, free_rank);
}

/* ---- strict rows ----------------------------------------------------------------------------- */

static bool is_inside(const stage *s, const dense *d, int i, int g)
{
    const fmb_claim *c = s->of_corner[g];
    const fmb_sparse_vector *list = c->ray.size > 0 ? &c->ray : &c->point;
    mpq_t sum, t;
    mpq_inits(sum, t, NULL);
    for (size_t k = 0; k < list->size; k++) {
        mpq_mul(t, list->value[k], dense_row(d, i)[list->index[k]]);
        mpq_add(sum, sum, t);
    }
    if (c->ray.size == 0)
        mpq_sub(sum, sum, dense_row(d, i)[d->dim]);
    int sign = mpq_sgn(sum);
    mpq_clears(sum, t, NULL);
    return sign < 0;
}

/* on: a set of corners that forms cut out; form i is the next that may cut it further. */
static bool are_faces_shown(const stage *s, const dense *d, uint64_t on, int i)
{
    bool excluded = on == 0, good = true;
    for (int k = 0; !excluded && k < s->row.rows; k++) {
        bool vanishes = s->strict[k];
        for (int g = 0; vanishes && g < s->corner.rows; g++)
            vanishes = !(on >> g & 1) || sign_of_product(&s->row, k, &s->corner, g) == 0;
        excluded = vanishes;
    }
    for (int k = 0; !excluded && good && k < d->rows; k++) {
        bool shown = d->rel[k] != FMB_LT;
        for (int g = 0; !shown && g < s->corner.rows; g++)
            shown = (on >> g & 1) && is_inside(s, d, k, g);
        good = shown;
    }
    for (; good && on != 0 && i < s->row.rows; i++) {
        uint64_t cut = 0;
        for (int g = 0; g < s->corner.rows; g++)
            if ((on >> g & 1) && sign_of_product(&s->row, i, &s->corner, g) == 0)
                cut |= (uint64_t)1 << g;
        if (cut != on)
            good = are_faces_shown(s, d, cut, i + 1);
    }
    return good;
}

bool naive_is_whole(const dense *d, const fmb_evidence *e, const fmb_claim *q)
{
    bool good = q->var == -1;
    for (size_t k = 0; k < q->terms.size; k++)
        good = good && q->terms.index[k] < (size_t)d->dim;
    if (!good)
        return false;
    stage s = set_stage(e, q);
    good = is_spanned(&s);
    uint64_t rest = 0;
    for (int g = 0; g < s.corner.rows; g++)
        rest |= (uint64_t)!s.free[g] << g;
    good = good && are_faces_shown(&s, d, rest, 0);
    free_matrix(&s.corner);
    free_matrix(&s.row);
    free_matrix(&s.equation);
    return good;
}
