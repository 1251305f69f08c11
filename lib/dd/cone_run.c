/* cone_run.c: inserts the rows of a cone, one after another; see cone.h.
 *
 * Equalities come first, then rows that are not zero on some line: their cone has as many rays as
 * rows. Of the other rows the one with most negative rays comes next: the rays that it removes are
 * never combined again. Rows with few coefficients, if inserted first, give most of the shape of a
 * structured polyhedron (cuts, metrics, permutations); rows with many then cut off little.
 */
#include "dd/cone.h"

#include "base/arrays.h"
#include "dd/insert.h"
#include "num/gcd.h"

/* ---- life ------------------------------------------------------------------------------------ */

static size_t entry_count(const fmb_cone_problem *of)
{
    return of->keep ? of->keeps + of->m : of->d + 1;
}

/* Line j is the unit vector e_j: its value in a row is the row's entry j. Coordinates are written.
 */
static fmb_status write_values_of_unit_line(fmb_cone *c, fmb_vec *v, size_t j)
{
    size_t width = c->line.width;
    mpz_t *z = fmb_vec_block(width, c->run->mem);
    if (!z)
        return fmb_mem_status(c->run->mem);
    for (size_t k = 0; k < c->coords; k++)
        fmb_integer_set_i64(z[k], v->s[k]);
    for (size_t k = c->coords; k < width; k++)
        fmb_vec_get(c->of.row[k - c->coords].v, j, z[k]);
    fmb_status st = fmb_vec_set_z(v, width, z, c->run->mem);
    fmb_vec_block_free(z, width, c->run->mem);
    return st;
}

static fmb_status write_unit_line(fmb_cone *c, size_t j)
{
    size_t width = c->line.width;
    bool wide = false;
    FMB_TRY(fmb_rays_add(&c->line));
    fmb_vec *v = &c->line.v[c->line.size - 1];
    for (size_t k = 0; k < width; k++)
        v->s[k] = k < c->coords && (c->of.keep ? c->of.keep[k] : k) == j;
    for (size_t k = 0; c->of.keep && k < c->of.m; k++) {
        const fmb_vec *row = c->of.row[k].v;
        v->s[c->coords + k] = row->z ? 0 : row->s[j];
        wide |= row->z != NULL;
    }
    fmb_vec_measure(v, width);
    if (wide)
        FMB_TRY(write_values_of_unit_line(c, v, j));
    return c->of.wide_only ? fmb_vec_widen(v, width, c->run->mem) : FMB_OK;
}

static fmb_status write_unit_lines(fmb_cone *c)
{
    for (size_t j = 0; j < c->of.d; j++)
        FMB_TRY(write_unit_line(c, j));
    return FMB_OK;
}

static fmb_status hold_arrays(fmb_cone *c, bool get)
{
    const size_t m = c->of.m;
    return FMB_ARRAYS(c->run->mem, get, FMB_ARRAY(c->row_of_bit, m), FMB_ARRAY(c->left, m),
                      FMB_ARRAY_ZERO(c->negatives, m), FMB_ARRAY_ZERO(c->weight, m),
                      FMB_ARRAY_ZERO(c->at, 1));
}

fmb_status fmb_cone_init(fmb_cone *c, fmb_run *run, const fmb_cone_problem *of)
{
    fmb_mem *mem = run->mem;
    size_t width = entry_count(of), words = of->keep ? fmb_set_words(of->m) : 1;
    *c = (fmb_cone){.run = run, .of = *of, .coords = of->keep ? of->keeps : of->d};
    fmb_rays_init(&c->line, mem, width, 1);
    fmb_rays_init(&c->ray, mem, width, words > 0 ? words : 1);
    c->lefts = of->keep ? of->m : 0;
    FMB_TRY(hold_arrays(c, true));
    for (size_t i = 0; of->sparse_first && i < of->m; i++)
        for (size_t k = 0; k < of->d; k++)
            c->weight[i] += fmb_vec_sgn(of->row[i].v, k) != 0;
    for (size_t k = 0; k < c->lefts; k++)
        c->left[k] = k;
    FMB_TRY(fmb_run_open_num(run, &c->num, width, of->wide_only));
    return write_unit_lines(c);
}

void fmb_cone_clear(fmb_cone *c)
{
    if (!c->run)
        return;
    fmb_rays_clear(&c->line);
    fmb_rays_clear(&c->ray);
    if (c->at)
        fmb_insertion_clear(c->at, c->run->mem);
    (void)hold_arrays(c, false);
    c->run->stats.promotions += c->num.promotions;
    fmb_num_clear(&c->num);
    c->run = NULL;
}

/* ---- the next row to insert ------------------------------------------------------------------ */

/* The line with the least nonzero value in the row of that entry; SIZE_MAX if there is none. */
static size_t find_line_meeting_row(const fmb_cone *c, size_t entry)
{
    size_t best = SIZE_MAX;
    for (size_t i = 0; i < c->line.size; i++) {
        const fmb_vec *v = &c->line.v[i];
        if (fmb_vec_sgn(v, entry) == 0)
            continue;
        bool less = best == SIZE_MAX ||
                    (!v->z && (c->line.v[best].z ||
                               fmb_abs64(v->s[entry]) < fmb_abs64(c->line.v[best].s[entry])));
        best = less ? i : best;
    }
    return best;
}

/* The lightest row of that kind not zero on some line, number c->left[*k]; false: there is none. */
static bool choose_row_on_line(const fmb_cone *c, bool equality, size_t *k, size_t *line)
{
    size_t least = SIZE_MAX;
    for (size_t i = 0; i < c->lefts && least > 0; i++) {
        size_t row = c->left[i];
        if (c->of.row[row].equality != equality || c->weight[row] >= least)
            continue;
        size_t met = find_line_meeting_row(c, c->coords + i);
        if (met == SIZE_MAX)
            continue;
        least = c->weight[row];
        *k = i;
        *line = met;
    }
    return least < SIZE_MAX;
}

/* Choose a carried row, number c->left[*k], and a line on which it is nonzero (SIZE_MAX: none). */
static void choose_carried_row(const fmb_cone *c, size_t *k, size_t *line)
{
    size_t most = 0, least = SIZE_MAX;
    if (c->line.size > 0 &&
        (choose_row_on_line(c, true, k, line) || choose_row_on_line(c, false, k, line)))
        return;
    *line = SIZE_MAX;
    *k = 0;
    for (size_t i = 0; i < c->lefts; i++) {
        size_t weight = c->weight[c->left[i]], negatives = c->negatives[i];
        if (negatives > 0 && (weight < least || (weight == least && negatives > most))) {
            least = weight;
            most = negatives;
            *k = i;
        }
    }
}

/* After the row at entry coords + k is inserted: remove its values. */
static fmb_status drop_carried_row(fmb_cone *c, size_t k)
{
    c->lefts--;
    c->left[k] = c->left[c->lefts];
    c->negatives[k] = c->negatives[c->lefts];
    fmb_status line = fmb_rays_drop_entry(&c->line, c->coords + k);
    fmb_status ray = fmb_rays_drop_entry(&c->ray, c->coords + k);
    return line != FMB_OK ? line : ray;
}

/* ---- the rows, one after another ------------------------------------------------------------- */

/* Equalities come before there are rays: one that is zero on all lines is implied. */
static fmb_status insert_row(fmb_cone *c, size_t row, size_t entry, size_t line)
{
    c->at->entry = entry;
    if (line != SIZE_MAX)
        return fmb_insertion_break_line(c, row, entry, line);
    return c->of.row[row].equality ? FMB_OK : fmb_insertion_begin(c, row, entry);
}

static fmb_status insert_next_row(fmb_cone *c)
{
    size_t k = c->next, line;
    if (c->of.keep) {
        choose_carried_row(c, &k, &line);
        return insert_row(c, c->left[k], c->coords + k, line);
    }
    c->next++;
    fmb_status st = fmb_insertion_set_values(c, c->of.row[k].v);
    line = find_line_meeting_row(c, c->coords);
    return st == FMB_OK ? insert_row(c, k, c->coords, line) : st;
}

/* Is a row in progress, or one not yet inserted? */
static bool is_cone_unfinished(const fmb_cone *c)
{
    return c->at->running || (c->of.keep ? c->lefts > 0 : c->next < c->of.m);
}

static fmb_status go_on_with_rows(fmb_cone *c, uint64_t most)
{
    if (!c->at->running)
        FMB_TRY(insert_next_row(c));
    size_t entry = c->at->entry;
    if (c->at->running)
        FMB_TRY(fmb_insertion_run(c, most));
    if (c->at->running)
        return FMB_OK;
    return c->of.keep ? drop_carried_row(c, entry - c->coords) : FMB_OK;
}

fmb_status fmb_cone_run(fmb_cone *c, uint64_t rays, bool *done)
{
    uint64_t most = rays > 0 ? c->made + rays : UINT64_MAX;
    fmb_status st = fmb_run_poll_now(c->run);
    *done = false;
    while (st == FMB_OK && is_cone_unfinished(c) && c->made < most &&
           !fmb_run_is_slice_over(c->run)) {
        st = go_on_with_rows(c, most);
        FMB_THEN(st, fmb_run_poll(c->run));
    }
    *done = st == FMB_OK && !is_cone_unfinished(c);
    return st;
}
