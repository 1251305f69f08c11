/* source.h: the FILE from which a command reads its system. */
#ifndef APP_SOURCE_H
#define APP_SOURCE_H

#include <argp.h>
#include <fmb/lift.h>
#include <fmb/symmetry.h>

typedef struct app_source {
    const char *file;
    fmb_format format;
    bool quiet;       /* nothing on standard error but errors */
    size_t max_input; /* longest file [bytes]; 0: FMB_READER_MAX_BYTES */
} app_source;

/* Parser of FILE, --format and --quiet, to be a child of a command's own; its input is an
 * app_source. */
extern const struct argp app_source_argp;

/* [give, fmb_system_free] Read the system: APP_YES, or an exit code after a message. Warnings go to
 * standard error. */
int app_source_read(const app_source *src, fmb_system **out);

/* Has the system integer variables? */
bool app_source_has_integers(const fmb_system *s);

/* Is FILE an SMT-LIB script, by --format or its name? */
bool app_source_is_script(const app_source *src);
/* [give, fmb_script_free] Read such a script; src must outlive it. */
int app_source_read_script(app_source *src, fmb_script **out);

/* [give] Read a system or a V-representation: the other one becomes NULL. */
int app_source_read_polyhedron(const app_source *src, fmb_system **s, fmb_generators **g);
/* [give, fmb_system_free] Read the graph of a map over s (<fmb/lift.h>). */
int app_source_read_graph(const app_source *src, const fmb_system *s, fmb_system **out);

/* The reader for src, which reports warnings through src; src must outlive it. */
fmb_reader app_source_reader(app_source *src);
/* [give, fmb_permutations_free] Read symmetries of s, of which keep[n] are kept, from that file. */
int app_source_read_symmetries(const app_source *src, const char *file, const fmb_system *s,
                               const int *keep, int n, fmb_permutations **out);

/* The kinds of contents of a file. */
typedef enum app_kind {
    APP_KIND_UNKNOWN = 0,
    APP_KIND_SYSTEM,
    APP_KIND_FRAMES, /* pairs of frames */
    APP_KIND_MESH
} app_kind;

/* Finds the kind of a file that could not be read. Set by a program that reads more than systems,
 * so that a message says which command the file is for; else NULL. */
extern app_kind (*app_source_kind)(const char *path);

/* The exit code for the status of a library reader, after a message unless it is FMB_OK. */
int app_source_outcome(fmb_status st, const char *path, const fmb_where *where);
/* Like the function above, for a reader of another kind of file. */
int app_source_outcome_of(app_kind wanted, fmb_status st, const char *path, const fmb_where *where);
/* Returns FMB_ERR_PARSE, for a file that should have pairs of frames, and has none. */
fmb_status app_source_without_pairs(fmb_where *where);

/* The format of FILE by --format or its name, if it is .ine or SMT-LIB; else FMB_FORMAT_TEXT. */
fmb_format app_source_written(const app_source *src);

/* Write s to standard output; an exit code. */
int app_source_write(const fmb_system *s, fmb_format f);

/* Words of --to, as its value and in messages. */
#define APP_FORMATS_TO "fmb|ine|smt2|mps|lp"
/* Parse the value of --to; false if the format is unknown or cannot be written. */
bool app_format_to(const char *word, fmb_format *out);

#endif
