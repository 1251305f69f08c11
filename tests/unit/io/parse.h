/* parse.h: reading texts in tests: their meaning as .fmb text, or the place of the error. */
#ifndef FMB_TEST_PARSE_H
#define FMB_TEST_PARSE_H

#include <fmb/gmp.h>
#include <fmb/io.h>

/* A row of a table of texts and their meaning. */
typedef struct meaning {
    const char *text;
    const char *says; /* the system as fmb_system_write puts it */
} meaning;

/* A row of a table of bad texts. */
typedef struct mistake {
    const char *text;
    long line, column;
    const char *piece; /* of the message */
} mistake;

/* The system in text; fails the test if it cannot be read. */
fmb_system *parse(fmb_format f, const char *text, size_t size);
/* What is warned of while a text is read: how often, and the first four. */
typedef struct warnings {
    int n;
    fmb_where at[4];
} warnings;
warnings parse_warnings(fmb_format f, const char *text);
/* s in format f, in malloc's memory. */
char *write_text(const fmb_system *s, fmb_format f);

void check_meanings(fmb_format f, const meaning *table, size_t n);
void check_mistakes(fmb_format f, const mistake *table, size_t n);

/* Same variables (names too, if named), marks, objective, rows and (if named) labels. */
bool same_system(const fmb_system *a, const fmb_system *b, bool named);

/* All bytes of a file, in malloc's memory; NULL if it cannot be read. */
char *slurp_file(const char *path, size_t *size);

/* An allocator that fails its left-th request and all after it; live counts bytes. */
typedef struct countdown {
    size_t left, live;
} countdown;
fmb_alloc countdown_alloc(countdown *c);

/* Read text with the k-th request failing, for every k: the status is MEMORY until it is
 * `expected`, and nothing stays allocated. */
void check_every_failure(fmb_format f, const char *text, size_t size, fmb_status expected);

#endif
