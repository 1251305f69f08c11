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

/* How a text describes a system; docs/formats.md tells of each. */
typedef enum fmb_format {
    FMB_FORMAT_AUTO = 0, /* reading only: by name, else by content */
    FMB_FORMAT_TEXT,     /* .fmb */
    FMB_FORMAT_INE,      /* .ine */
    FMB_FORMAT_IEQ,      /* .ieq, reading only */
    FMB_FORMAT_SMT2,     /* .smt2 */
    FMB_FORMAT_MPS,      /* .mps */
    FMB_FORMAT_LP        /* .lp */
} fmb_format;

/* The word for a format, "fmb", "ine", ..., as --format takes it and file names end; and back (also
 * "auto"): false if the word is unknown. */
FMB_API const char *fmb_format_text(fmb_format f);
FMB_API bool fmb_format_parse(const char *word, fmb_format *out);
/* Format by the ending of a file name ("a/b.ine"), FMB_FORMAT_AUTO if it says nothing or is NULL.
 */
FMB_API fmb_format fmb_format_of_name(const char *path);

/* Longest text that is read unless a reader says otherwise [bytes]. */
#define FMB_READER_MAX_BYTES ((size_t)1 << 30)

/* How to read; NULL, wherever one is expected: as by default. */
typedef struct fmb_reader {
    size_t size;          /* sizeof(fmb_reader) */
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
/* fmb_system_add_terms of numbers that are text, each meant exactly: "1/3", "0.1", "-2e3"; no
 * blanks around them. Errors: PARSE (a text is no number, or one of far more digits than it has;
 * fmb_system_trouble says which, and what was expected), ARG (as there; NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_terms_text(fmb_system *s, size_t n, const int *var,
                                                         const char *const *coef, fmb_rel rel,
                                                         const char *b);
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
/* The same to memory (<fmb/base.h>). Errors: ARG (as above; length NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_print(const fmb_system *s, fmb_format f, char *text,
                                                size_t size, size_t *length);

/* ---- SMT-LIB scripts that ask more than once ------------------------------------------------- */

/* A script with several check-sat, push, pop, reset, reset-assertions, check-sat-assuming. */
typedef struct fmb_script fmb_script;

/* What a script asks for next. */
typedef enum fmb_script_kind {
    FMB_SCRIPT_END = 0,
    FMB_SCRIPT_CHECK, /* check-sat, check-sat-using, check-sat-assuming */
    FMB_SCRIPT_MODEL, /* get-model */
    FMB_SCRIPT_VALUE, /* get-value */
    FMB_SCRIPT_CORE   /* get-unsat-core */
} fmb_script_kind;

/* [give, fmb_script_free] Read a whole stream and find its commands; how as for fmb_system_read,
 * its format does not count. Errors: PARSE (parentheses that do not match), IO, MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_script_read(FILE *in, const fmb_reader *how, fmb_script **out,
                                               fmb_where *where);
/* [give, fmb_script_free] The same from size bytes of text, which are copied. */
FMB_API FMB_CHECKED fmb_status fmb_script_parse(const char *text, size_t size,
                                                const fmb_reader *how, fmb_script **out,
                                                fmb_where *where);
FMB_API void fmb_script_free(fmb_script *s);
/* Does it ask more than a conjunction can be asked? false for NULL. */
FMB_API bool fmb_script_asks_often(const fmb_script *s);
/* [give, fmb_system_free] If not: what fmb_system_read would give. Errors: as of fmb_system_parse.
 */
FMB_API FMB_CHECKED fmb_status fmb_script_whole(fmb_script *s, fmb_system **out, fmb_where *where);
/* On to the next command that asks. Errors: PARSE (a pop without its push), MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_script_next(fmb_script *s, fmb_script_kind *out,
                                               fmb_where *where);
/* [give, fmb_system_free] What the last check asks about: the assertions that hold there, and its
 * assumptions; the row 0 <= 0 if neither a row nor a variable is left. Each call reads what has
 * come to hold since the last one; all that holds is read once more where a later command tells
 * what a Boolean unknown is that an earlier one needs, where a pop undoes such news, and after an
 * error. Errors: as of fmb_system_parse; lines and columns are the script's. */
FMB_API FMB_CHECKED fmb_status fmb_script_question(fmb_script *s, fmb_system **out,
                                                   fmb_where *where);
/* [give] Behind FMB_SCRIPT_VALUE: term i of its list, as text that belongs to s, and a system whose
 * objective it is; *text is NULL, and *out untouched, where there is none. Errors: as above, also
 * of a term that is a formula. */
FMB_API FMB_CHECKED fmb_status fmb_script_term(fmb_script *s, size_t i, const char **text,
                                               size_t *size, fmb_system **out, fmb_where *where);

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
/* The same to memory (<fmb/base.h>). Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_generators_print(const fmb_generators *g, char *text,
                                                    size_t size, size_t *length);

#ifdef __cplusplus
}
#endif
#endif
