/* export.h: a system on its way into MPS or CPLEX LP, which know finite decimals and plain names.
 *
 * A row with other numbers is written times the common denominator of all, a row whose right side
 * would be read as infinite times a power of ten; the objective cannot be scaled. A name or label
 * that the format cannot spell, or that is taken, becomes another one; rows without a label get
 * one.
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
    fmb_names column, row; /* spellings, all different; behind the rows that of the objective */
    mpq_t q, scale;        /* scratch */
} fmb_export;

/* Errors: ARG (a strict row, or an objective that is no finite decimals: fmb_format_trouble says
 * it), MEMORY. In any case fmb_export_close it. */
fmb_status fmb_export_open(fmb_export *e, const fmb_system *s, fmb_spells_fn *spells, FILE *out);
void fmb_export_close(fmb_export *e);

/* e->scale = what row i is written times. */
void fmb_export_scale(fmb_export *e, size_t i);
/* Write e->q times e->scale, which is a finite decimal, exactly. */
void fmb_export_print(fmb_export *e);
/* The same of any finite decimal. */
void fmb_print_decimal(FILE *out, mpq_srcptr q);

#endif
