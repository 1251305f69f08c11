/* module.c: see module.h. */
#include "common/module.h"

#include <dlfcn.h>
#include <libgen.h>
#include <stdio.h>
#include <unistd.h>

void *app_module_symbol(const char *name, const char *symbol)
{
    static const char *const PLACE[] = {"%s/%s.so", "%s/../common/%s.so",
                                        "%s/../" APP_MODULES_LIBDIR "/fmb/%s.so",
                                        "%.0s" APP_MODULES_FOLDER "/%s.so"};
    char self[4096], path[sizeof self + 256];
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    self[length > 0 ? length : 0] = '\0';
    const char *folder = dirname(self);
    void *module = NULL;
    for (size_t i = 0; !module && i < sizeof PLACE / sizeof *PLACE; i++) {
        snprintf(path, sizeof path, PLACE[i], folder, name);
        module = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
    }
    return module ? dlsym(module, symbol) : NULL;
}
