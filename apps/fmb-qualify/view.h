/* view.h: rows of a JSON object as text. */
#ifndef QUALIFY_VIEW_H
#define QUALIFY_VIEW_H

#include "fmb-qualify/page.h"

typedef struct qualify_view {
    const qualify_column *column; /* NULL ends them */
    const json_t *rows;
} qualify_view;

/* Prints the columns that have a title, aligned. */
void qualify_view_print(const qualify_view *view, FILE *out);
/* Writes one line for each row, with plain numbers: no unit, no mark; view is a qualify_view. */
void qualify_view_csv(FILE *f, const void *view);

#endif
