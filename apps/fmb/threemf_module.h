/* threemf_module.h: the reader of 3MF, for threemf_load.c only: a module that is loaded for such a
 * file, as libzip needs a library of ciphers, whose loading would take most of the time of a small
 * query.
 */
#ifndef APP_THREEMF_MODULE_H
#define APP_THREEMF_MODULE_H

#include "common/message.h"
#include "common/need.h"
#include "fmb/scene.h"

/* Functions of the program that the module uses. */
typedef struct scene_host {
    __typeof__(&app_error_at) error_at;
    __typeof__(&app_need) need;
    __typeof__(&scene_write_name) write_name;
} scene_host;

typedef struct scene_3mf_module {
    int (*as_obj)(const scene_host *host, const scene_file *in, FILE *obj);
} scene_3mf_module;

extern const scene_3mf_module scene_3mf;

#endif
