/* fuzz_text.c: the reader of .fmb files, and that of a form by itself, on any bytes. */
#include <stdlib.h>

#include "round.h"

/* What cannot be read leaves the system without an objective, and says where. */
static void read_as_form(const char *text, size_t size)
{
    fmb_system *s;
    fmb_where where = {.line = -1};
    if (fmb_system_new(3, NULL, &s) != FMB_OK)
        abort();
    fmb_status st = fmb_system_parse_objective(s, FMB_SENSE_MAX, text, size, &where);
    bool read = st == FMB_OK && fmb_system_sense(s) == FMB_SENSE_MAX;
    bool refused = st == FMB_ERR_PARSE && fmb_system_sense(s) == FMB_SENSE_NONE && where.line > 0 &&
                   where.column > 0;
    if (fmb_system_rows(s) > 0 || fmb_system_dim(s) != 3 || (!read && !refused))
        abort();
    fmb_system_free(s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_round(data, size, FMB_FORMAT_TEXT, FMB_FORMAT_TEXT);
    read_as_form(size > 0 ? (const char *)data : "", size);
    return 0;
}
