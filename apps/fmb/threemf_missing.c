/* threemf_missing.c: in the place of threemf.c, where libzip or expat are not there. */
#include "common/message.h"
#include "fmb/scene.h"

int scene_3mf_as_obj(const scene_file *in, FILE *obj)
{
    (void)obj;
    return app_error_at((app_place){.file = in->path}, APP_BAD_INPUT,
                        "this program was built without libzip and expat, and reads no 3MF");
}
