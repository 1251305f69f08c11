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

/* How a text describes a system; docs/formats.md describes each format. */
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
/* Format by the ending of a file name ("a/b.ine"), FMB_FORMAT_AUTO if that is unknown or path is
 * NULL. */
FMB_API fmb_format fmb_format_of_name(const char *path);

/* The default of fmb_reader.max_bytes, the longest text that is read [bytes]. */
#define FMB_READER_MAX_BYTES ((size_t)1 << 30)

/* How to read; NULL, wherever one is expected: as by default. */
typedef struct fmb_reader {
    size_t size;          /* sizeof(fmb_reader) */
    fmb_format format;    /* AUTO: guess from the content */
    const fmb_alloc *mem; /* NULL: malloc */
    /* Called for each thing that is ignored (a second objective); may be NULL. */
    void (*warn)(void *self, const fmb_where *where);
    void *self;
    bool nearest; /* for frames only: a number means the double nearest to it */
    /* Longest text, of frames: longest line [bytes]; 0: FMB_READER_MAX_BYTES. */
    size_t max_bytes;
} fmb_reader;

/* [give] Parse a whole stream. A text without any row or variable is no system. Errors: PARSE
 * (malformed, empty, or longer than max_bytes), IO, MEMORY, ARG (a pointer that must not be NULL,
 * no such format). After PARSE and ARG *where is filled, if not NULL; for ARG it names the
 * argument, with line 0. */
FMB_API FMB_CHECKED fmb_status fmb_system_read(FILE *in, const fmb_reader *how, fmb_system **out,
                                               fmb_where *where);
/* [give] Parse size bytes of text (need not end in NUL). Errors: as above, without IO. */
FMB_API FMB_CHECKED fmb_status fmb_system_parse(const char *text, size_t size,
                                                const fmb_reader *how, fmb_system **out,
                                                fmb_where *where);
/* fmb_system_add_terms with numbers as text, each exact: "1/3", "0.1", "-2e3"; no blanks around
 * them. Errors: PARSE (a text is no number, or one with far more digits than the text has;
 * fmb_system_trouble says which, and what was expected), ARG (as there; NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_add_terms_text(fmb_system *s, size_t n, const int *var,
                                                         const char *const *coef, fmb_rel rel,
                                                         const char *b);
/* Give s the objective written in `size` bytes of text as in .fmb files, over the existing
 * variables: "3x + 1/2 (y - 4)". Errors: PARSE (malformed, no such variable; *where is filled, if
 * not NULL), ARG (a pointer that must not be NULL, no such sense), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_parse_objective(fmb_system *s, fmb_sense sense,
                                                          const char *text, size_t size,
                                                          fmb_where *where);

/* Write s so that reading it back gives the same rows in the same order. In MPS and LP, which have
 * only decimals, a row with other numbers is multiplied by a factor, and names that they cannot
 * spell are replaced. Errors: ARG (format cannot be written; MPS and LP: a strict row, no variable,
 * an objective whose numbers are no finite decimals; MPS: no row, no objective), IO, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_write(const fmb_system *s, fmb_format f, FILE *out);
/* Write s to memory (<fmb/base.h>). Errors: ARG (as above; length NULL), MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_system_print(const fmb_system *s, fmb_format f, char *text,
                                                size_t size, size_t *length);

/* ---- SMT-LIB scripts that ask more than once ------------------------------------------------- */

/* A script with several check-sat, push, pop, reset, reset-assertions, check-sat-assuming. */
typedef struct fmb_script fmb_script;

/* The next question of a script. */
typedef enum fmb_script_kind {
    FMB_SCRIPT_END = 0,
    FMB_SCRIPT_CHECK, /* check-sat, check-sat-using, check-sat-assuming */
    FMB_SCRIPT_MODEL, /* get-model */
    FMB_SCRIPT_VALUE, /* get-value */
    FMB_SCRIPT_CORE   /* get-unsat-core */
} fmb_script_kind;

/* [give, fmb_script_free] Read a whole stream and find its commands; how as for fmb_system_read,
 * its format is ignored. Errors: PARSE (parentheses that do not match), IO, MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_script_read(FILE *in, const fmb_reader *how, fmb_script **out,
                                               fmb_where *where);
/* [give, fmb_script_free] A script from size bytes of text, which are copied. */
FMB_API FMB_CHECKED fmb_status fmb_script_parse(const char *text, size_t size,
                                                const fmb_reader *how, fmb_script **out,
                                                fmb_where *where);
FMB_API void fmb_script_free(fmb_script *s);
/* Has the script several check-sats, or commands such as push? false for NULL. */
FMB_API bool fmb_script_asks_often(const fmb_script *s);
/* [give, fmb_system_free] If it does not: the system that fmb_system_read would give. Errors: as of
 * fmb_system_parse. */
FMB_API FMB_CHECKED fmb_status fmb_script_whole(fmb_script *s, fmb_system **out, fmb_where *where);
/* Move to the next question. Errors: PARSE (a pop without its push), MEMORY, ARG. */
FMB_API FMB_CHECKED fmb_status fmb_script_next(fmb_script *s, fmb_script_kind *out,
                                               fmb_where *where);
/* [give, fmb_system_free] The system of the last check: the assertions in force there, and its
 * assumptions; the row 0 <= 0 if there is neither a row nor a variable. Each call reads the
 * assertions that came into force since the last one; all are read again if a later command decides
 * a Boolean unknown that an earlier one needs, if a pop undoes such a decision, and after an error.
 * Errors: as of fmb_system_parse; lines and columns are those of the script. */
FMB_API FMB_CHECKED fmb_status fmb_script_question(fmb_script *s, fmb_system **out,
                                                   fmb_where *where);
/* [give] After FMB_SCRIPT_VALUE: term i of its list, as text that belongs to s, and a system whose
 * objective it is; *text is NULL, and *out untouched, if there is none. Errors: as above; also if
 * the term is a formula. */
FMB_API FMB_CHECKED fmb_status fmb_script_term(fmb_script *s, size_t i, const char **text,
                                               size_t *size, fmb_system **out, fmb_where *where);

typedef struct fmb_generators fmb_generators; /* <fmb/generators.h> */

/* [give] Read generators (<fmb/generators.h>): a V-representation of cddlib and lrslib (.ext),
 * whatever how->format says; rows of its linearity line are lines. Errors: as fmb_system_read. */
FMB_API FMB_CHECKED fmb_status fmb_generators_read(FILE *in, const fmb_reader *how,
                                                   fmb_generators **out, fmb_where *where);
FMB_API FMB_CHECKED fmb_status fmb_generators_parse(const char *text, size_t size,
                                                    const fmb_reader *how, fmb_generators **out,
                                                    fmb_where *where);
/* Write g so that reading it back gives the same generators. Errors: ARG, IO. */
FMB_API FMB_CHECKED fmb_status fmb_generators_write(const fmb_generators *g, FILE *out);
/* Write g to memory (<fmb/base.h>). Errors: ARG, MEMORY. */
FMB_API FMB_CHECKED fmb_status fmb_generators_print(const fmb_generators *g, char *text,
                                                    size_t size, size_t *length);

#ifdef __cplusplus
}
#endif
#endif
