/* fmb/io.h: systems from and to text.
 *
 * Formats (docs/formats.md describes each): .fmb text for people, cddlib/lrslib .ine, PORTA .ieq,
 * SMT-LIB 2 conjunctions of linear constraints, MPS and CPLEX LP (read only, through GLPK). Numbers
 * are read exactly: decimals are rationals. Pairs of frames, a line of JSON each, are read by
 * <fmb/gmp.h>.
 */
#ifndef FMB_IO_H
#define FMB_IO_H

#include <fmb/system.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum fmb_format {
    FMB_FORMAT_AUTO = 0, /* reading only: by name, else by content */
    FMB_FORMAT_TEXT,     /* .fmb */
    FMB_FORMAT_INE,      /* .ine */
    FMB_FORMAT_IEQ,      /* .ieq, reading only */
    FMB_FORMAT_SMT2,     /* .smt2 */
    FMB_FORMAT_MPS,      /* .mps, reading only, needs GLPK */
    FMB_FORMAT_LP        /* .lp, reading only, needs GLPK */
} fmb_format;

/* "fmb", "ine", ... of a format; and back (also "auto"): false if the word is unknown. */
FMB_API const char *fmb_format_text(fmb_format f);
FMB_API bool fmb_format_parse(const char *word, fmb_format *out);
/* Format by the ending of a file name ("a/b.ine"), FMB_FORMAT_AUTO if it says nothing. */
FMB_API fmb_format fmb_format_of_name(const char *path);

/* How to read. Zero-initialise for defaults. */
typedef struct fmb_reader {
    fmb_format format;    /* AUTO: guess from the content */
    const fmb_alloc *mem; /* NULL: malloc */
    /* Called for each thing that is ignored (an objective, integrality); may be NULL. */
    void (*warn)(void *self, const fmb_where *where);
    void *self;
    bool nearest; /* of frames alone: a number means the double nearest to it */
} fmb_reader;

/* [give] Parse a whole stream. Errors: PARSE (*where is filled, if not NULL), IO, MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_system_read(FILE *in, const fmb_reader *how, fmb_system **out,
                                               fmb_where *where);
/* [give] The same from size bytes of text (need not end in NUL). */
FMB_API FMB_CHECKED fmb_status fmb_system_parse(const char *text, size_t size,
                                                const fmb_reader *how, fmb_system **out,
                                                fmb_where *where);
/* Write s so that reading it back gives the same rows in the same order. Errors: ARG (format cannot
 * be written), IO, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_write(const fmb_system *s, fmb_format f, FILE *out);

#ifdef __cplusplus
}
#endif
#endif
