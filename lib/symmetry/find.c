/* find.c: the symmetries of a program as automorphisms of a graph; see group.h.
 *
 * The graph has a vertex for each column, row and nonzero coefficient; a coefficient has an edge to
 * its row and one to its column. Columns are coloured by whether they are kept, rows by relation
 * and right side, coefficients by value. So automorphisms of the graph are symmetries of the
 * program; nevertheless each is checked.
 *
 * Nauty allocates by malloc, and ends the program if that fails, as GMP does: the memory that it
 * may need is charged before.
 */
#include "symmetry/group.h"

#ifndef FMB_NAUTY

fmb_status fmb_symmetry_find(fmb_run *run, const fmb_program *p, const bool *keeps, fmb_group *out)
{
    (void)keeps;
    fmb_group_init(out, run->mem, (size_t)p->n, p->m);
    return FMB_OK;
}

#else

#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>

#include <traces.h>

#include "base/arrays.h"

/* Most vertices of a graph: these take milliseconds. */
#define MOST_VERTICES    8192
/* Memory of nauty for each vertex [bytes]. */
#define BYTES_PER_VERTEX 1024

/* A vertex and its colour, a pair of numbers. */
typedef struct vertex {
    int kind;
    int64_t value;
    int number;
} vertex;

enum { ELIMINATED, KEPT, COEFFICIENT, ROW };

typedef struct drawing {
    fmb_mem *mem;
    const fmb_program *p;
    size_t vertices, edges;    /* edges: counted at both ends */
    vertex *vertex;            /* [vertices] */
    size_t *first;             /* [vertices] of its ends */
    int *degree, *end;         /* [vertices], [edges] */
    int *label, *same, *orbit; /* [vertices] */
} drawing;

/* Do all numbers of the program fit into int64? */
static bool is_program_small(const fmb_program *p)
{
    if (p->terms + p->m + (size_t)p->n > MOST_VERTICES)
        return false;
    for (size_t i = 0; i < p->m; i++)
        for (size_t k = 0; p->row[i].value->z && k <= p->row[i].size; k++)
            if (!fmb_integer_is_i64(p->row[i].value->z[k]))
                return false;
    return true;
}

static int64_t entry_as_int64(const fmb_vec *v, size_t k)
{
    return v->z ? fmb_integer_get_i64(v->z[k]) : v->s[k];
}

/* ---- life ------------------------------------------------------------------------------------ */

static fmb_status hold_arrays(drawing *d, bool get)
{
    const size_t v = d->vertices;
    return FMB_ARRAYS(d->mem, get, FMB_ARRAY(d->vertex, v), FMB_ARRAY(d->first, v),
                      FMB_ARRAY(d->degree, v), FMB_ARRAY(d->end, d->edges), FMB_ARRAY(d->label, v),
                      FMB_ARRAY(d->same, v), FMB_ARRAY(d->orbit, v));
}

static fmb_status open_drawing(drawing *d, fmb_mem *mem, const fmb_program *p)
{
    *d = (drawing){.mem = mem, .p = p};
    size_t v = p->terms + p->m + (size_t)p->n, e = 4 * p->terms;
    if (!fmb_mem_charge(mem, v * BYTES_PER_VERTEX))
        return FMB_LIMIT;
    d->vertices = v;
    d->edges = e;
    return hold_arrays(d, true);
}

static void close_drawing(drawing *d)
{
    size_t v = d->vertices;
    (void)hold_arrays(d, false);
    fmb_mem_refund(d->mem, v * BYTES_PER_VERTEX);
}

/* ---- the graph: columns, rows, coefficients -------------------------------------------------- */

static void colour_vertices(drawing *d, const bool *keeps)
{
    const fmb_program *p = d->p;
    size_t n = (size_t)p->n, at = n + p->m;
    for (size_t j = 0; j < n; j++)
        d->vertex[j] = (vertex){keeps[j] ? KEPT : ELIMINATED, 0, (int)j};
    for (size_t i = 0; i < p->m; i++) {
        const fmb_program_row *r = &p->row[i];
        d->vertex[n + i] =
            (vertex){ROW + (int)r->rel, entry_as_int64(r->value, r->size), (int)(n + i)};
        for (size_t k = 0; k < r->size; k++, at++)
            d->vertex[at] = (vertex){COEFFICIENT, entry_as_int64(r->value, k), (int)at};
    }
}

/* Ends at columns come first, then those at rows, then two for each coefficient. */
static void draw_edges(drawing *d)
{
    const fmb_program *p = d->p;
    size_t n = (size_t)p->n, at = n + p->m, next = 0;
    for (size_t j = 0; j < n; j++)
        d->degree[j] = 0;
    for (size_t i = 0; i < p->m; i++)
        for (size_t k = 0; k < p->row[i].size; k++)
            d->degree[p->row[i].column[k]]++;
    for (size_t j = 0; j < n; j++) {
        d->first[j] = next;
        next += (size_t)d->degree[j];
        d->degree[j] = 0;
    }
    for (size_t i = 0; i < p->m; i++) {
        d->first[n + i] = next;
        d->degree[n + i] = (int)p->row[i].size;
        next += p->row[i].size;
    }
    for (size_t i = 0; i < p->m; i++)
        for (size_t k = 0; k < p->row[i].size; k++, at++, next += 2) {
            int column = p->row[i].column[k];
            d->end[d->first[column] + (size_t)d->degree[column]++] = (int)at;
            d->end[d->first[n + i] + k] = (int)at;
            d->first[at] = next;
            d->degree[at] = 2;
            d->end[next] = column;
            d->end[next + 1] = (int)(n + i);
        }
}

static int compare_colours(const vertex *a, const vertex *b)
{
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    return (a->value > b->value) - (a->value < b->value);
}

static int compare_vertices(const void *a, const void *b)
{
    int order = compare_colours(a, b);
    const vertex *x = a, *y = b;
    return order != 0 ? order : (x->number > y->number) - (x->number < y->number);
}

/* Sort labels by colour; same[i]: the label after label i has the same colour. */
static void label_by_colour(drawing *d)
{
    qsort(d->vertex, d->vertices, sizeof *d->vertex, compare_vertices);
    for (size_t i = 0; i < d->vertices; i++) {
        d->label[i] = d->vertex[i].number;
        d->same[i] = i + 1 < d->vertices && compare_colours(&d->vertex[i], &d->vertex[i + 1]) == 0;
    }
}

/* ---- nauty ----------------------------------------------------------------------------------- */

/* The functions of nauty, which is loaded at the first search for symmetries, and stays loaded; so
 * only programs that search need it. FMB_NAUTY is the soname of the library that these headers
 * belong to. */
static struct {
    __typeof__(&Traces) find;
    __typeof__(&ran_init) seed;
    __typeof__(&freeschreier) free_generators;
    __typeof__(&schreier_freedyn) free_schreier;
    __typeof__(&traces_freedyn) free_traces;
    bool is_here;
} loaded;

static void load_nauty(void)
{
    void *library = dlopen(FMB_NAUTY, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return;
    *(void **)&loaded.find = dlsym(library, "Traces");
    *(void **)&loaded.seed = dlsym(library, "ran_init");
    *(void **)&loaded.free_generators = dlsym(library, "freeschreier");
    *(void **)&loaded.free_schreier = dlsym(library, "schreier_freedyn");
    *(void **)&loaded.free_traces = dlsym(library, "traces_freedyn");
    loaded.is_here = loaded.find && loaded.seed && loaded.free_generators && loaded.free_schreier &&
                     loaded.free_traces;
}

static bool have_nauty(void)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, load_nauty);
    return loaded.is_here;
}

/* ---- automorphisms --------------------------------------------------------------------------- */

/* Make the ring of permutations generators of the group. */
static fmb_status take_generators(const permnode *ring, const drawing *d, const bool *keeps,
                                  fmb_group *out)
{
    size_t n = out->n, length = n + out->m;
    fmb_status st = FMB_OK;
    uint32_t *image;
    FMB_TRY(FMB_GET(d->mem, image, length));
    const permnode *g = ring;
    do {
        bool fits;
        for (size_t j = 0; j < length; j++)
            image[j] = (uint32_t)g->p[j] - (j < n ? 0 : (uint32_t)n);
        st = fmb_group_add(out, d->p, keeps, image, &fits);
        g = g->next;
    } while (st == FMB_OK && g != ring);
    fmb_mem_put(d->mem, image, length, sizeof *image);
    return st;
}

static fmb_status find_automorphisms(drawing *d, const bool *keeps, fmb_group *out)
{
    DEFAULTOPTIONS_TRACES(options);
    TracesStats stats;
    permnode *ring = NULL;
    sparsegraph graph = {.nde = d->edges,
                         .v = d->first,
                         .nv = (int)d->vertices,
                         .d = d->degree,
                         .e = d->end,
                         .vlen = d->vertices,
                         .dlen = d->vertices,
                         .elen = d->edges};
    options.defaultptn = FALSE;
    options.generators = &ring;
    loaded.seed(1); /* Traces uses random numbers: a fixed seed */
    loaded.find(&graph, d->label, d->same, d->orbit, &options, &stats, NULL);
    fmb_status st = ring ? take_generators(ring, d, keeps, out) : FMB_OK;
    loaded.free_generators(NULL, &ring);
    loaded.free_schreier();
    loaded.free_traces();
    return st;
}

fmb_status fmb_symmetry_find(fmb_run *run, const fmb_program *p, const bool *keeps, fmb_group *out)
{
    drawing d;
    fmb_group_init(out, run->mem, (size_t)p->n, p->m);
    if (!is_program_small(p) || p->terms == 0 || !have_nauty())
        return FMB_OK;
    fmb_status st = open_drawing(&d, run->mem, p);
    if (st == FMB_OK) {
        colour_vertices(&d, keeps);
        draw_edges(&d);
        label_by_colour(&d);
        st = find_automorphisms(&d, keeps, out);
    }
    close_drawing(&d);
    return st;
}

#endif
