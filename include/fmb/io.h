/* fmb/io.h: systems from and to text.
 *
 * Formats (docs/formats.md describes each): .fmb text for people, cddlib/lrslib .ine, PORTA .ieq,
 * SMT-LIB 2 conjunctions of linear constraints, MPS and CPLEX LP. Numbers
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
    FMB_FORMAT_MPS,      /* .mps */
    FMB_FORMAT_LP        /* .lp */
} fmb_format;

/* "fmb", "ine", ... of a format; and back (also "auto"): false if the word is unknown. */
FMB_API const char *fmb_format_text(fmb_format f);
FMB_API bool fmb_format_parse(const char *word, fmb_format *out);
/* Format by the ending of a file name ("a/b.ine"), FMB_FORMAT_AUTO if it says nothing or is NULL.
 */
FMB_API fmb_format fmb_format_of_name(const char *path);

/* Longest text that is read unless a reader says otherwise [bytes]. */
#define FMB_READER_MAX_BYTES ((size_t)1 << 30)

/* How to read. Zero-initialise for defaults. */
typedef struct fmb_reader {
    fmb_format format;    /* AUTO: guess from the content */
    const fmb_alloc *mem; /* NULL: malloc */
    /* Called for each thing that is ignored (a second objective); may be NULL. */
    void (*warn)(void *self, const fmb_where *where);
    void *self;
    bool nearest; /* of frames alone: a number means the double nearest to it */
    /* Longest text, of frames: longest line [bytes]; 0: FMB_READER_MAX_BYTES. */
    size_t max_bytes;
} fmb_reader;

/* [give] Parse a whole stream. A text without any row or variable is no system. Errors: PARSE
 * (malformed, empty, or longer than max_bytes), IO, MEMORY, ARG (a pointer that must not be NULL,
 * no such format). After PARSE and ARG *where is filled, if not NULL: which argument is wrong, with
 * line 0. */
FMB_API FMB_CHECKED fmb_status fmb_system_read(FILE *in, const fmb_reader *how, fmb_system **out,
                                               fmb_where *where);
/* [give] The same from size bytes of text (need not end in NUL). */
FMB_API FMB_CHECKED fmb_status fmb_system_parse(const char *text, size_t size,
                                                const fmb_reader *how, fmb_system **out,
                                                fmb_where *where);
/* Give s the objective that `size` bytes of text spell in the way of .fmb files, over the variables
 * that there are: "3x + 1/2 (y - 4)". Errors: PARSE (malformed, no such variable; *where is filled,
 * if not NULL), ARG (a pointer that must not be NULL, no such sense), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_parse_objective(fmb_system *s, fmb_sense sense,
                                                          const char *text, size_t size,
                                                          fmb_where *where);

/* Write s so that reading it back gives the same rows in the same order; in MPS and LP, which know
 * decimals only, times a number where a row has others, and with names that these can spell.
 * Errors: ARG (format cannot be written; of MPS and LP: a strict row, no variable, an objective
 * whose numbers are no finite decimals, in MPS neither a row nor an objective), IO, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_write(const fmb_system *s, fmb_format f, FILE *out);

typedef struct fmb_generators fmb_generators; /* <fmb/generators.h> */

/* [give] The same of generators (<fmb/generators.h>): a V-representation of cddlib and lrslib
 * (.ext), whatever how->format says; rows of its linearity line are lines. Errors: as above. */
FMB_API FMB_CHECKED fmb_status fmb_generators_read(FILE *in, const fmb_reader *how,
                                                   fmb_generators **out, fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_generators_parse(const char *text, size_t size,
                                                    const fmb_reader *how, fmb_generators **out,
                                                    fmb_where *where);
/* Write g so that reading it back gives the same. Errors: ARG, IO. */
FMB_API FMB_CHECKED fmb_status fmb_generators_write(const fmb_generators *g, FILE *out);

#ifdef __cplusplus
}
#endif
#endif
