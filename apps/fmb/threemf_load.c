/* threemf_load.c: see threemf_module.h. */
#include <dlfcn.h>

#include "common/module.h"
#include "fmb/threemf_module.h"

int scene_3mf_as_obj(const scene_file *in, FILE *obj)
{
    static const scene_host host = {app_error_at, app_need, scene_write_name};
    const scene_3mf_module *module = app_module_symbol("read-3mf", "scene_3mf");
    return module ? module->as_obj(&host, in, obj)
                  : app_error_at((app_place){.file = in->path}, APP_BAD_INPUT,
                                 "no module for 3MF: %s", dlerror());
}
