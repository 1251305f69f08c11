/* numbers.h: numbers of studies as JSON, and table columns for them. */
#ifndef QUALIFY_NUMBERS_H
#define QUALIFY_NUMBERS_H

#include "common/json.h"
#include "study/clock/ratio.h"

static inline json_t *qualify_count_json(size_t n)
{
    return json_integer((json_int_t)n);
}

/* [give] {"ratio", "low", "high", "least", "most"} */
static inline json_t *qualify_ratio_json(study_ratio r)
{
    json_t *obj = json_object();
    app_json_set(obj, "ratio", app_json_real(r.ratio));
    app_json_set(obj, "low", app_json_real(r.low));
    app_json_set(obj, "high", app_json_real(r.high));
    app_json_set(obj, "least", app_json_real(r.least));
    app_json_set(obj, "most", app_json_real(r.most));
    return obj;
}

/* Columns of such a ratio. */
#define QUALIFY_RATIO(key, title)                                                                  \
    {key ".ratio", title, "%.3f"}, {key ".low", "low", "%.3f"},                                    \
    {                                                                                              \
        key ".high", "high", "%.3f"                                                                \
    }

#endif
