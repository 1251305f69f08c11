/* export.h: writing a system as MPS or CPLEX LP, which have only finite decimals and plain names.
 *
 * A row with other numbers is multiplied by their common denominator, a row whose right side would
 * be read as infinite by a power of ten; the objective cannot be scaled. A name or label that the
 * format cannot spell, or that is taken, is replaced; rows without a label get one.
 */
#ifndef FMB_IO_EXPORT_H
#define FMB_IO_EXPORT_H

#include "io/core/io_private.h"
#include "system/names.h"

/* Can the format spell this name? */
typedef bool fmb_spells_fn(const char *name);

typedef struct fmb_export {
    const fmb_system *s;
    FILE *out;
    fmb_mem mem;
    fmb_names column, row; /* unique spellings; after the rows comes that of the objective */
    mpq_t q, scale;        /* scratch */
} fmb_export;

/* fmb_export_close it, even after an error. Errors: ARG (a strict row, or an objective with numbers
 * that are no finite decimals: see fmb_format_trouble), MEMORY. */
fmb_status fmb_export_open(fmb_export *e, const fmb_system *s, fmb_spells_fn *spells, FILE *out);
void fmb_export_close(fmb_export *e);

/* e->scale = the factor by which row i is written. */
void fmb_export_scale(fmb_export *e, size_t i);
/* Write e->q times e->scale, which is a finite decimal, exactly. */
void fmb_export_print(fmb_export *e);
/* Write q, a finite decimal, exactly. */
void fmb_print_decimal(FILE *out, mpq_srcptr q);

#endif
