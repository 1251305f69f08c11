/* json.c: see json.h. */
#include "common/json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/message.h"
#include "common/text.h"

void app_json_set(json_t *obj, const char *key, json_t *value)
{
    if (json_object_set_new(obj, key, value) != 0)
        exit(app_status_error(FMB_ERR_MEMORY));
}

void app_json_append(json_t *array, json_t *value)
{
    if (json_array_append_new(array, value) != 0)
        exit(app_status_error(FMB_ERR_MEMORY));
}

json_t *app_json_text(const char *raw)
{
    char *text = app_text(raw, APP_TEXT_JSON);
    json_t *value = json_string(text);
    free(text);
    return value;
}

json_t *app_json_real(double x)
{
    return isfinite(x) ? json_real(x) : json_null();
}

void app_json_print(json_t *obj)
{
    if (json_dumpf(obj, stdout, JSON_INDENT(2)) != 0 && !ferror(stdout))
        exit(app_status_error(FMB_ERR_MEMORY));
    fputc('\n', stdout);
    json_decref(obj);
}

void app_json_print_unread(void)
{
    json_t *obj = app_need(json_object());
    app_json_set(obj, "verdict", json_string(fmb_verdict_text(FMB_UNKNOWN)));
    app_json_set(obj, "stop", json_string(fmb_stop_text(FMB_STOP_BYTES)));
    app_json_print(obj);
}
