/* view.h: rows of a JSON object, to be looked at. */
#ifndef QUALIFY_VIEW_H
#define QUALIFY_VIEW_H

#include "fmb-qualify/page.h"

typedef struct qualify_view {
    const qualify_column *column; /* NULL ends them */
    const json_t *rows;
} qualify_view;

/* In aligned columns, those with a title. */
void qualify_view_print(const qualify_view *view, FILE *out);
/* One line a row, numbers as they are: no unit, no mark; view is a qualify_view. */
void qualify_view_csv(FILE *f, const void *view);

#endif
