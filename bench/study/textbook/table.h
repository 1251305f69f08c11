/* table.h: dense rational rows, and the elimination of one variable from them.
 *
 * Invariants of a tidy table: no row is always true; the first nonzero coefficient of a row is 1 or
 * -1 (1 in equalities); of inequalities with the same left side only the tightest is there, of
 * equalities only one copy. So at most one upper and one lower row remain over a single variable.
 */
#ifndef FMB_STUDY_TEXTBOOK_TABLE_H
#define FMB_STUDY_TEXTBOOK_TABLE_H

#include <fmb/gmp.h>

#include "base/mem.h"

typedef struct study_table_row {
    mpq_t *a; /* [width]: coefficients, then the right side */
    fmb_rel rel;
} study_table_row;

typedef struct study_table {
    fmb_mem *mem;
    size_t width; /* variables + 1 */
    study_table_row *row;
    size_t rows, capacity;
    size_t max_rows; /* 0 = no limit */
} study_table;

/* The rows of s, tidy. Errors: MEMORY; then nothing is held. */
fmb_status study_table_init(study_table *t, const fmb_system *s, size_t max_rows, fmb_mem *mem);
fmb_status study_table_copy(study_table *to, const study_table *from);
void study_table_clear(study_table *t);

/* Eliminate every variable that is not in keep[width - 1], and tidy up. Errors: MEMORY, LIMIT. */
fmb_status study_table_project(study_table *t, const bool *keep);

/* Is there a row without variables? In a tidy table it can only be a false one. */
bool study_table_is_false(const study_table *t);

#endif
