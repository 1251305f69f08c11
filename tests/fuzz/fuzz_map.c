/* fuzz_map.c: the reader of maps on any bytes: what is read is a graph, a row for each coordinate,
 * which has just one point above each point. */
#include <stdlib.h>

#include <fmb/gmp.h>
#include <fmb/lift.h>

#include "round.h"

static const char TEXT[] = "vars: x y z\nproject: x y\nx <= y <= z\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fmb_system *s = NULL, *graph = NULL;
    fmb_where where;
    if (fmb_system_parse(TEXT, sizeof TEXT - 1, NULL, &s, NULL) != FMB_OK)
        abort();
    fmb_status st = fmb_system_parse_graph((const char *)data, size, NULL, s, &graph, &where);
    if (st != FMB_OK && (graph || where.line < 0 || where.text[0] == '\0'))
        abort();
    mpq_t q;
    mpq_init(q);
    for (size_t i = 0; i < fmb_system_rows(graph); i++) {
        size_t last = fmb_system_terms(graph, i) - 1;
        if (fmb_system_term_q(graph, i, last, q) != 2 + (int)i ||
            fmb_system_rel(graph, i) != FMB_EQ)
            abort();
    }
    if (st == FMB_OK && fmb_system_dim(graph) != 2 + (int)fmb_system_rows(graph))
        abort();
    mpq_clear(q);
    fmb_system_free(graph);
    fmb_system_free(s);
    return 0;
}
