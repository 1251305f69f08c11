/* round.c: read, write, read again, write again; see round.h. */
#include "round.h"

#include <stdlib.h>
#include <string.h>

static void demand(bool ok)
{
    if (!ok)
        abort();
}

static char *written(const fmb_system *s, fmb_format f, size_t *size)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, size);
    demand(out != NULL);
    demand(fmb_system_write(s, f, out) == FMB_OK);
    demand(fclose(out) == 0);
    return text;
}

/* The same text must come out twice: rows, names and marks have one way to be written. */
static void come_back(const fmb_system *s, fmb_format f)
{
    size_t size, again_size;
    fmb_system *back;
    char *text = written(s, f, &size);
    demand(fmb_system_parse(text, size, &(fmb_reader){.size = sizeof(fmb_reader), .format = f},
                            &back, NULL) == FMB_OK);
    demand(fmb_system_rows(back) == fmb_system_rows(s));
    demand(fmb_system_dim(back) == fmb_system_dim(s));
    char *again = written(back, f, &again_size);
    demand(again_size == size && memcmp(again, text, size) == 0);
    free(again);
    fmb_system_free(back);
    free(text);
}

/* What is told can be shown. */
static void hear(void *self, const fmb_where *where)
{
    (void)self;
    demand(where->line >= 0 && where->column >= 0 && where->text[0]);
}

void fuzz_round(const uint8_t *data, size_t size, fmb_format f, fmb_format through)
{
    fmb_system *s;
    fmb_where where = {.line = -1};
    fmb_status st = fmb_system_parse(
        (const char *)data, size,
        &(fmb_reader){.size = sizeof(fmb_reader), .format = f, .warn = hear}, &s, &where);
    demand(st == FMB_OK || st == FMB_ERR_PARSE);
    if (st == FMB_ERR_PARSE) {
        demand(where.line >= 0 && where.column >= 0 && where.text[0]);
        return;
    }
    demand(where.line == -1);
    come_back(s, through);
    fmb_system_free(s);
}
