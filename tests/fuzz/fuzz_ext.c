/* fuzz_ext.c: the reader of V-representations on any bytes: what is read comes back the same from
 * what is written. */
#include <stdlib.h>
#include <string.h>

#include <fmb/generators.h>

#include "round.h"

static char *written(const fmb_generators *g, size_t *size)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, size);
    if (!out || fmb_generators_write(g, out) != FMB_OK || fclose(out) != 0)
        abort();
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fmb_generators *g = NULL, *again = NULL;
    fmb_where where;
    fmb_status st = fmb_generators_parse((const char *)data, size, NULL, &g, &where);
    if (st != FMB_OK) {
        if (g || where.line < 0 || where.text[0] == '\0')
            abort();
        return 0;
    }
    size_t size_once, size_twice;
    char *once = written(g, &size_once);
    if (fmb_generators_parse(once, size_once, NULL, &again, &where) != FMB_OK)
        abort();
    char *twice = written(again, &size_twice);
    if (size_once != size_twice || memcmp(once, twice, size_once) != 0)
        abort();
    free(once);
    free(twice);
    fmb_generators_free(g);
    fmb_generators_free(again);
    return 0;
}
