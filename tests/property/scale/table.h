/* table.h: rows of rationals, some of which span a space, compared up to that space: those of a
 * system beside its equalities, and rays and vertices beside lines.
 */
#ifndef FMB_TEST_TABLE_H
#define FMB_TEST_TABLE_H

#include "property/scale/law.h"

/* A row of kind LAW_SPANS may be any number of times itself, and may be added to any other; all
 * others, kinds of the caller's own, are meant up to a positive factor. */
enum { LAW_SPANS = 0 };

typedef struct law_table {
    int width;
    size_t size;
    mpq_t *number; /* [size][width] */
    int *kind;     /* [size] */
} law_table;

void law_table_open(law_table *t, int width);
void law_table_close(law_table *t);
/* Append a row of that kind, 0 as yet: its numbers[width], until the next one is appended. */
mpq_t *law_table_append(law_table *t, int kind);

/* Do rows that span, span the same, and are the others the same sets beside that? Brings both into
 * a normal form. */
bool law_same_tables(law_table *a, law_table *b);

#endif
