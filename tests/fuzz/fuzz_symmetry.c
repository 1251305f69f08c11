/* fuzz_symmetry.c: the reader of symmetries on any bytes: what is read are such, or a projection
 * that uses them would be refused. */
#include <stdlib.h>

#include <fmb/symmetry.h>

#include "round.h"

static const char TEXT[] = "vars: x y A B u v w\nx + y + u <= 3\nx - A <= 1\ny - B <= 1\n"
                           "u + v + w <= 2\nu = v\nu = w\nA + B >= u\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const int keep[4] = {0, 1, 2, 3};
    fmb_system *s = NULL, *out = NULL;
    fmb_permutations *p = NULL;
    fmb_solver *v = NULL;
    fmb_where where;
    if (fmb_system_parse(TEXT, sizeof TEXT - 1, NULL, &s, NULL) != FMB_OK)
        abort();
    fmb_status st = fmb_permutations_parse((const char *)data, size, NULL, s, keep, 4, &p, &where);
    if (st != FMB_OK && (p || where.line < 0 || where.text[0] == '\0'))
        abort();
    if (st == FMB_OK &&
        (fmb_solver_new(NULL, NULL, &v) != FMB_OK || fmb_solver_set_symmetries(v, p) != FMB_OK ||
         fmb_project(v, s, keep, 4, &out, NULL) != FMB_OK))
        abort();
    fmb_system_free(out);
    fmb_solver_free(v);
    fmb_permutations_free(p);
    fmb_system_free(s);
    return 0;
}
