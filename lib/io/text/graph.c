/* graph.c: maps, a line "NAME = FORM" for each coordinate, and their graphs; see fmb/lift.h.
 *
 * A form is over the variables that the system keeps (`from`), and its row over the graph, whose
 * first variables stand for these under names that no coordinate has: x = x + y is a map.
 */
#include <fmb/lift.h>

#include <string.h>

#include "io/core/stream.h"
#include "io/text/text.h"
#include "system/system_private.h"

typedef struct graph {
    fmb_text *t;
    fmb_system *from, *to;
} graph;

/* [give] The variables that s keeps, twice: to read forms, and to begin the graph. */
static fmb_status open_graph(graph *g, const fmb_system *s)
{
    FMB_TRY(fmb_system_new(0, g->t->c->how->mem, &g->from));
    FMB_TRY(fmb_system_new(0, g->t->c->how->mem, &g->to));
    for (int j = 0; j < fmb_system_dim(s); j++) {
        if (fmb_system_keeps(s, j))
            FMB_TRY(fmb_system_add_variable(g->from, fmb_system_name(s, j), NULL));
        if (fmb_system_keeps(s, j))
            FMB_TRY(fmb_system_add_variable(g->to, fmb_system_name(s, j), NULL));
    }
    return FMB_OK;
}

/* Give variable j of the graph a new name that is free. */
static fmb_status lengthen_name(fmb_system *s, int j, fmb_mem *mem)
{
    size_t n = strlen(fmb_system_name(s, j)), room = n + (size_t)fmb_system_dim(s) + 2;
    char *name;
    FMB_TRY(FMB_GET(mem, name, room));
    memcpy(name, fmb_system_name(s, j), n + 1);
    for (; fmb_system_find(s, name) >= 0; n++)
        memcpy(name + n, "'", 2);
    fmb_status st = fmb_system_set_name(s, j, name);
    fmb_mem_put(mem, name, room, 1);
    return st;
}

/* Add the coordinate with this name, read at p, as a variable of the graph. */
static fmb_status add_coordinate(graph *g, const char *p, fmb_span name, int *index)
{
    fmb_cursor *c = g->t->c;
    char found[FMB_QUOTE];
    int taken;
    FMB_TRY(fmb_span_find(c, name, g->to, &taken));
    if (taken >= fmb_system_dim(g->from))
        return fmb_io_fail(c, p, "expected a new name, found %s again", fmb_quote(c, p, found));
    if (taken >= 0)
        FMB_TRY(lengthen_name(g->to, taken, c->mem));
    return fmb_span_variable(c, name, g->to, index);
}

/* FORM = c + a.x as the row a.x - NAME = -c. */
static fmb_status append_form(graph *g, const char *start, int index)
{
    fmb_draft *d = &g->t->left;
    mpq_ptr slot;
    FMB_TRY(fmb_draft_term(d, index, &slot));
    mpq_set_si(slot, -1, 1);
    mpq_neg(d->rhs, d->rhs);
    return fmb_draft_append(g->t->c, start, d, FMB_EQ, g->to);
}

static fmb_status read_map_line(graph *g)
{
    fmb_cursor *c = g->t->c;
    const char *start = c->at;
    fmb_span name;
    int index = 0;
    fmb_status st = fmb_text_scan_name(g->t, &name);
    FMB_THEN(st, add_coordinate(g, start, name, &index));
    fmb_skip_blanks(c);
    if (st == FMB_OK && !fmb_accept(c, "="))
        st = fmb_io_expected(c, c->at, "'=' behind a name");
    FMB_THEN(st, fmb_text_expression(g->t, &g->t->left));
    fmb_skip_blanks(c);
    if (st == FMB_OK && fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#')
        st = fmb_io_expected(c, c->at, "an operator or the end of the form");
    return st == FMB_OK ? append_form(g, start, index) : st;
}

static fmb_status read_map_lines(graph *g)
{
    fmb_cursor *c = g->t->c;
    FMB_TRY(fmb_io_check(c));
    for (; c->at < c->end; fmb_next_line(c)) {
        fmb_skip_blanks(c);
        if (fmb_peek(c) >= 0 && fmb_peek(c) != '\n' && fmb_peek(c) != '#')
            FMB_TRY(read_map_line(g));
    }
    if (fmb_system_rows(g->to) == 0)
        return fmb_io_fail(c, NULL, "expected lines NAME = FORM, found none");
    return FMB_OK;
}

typedef struct map_text {
    const fmb_system *s;
    fmb_system **out;
} map_text;

static fmb_status parse_map(fmb_cursor *c, void *self)
{
    const map_text *m = self;
    fmb_text t = {.c = c, .declared = true, .alone = true};
    graph g = {.t = &t};
    fmb_draft_init(&t.left, c->mem);
    fmb_status st = open_graph(&g, m->s);
    t.s = g.from;
    FMB_THEN(st, read_map_lines(&g));
    fmb_draft_clear(&t.left);
    fmb_mem_put(c->mem, t.name.p, t.name.capacity, 1);
    fmb_system_free(g.from);
    if (st == FMB_OK)
        *m->out = g.to;
    else
        fmb_system_free(g.to);
    return st;
}

fmb_status fmb_system_parse_graph(const char *text, size_t size, const fmb_reader *how,
                                  const fmb_system *s, fmb_system **out, fmb_where *where)
{
    return s && out ? fmb_parse_memory(text, size, how, parse_map, &(map_text){s, out}, where)
                    : fmb_io_refuse_argument(where, "s or out is NULL");
}

fmb_status fmb_system_read_graph(FILE *in, const fmb_reader *how, const fmb_system *s,
                                 fmb_system **out, fmb_where *where)
{
    return s && out ? fmb_parse_stream(in, how, parse_map, &(map_text){s, out}, where)
                    : fmb_io_refuse_argument(where, "s or out is NULL");
}
