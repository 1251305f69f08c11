/* json.h: JSON objects that are complete or not printed at all. */
#ifndef APP_JSON_H
#define APP_JSON_H

#include <jansson.h>

/* obj[key] = value; takes over value, which may be NULL only for want of memory (then it exits). */
void app_json_set(json_t *obj, const char *key, json_t *value);
void app_json_append(json_t *array, json_t *value);
/* Any bytes as a string in valid UTF-8. */
json_t *app_json_text(const char *raw);
/* A number; null if it is not finite. */
json_t *app_json_real(double x);
/* Print {"verdict": "unknown", "stop": "bytes"}: reading the input took too much memory.
 */
void app_json_print_unread(void);
/* Print obj to standard output and release it. */
void app_json_print(json_t *obj);

#endif
