/* scene.c: see scene.h. */
#include "fmb/scene.h"

#include <stdlib.h>
#include <string.h>

#include "common/file.h"
#include "common/message.h"

int scene_read_bytes(const char *path, size_t most, scene_bytes *out)
{
    FILE *in;
    size_t room = 0, more = 1;
    int code = app_file_open(path, &in);
    *out = (scene_bytes){NULL, 0};
    if (code != APP_YES)
        return code;
    while (more > 0 && out->n <= most) {
        room = out->n + out->n / 2 + 65536;
        out->p = app_need(realloc(out->p, room));
        more = fread(out->p + out->n, 1, room - out->n, in);
        out->n += more;
    }
    bool failed = ferror(in) != 0;
    app_file_close_input(in);
    if (failed)
        return app_error_at((app_place){.file = path}, APP_CANNOT_OPEN, "reading failed");
    if (out->n > most)
        return app_error_at((app_place){.file = path}, APP_BAD_INPUT,
                            "expected at most %zu bytes (--max-input)", most);
    return APP_YES;
}

void scene_write_name(FILE *obj, const char *name)
{
    fputs("o ", obj);
    for (; *name; name++)
        fputc(strchr("\n\r#\\", *name) ? '_' : *name, obj);
    fputc('\n', obj);
}
