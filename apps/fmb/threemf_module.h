/* threemf_module.h: what reads 3MF, for threemf_load.c alone: a module that is loaded for such a
 * file. libzip brings a library of ciphers, which took most of the time in which a small query is
 * answered.
 */
#ifndef APP_THREEMF_MODULE_H
#define APP_THREEMF_MODULE_H

#include "common/message.h"
#include "common/need.h"
#include "fmb/scene.h"

/* What the program lends: its messages and names. */
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
