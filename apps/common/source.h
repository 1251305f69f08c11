/* source.h: the FILE every command reads its system from. */
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

/* Are some variables of what was read integer? */
bool app_source_has_integers(const fmb_system *s);

/* Is FILE an SMT-LIB script, as --format or its name tell? */
bool app_source_is_script(const app_source *src);
/* [give, fmb_script_free] Such a script; src lives as long. */
int app_source_read_script(app_source *src, fmb_script **out);

/* [give] The same of a system or a V-representation: one of both, the other is NULL. */
int app_source_read_polyhedron(const app_source *src, fmb_system **s, fmb_generators **g);
/* [give, fmb_system_free] The graph of a map over s (<fmb/lift.h>). */
int app_source_read_graph(const app_source *src, const fmb_system *s, fmb_system **out);

/* How src is read; src hears of warnings, and lives as long. */
fmb_reader app_source_reader(app_source *src);
/* [give, fmb_permutations_free] Symmetries of s, of which keep[n] are kept, from that file. */
int app_source_read_symmetries(const app_source *src, const char *file, const fmb_system *s,
                               const int *keep, int n, fmb_permutations **out);

/* What a file may hold. */
typedef enum app_kind {
    APP_KIND_UNKNOWN = 0,
    APP_KIND_SYSTEM,
    APP_KIND_FRAMES, /* pairs of frames */
    APP_KIND_MESH
} app_kind;

/* What does a file hold that could not be read? A program that reads more than systems sets it, so
 * that a message says which command a file is for; else NULL. */
extern app_kind (*app_source_kind)(const char *path);

/* The exit code for what a reader of the library returned, after a message unless it is FMB_OK. */
int app_source_outcome(fmb_status st, const char *path, const fmb_where *where);
/* The same of a reader of something else than systems. */
int app_source_outcome_of(app_kind wanted, fmb_status st, const char *path, const fmb_where *where);
/* FMB_ERR_PARSE, of a file that should have pairs of frames, and has none. */
fmb_status app_source_without_pairs(fmb_where *where);

/* The format FILE is in, as far as --format or its name tell, made one that can be written:
 * FMB_FORMAT_TEXT for all others. */
fmb_format app_source_written(const app_source *src);

/* Write s to standard output; an exit code. */
int app_source_write(const fmb_system *s, fmb_format f);

/* Words of --to, as its value and in messages. */
#define APP_FORMATS_TO "fmb|ine|smt2|mps|lp"
/* A format word of the command line that can be written (--to); false if it cannot. */
bool app_format_to(const char *word, fmb_format *out);

#endif
