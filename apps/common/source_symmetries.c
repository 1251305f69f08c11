/* source_symmetries.c: symmetries from a file; apart from source.c, as the checker knows none. */
#include "common/source.h"

#include <errno.h>

#include "common/file.h"
#include "common/message.h"

int app_source_read_symmetries(const app_source *src, const char *file, const fmb_system *s,
                               const int *keep, int n, fmb_permutations **out)
{
    FILE *in;
    int code = app_file_open(file, &in);
    if (code != APP_YES)
        return code;
    app_source self = *src;
    fmb_reader how = app_source_reader(&self);
    fmb_where where = {0};
    errno = 0;
    fmb_status st = fmb_permutations_read(in, &how, s, keep, n, out, &where);
    code = app_source_outcome(st, file, &where);
    app_file_close_input(in);
    return code;
}
